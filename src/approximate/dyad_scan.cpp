#include "approximate/dyad_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "approximate/dyad_scan_kernel.hpp"
#include "approximate/pair_rating.hpp"
#include "approximate/real_cubic.hpp"

namespace linkwright {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct ComplexTriple {
  Point zeta, gamma, omega;
};

ComplexTriple triple_of(const std::array<double, 7>& v) { return {{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}}; }

// conj(γ) ζ ω, which is real of a dyad.
Point triple_product(const Point& gamma, const Point& zeta, const Point& omega) {
  return product(product(std::conj(gamma), zeta), omega);
}

// Im(conj(γ) ζ ω) of v + t w by powers of t.
std::array<double, 4> dyad_condition(const ComplexTriple& v, const ComplexTriple& w) {
  const auto of = [](const ComplexTriple& g, const ComplexTriple& z, const ComplexTriple& o) {
    return triple_product(g.gamma, z.zeta, o.omega).imag();
  };
  return {of(v, v, v), of(w, v, v) + of(v, w, v) + of(v, v, w), of(v, w, w) + of(w, v, w) + of(w, w, v), of(w, w, w)};
}

// Without the length of its output, which is the mean over the poses.
std::optional<CouplerLinkage> dyad_of(Point pivot, double input, double arm, const ComplexTriple& v) {
  const double size = std::norm(v.omega) * input * input;
  const double scale = triple_product(v.gamma, v.zeta, v.omega).real() / size;
  const Point z = v.zeta / (scale * input), center = -v.gamma / (scale * input);
  const double h = std::sqrt(std::norm(z));
  if (!is_finite(z) || !is_finite(center) || !(h > 0)) return std::nullopt;
  return CouplerLinkage{pivot, pivot + center, input, h, 0, arm / h * std::conj(z)};
}

CouplerLinkage moved_by(CouplerLinkage linkage, Point by) {
  linkage.a0 += by;
  linkage.b0 += by;
  return linkage;
}

// The best of a group.
struct GroupBest {
  double value = infinite;  ///< least eigenvalue
  std::optional<ScannedPair> any, clean, compact;

  // A pair that is scored; whether it has a driver takes as long, and is asked where it matters.
  void offer(ScannedPair& pair, const PairRating& rating, std::string_view drivers) {
    std::optional<ScannedPair>& driven = is_compact(pair.linkage) ? compact : clean;
    const auto better_than = [&pair](const std::optional<ScannedPair>& best) {
      return !best || pair.score < best->score;
    };
    if (!better_than(any) && !better_than(driven)) return;
    pair.driver = rating.driver(pair.linkage, drivers);
    if (better_than(any)) any = pair;
    if (pair.driver != 0 && better_than(driven)) driven = pair;
  }
};

class PivotScan {
 public:
  PivotScan(const ScaledTarget& target, std::span<const Point> chosen, std::span<const double> weights, Point pivot,
            double max_length, const PairWishes& wishes)
      : target_(target),
        chosen_(chosen),
        weights_(weights),
        pivot_(pivot),
        max_length_(max_length),
        wishes_(wishes),
        rating_(chosen, weights, pivot, target.closed) {}

  std::vector<ScannedPair> best(Simd simd) {
    if (!fill_block()) return {};
    if (wishes_.second) {
      for (std::size_t k = 0; k < dyads_.size(); ++k) offer_to_second(k);
      return listed();
    }
    dyad_scan_kernel.for_simd(simd)(block_);
    for (std::size_t k = 0; k < dyads_.size(); ++k) {
      double& least = best_of(k).value;
      least = std::min(least, block_.value[0][k]);
    }
    // Most second dyads never get computed.
    constexpr double worth = 25, rounding = 1e-12;
    for (std::size_t k = 0; k < dyads_.size(); ++k)
      if (block_.value[0][k] <= worth * best_of(k).value + rounding) offer_pairs(k);
    return listed();
  }

 private:
  [[nodiscard]] GroupBest& best_of(std::size_t k) { return best_[dyads_[k].group]; }

  // False where the pivot lies on the target: no dyad has a direction there.
  bool fill_block() {
    constexpr double nearest = 1e-9;
    dyads_ = driving_dyads(target_, chosen_, pivot_, wishes_.grid);
    best_.resize(dyads_.empty() ? 0 : dyads_.back().group + 1);
    block_.count = static_cast<int>(dyads_.size());
    block_.points = static_cast<int>(chosen_.size());
    for (std::size_t j = 0; j < chosen_.size(); ++j) {
      block_.distance[j] = rating_.distance(j);
      if (block_.distance[j] < nearest) return false;
      block_.direction[j][0] = rating_.direction(j).real();
      block_.direction[j][1] = rating_.direction(j).imag();
      block_.weight[j] = weights_[j];
    }
    for (std::size_t k = 0; k < DyadBlock::size; ++k) {
      const DrivingDyad& dyad = dyads_[std::min(k, dyads_.size() - 1)];
      block_.input[k] = dyad.input;
      block_.arm[k] = dyad.arm;
      block_.assembly[k] = dyad.right;
    }
    return true;
  }

  void offer_pairs(std::size_t k) {
    std::array<std::array<double, 7>, 2> vectors;
    for (std::size_t v = 0; v < 2; ++v)
      for (std::size_t i = 0; i < 7; ++i) vectors[v][i] = block_.vector[v][i][k];
    const DrivingDyad& dyad = dyads_[k];
    const SecondDyads seconds = second_dyads(pivot_, dyad.input, dyad.arm, vectors);
    if (seconds.count == 0) return;
    rating_.drive(dyad.input, dyad.arm, dyad.right);
    for (std::size_t c = 0; c < seconds.count; ++c) offer(k, seconds.linkages[c]);
  }

  // The second dyad at a given pivot. There no cognate has input and arm exchanged: that is another linkage.
  void offer_to_second(std::size_t k) {
    offer_to_second(k, dyads_[k].input, dyads_[k].arm);
    offer_to_second(k, dyads_[k].arm, dyads_[k].input);
  }
  void offer_to_second(std::size_t k, double input, double arm) {
    rating_.drive(input, arm, dyads_[k].right);
    std::array<LoopState, DyadBlock::most_points> driven;
    for (std::size_t j = 0; j < chosen_.size(); ++j) driven[j] = rating_.driven(j);
    const auto linkage =
        second_dyad_at(*wishes_.second - pivot_, input, arm, {driven.data(), chosen_.size()}, weights_);
    if (linkage) offer(k, moved_by(*linkage, pivot_));
  }

  void offer(std::size_t k, const CouplerLinkage& linkage) {
    ScannedPair pair{linkage, dyads_[k].right};
    rating_.score(pair);
    if (std::isfinite(pair.score) && is_built(pair.linkage)) best_of(k).offer(pair, rating_, wishes_.drivers);
  }

  [[nodiscard]] bool is_built(const CouplerLinkage& linkage) const {
    constexpr double slack = 3, shortest = 1e-6;
    const LinkLengths lengths = linkage.lengths();
    return lengths.longest() <= slack * max_length_ && lengths.shortest() >= shortest;
  }

  [[nodiscard]] std::vector<ScannedPair> listed() const {
    std::vector<ScannedPair> pairs;
    for (const GroupBest& of : best_) {
      if (of.clean) pairs.push_back(*of.clean);
      if (of.compact) pairs.push_back(*of.compact);
      if (of.any && of.any->driver == 0) pairs.push_back(*of.any);
    }
    return pairs;
  }

  const ScaledTarget& target_;
  std::span<const Point> chosen_;
  std::span<const double> weights_;
  Point pivot_;
  double max_length_;
  const PairWishes& wishes_;
  PairRating rating_;
  std::vector<DrivingDyad> dyads_;
  DyadBlock block_{};
  std::vector<GroupBest> best_;
};

}  // namespace

std::vector<LoopState> states_of(const ScannedPair& pair, std::span<const Point> chosen) {
  const CouplerLinkage& linkage = pair.linkage;
  const double arm = std::abs(linkage.p);
  PairRating rating(chosen, {}, linkage.a0, false);
  rating.drive(linkage.a, arm, pair.right);
  std::vector<LoopState> states;
  for (std::size_t j = 0; j < chosen.size(); ++j)
    states.push_back({rating.driven(j).e, product(rating.driven(j).u, std::conj(linkage.p) / arm)});
  return states;
}

SecondDyads second_dyads(Point pivot, double input, double arm, const std::array<std::array<double, 7>, 2>& vectors) {
  const ComplexTriple v = triple_of(vectors[0]), w = triple_of(vectors[1]);
  SecondDyads found;
  const auto offer = [&](double t) {
    const auto dyad = dyad_of(pivot, input, arm, {v.zeta + t * w.zeta, v.gamma + t * w.gamma, v.omega + t * w.omega});
    if (dyad) found.linkages[found.count++] = *dyad;
  };
  offer(0);
  const RealRoots roots = real_cubic_roots(dyad_condition(v, w));
  for (std::size_t k = 0; k < roots.count; ++k) offer(roots.values[k]);
  return found;
}

std::vector<ScannedPair> scan_pivot(const ScaledTarget& target, std::span<const Point> chosen,
                                    std::span<const double> weights, Point pivot, double max_length, Simd simd,
                                    const PairWishes& wishes) {
  return PivotScan(target, chosen, weights, pivot, max_length, wishes).best(simd);
}

}  // namespace linkwright
