#include "approximate/dyad_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "approximate/dyad_scan_kernel.hpp"
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
  const double h = std::abs(z);
  if (!is_finite(z) || !is_finite(center) || !(h > 0)) return std::nullopt;
  return CouplerLinkage{pivot, pivot + center, input, h, 0, arm / h * std::conj(z)};
}

// Directions of input and of its moving pivot to the point, by the law of cosines.
LoopState driven_state(Point to_point, double input, double arm, bool right) {
  const double d = std::abs(to_point), excess = (input - arm) * (input + arm);
  const double at_pivot = std::clamp((d * d + excess) / (2 * d * input), -1.0, 1.0);
  const double at_point = std::clamp((d * d - excess) / (2 * d * arm), -1.0, 1.0);
  const double up = (right ? -1 : 1) * std::sqrt(1 - at_pivot * at_pivot);
  return {product(to_point / d, {at_pivot, up}), product(to_point / d, {at_point, -input / arm * up})};
}

std::vector<LoopState> driven_states(Point pivot, double input, double arm, std::uint32_t right,
                                     std::span<const Point> chosen) {
  std::vector<LoopState> states;
  for (std::size_t j = 0; j < chosen.size(); ++j)
    states.push_back(driven_state(chosen[j] - pivot, input, arm, (right >> j & 1) != 0));
  return states;
}

// The output's length, the distance across the curve and a driver, of a second dyad at the poses of the first.
class PairRating {
 public:
  PairRating(std::span<const LoopState> driven, std::span<const double> weights, bool closed)
      : driven_(driven), weights_(weights), closed_(closed) {}

  void rate(DyadPair& pair) {
    CouplerLinkage& linkage = pair.linkage;
    const Point turn = std::conj(linkage.p) / std::abs(linkage.p);
    double square = 0, weights = 0;
    states_.clear();
    for (std::size_t j = 0; j < driven_.size(); ++j) {
      states_.push_back({driven_[j].e, product(driven_[j].u, turn)});
      square += weights_[j] * std::norm(LoopGradient(linkage, states_[j]).g);
      weights += weights_[j];
    }
    linkage.b = std::sqrt(square / weights);
    pair.score = std::sqrt(square_across(linkage) / weights);
    pair.driver = driver_of(linkage);
  }

 private:
  // The gap of the loop by the sine between the velocities that input and coupler give the point: no root is needed.
  [[nodiscard]] double square_across(const CouplerLinkage& linkage) const {
    double sum = 0;
    for (std::size_t j = 0; j < states_.size(); ++j) {
      const LoopGradient loop(linkage, states_[j]);
      const Point by_e = linkage.a * quarter_turn(states_[j].e);
      const Point by_u = quarter_turn(product(linkage.p, states_[j].u));
      const double across = loop.f * cross(by_e, by_u);
      sum += weights_[j] * across * across / (std::norm(loop.f_e * by_u - loop.f_u * by_e) + 1e-12 * loop.square());
    }
    return sum;
  }

  [[nodiscard]] char driver_of(const CouplerLinkage& linkage) const {
    const auto e = [&](std::size_t j) { return states_[j].e; };
    const auto u = [&](std::size_t j) { return states_[j].u; };
    const auto g = [&](std::size_t j) { return LoopGradient(linkage, states_[j]).g / linkage.b; };
    if (drives(e, u, g)) return 'e';
    if (drives(u, e, g)) return 'u';
    return drives(g, e, u) ? 'g' : 0;
  }

  // Turns one way, but for what an error of the points may turn it back, and the two others never are in line.
  template <class Driver, class One, class Other>
  [[nodiscard]] bool drives(const Driver& driver, const One& one, const Other& other) const {
    constexpr double slack = 0.05;  // radians
    double turned[2] = {0, 0};
    const std::size_t n = states_.size();
    const bool side = cross(one(0), other(0)) > 0;
    for (std::size_t j = 0; j < n; ++j) {
      if ((cross(one(j), other(j)) > 0) != side) return false;
      if (j + 1 == n && !closed_) break;
      const double sine = cross(driver(j), driver((j + 1) % n));
      turned[sine > 0] += std::abs(sine);
    }
    return std::min(turned[0], turned[1]) <= slack;
  }

  std::span<const LoopState> driven_;
  std::span<const double> weights_;
  bool closed_;
  std::vector<LoopState> states_;
};

// The best of a pattern.
struct PatternBest {
  double value = infinite;  ///< least eigenvalue
  std::optional<DyadPair> any, clean, compact;

  void offer(const DyadPair& pair) {
    const auto keep_better = [&pair](std::optional<DyadPair>& best) {
      if (!best || pair.score < best->score) best = pair;
    };
    keep_better(any);
    if (pair.driver != 0) keep_better(is_compact(pair.linkage) ? compact : clean);
  }
};

class PivotScan {
 public:
  PivotScan(const ScaledTarget& target, std::span<const Point> chosen, std::span<const double> weights, Point pivot,
            double max_length)
      : target_(target), chosen_(chosen), weights_(weights), pivot_(pivot), max_length_(max_length) {}

  std::vector<DyadPair> best(Simd simd) {
    if (!fill_block()) return {};
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
  [[nodiscard]] PatternBest& best_of(std::size_t k) { return best_[static_cast<std::size_t>(dyads_[k].pattern)]; }

  // False where the pivot lies on the target: no dyad has a direction there.
  bool fill_block() {
    constexpr double nearest = 1e-9;
    dyads_ = driving_dyads(target_, chosen_, pivot_);
    block_.count = static_cast<int>(dyads_.size());
    block_.points = static_cast<int>(chosen_.size());
    for (std::size_t j = 0; j < chosen_.size(); ++j) {
      const Point to = chosen_[j] - pivot_;
      block_.distance[j] = std::abs(to);
      if (block_.distance[j] < nearest) return false;
      block_.direction[j][0] = to.real() / block_.distance[j];
      block_.direction[j][1] = to.imag() / block_.distance[j];
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
    const auto driven = driven_states(pivot_, dyad.input, dyad.arm, dyad.right, chosen_);
    PairRating rating(driven, weights_, target_.closed);
    for (std::size_t c = 0; c < seconds.count; ++c) {
      DyadPair pair{seconds.linkages[c], dyad.right};
      rating.rate(pair);
      if (std::isfinite(pair.score) && is_built(pair.linkage)) best_of(k).offer(pair);
    }
  }

  [[nodiscard]] bool is_built(const CouplerLinkage& linkage) const {
    constexpr double slack = 3, shortest = 1e-6;
    const LinkLengths lengths = linkage.lengths();
    return lengths.longest() <= slack * max_length_ && lengths.shortest() >= shortest;
  }

  [[nodiscard]] std::vector<DyadPair> listed() const {
    std::vector<DyadPair> pairs;
    for (const PatternBest& of : best_) {
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
  std::vector<DrivingDyad> dyads_;
  DyadBlock block_{};
  std::array<PatternBest, elbow_pattern_count> best_;
};

}  // namespace

std::vector<LoopState> states_of(const DyadPair& pair, std::span<const Point> chosen) {
  const CouplerLinkage& linkage = pair.linkage;
  const double arm = std::abs(linkage.p);
  auto states = driven_states(linkage.a0, linkage.a, arm, pair.right, chosen);
  for (LoopState& state : states) state.u = product(state.u, std::conj(linkage.p) / arm);
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

std::vector<DyadPair> scan_pivot(const ScaledTarget& target, std::span<const Point> chosen,
                                 std::span<const double> weights, Point pivot, double max_length, Simd simd) {
  return PivotScan(target, chosen, weights, pivot, max_length).best(simd);
}

}  // namespace linkwright
