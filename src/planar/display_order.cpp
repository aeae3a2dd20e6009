#include "linkwright/planar/display_order.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

using Knots = std::vector<std::array<double, 2>>;

/// Value at `x` of a line through knots with rising first coordinates.
double interpolated(const Knots& knots, double x) {
  const auto after = std::upper_bound(knots.begin() + 1, knots.end() - 1, x,
                                      [](double value, const std::array<double, 2>& knot) { return value < knot[0]; });
  const auto& [x0, y0] = *(after - 1);
  const auto& [x1, y1] = *after;
  return y0 + (y1 - y0) * ((x - x0) / (x1 - x0));
}

Knots exchanged(Knots knots) {
  for (auto& [x, y] : knots) std::swap(x, y);
  return knots;
}

/// The share of the axis that a branch takes, as it grows along the branch; beyond the branch's ends it goes on
/// periodically.
class BranchShare {
 public:
  BranchShare(const CurveBranch& branch, Knots share_of_tau)
      : branch_(branch), share_of_tau_(std::move(share_of_tau)), tau_of_share_(exchanged(share_of_tau_)) {}

  [[nodiscard]] double whole() const { return share_of_tau_.back()[1]; }
  [[nodiscard]] double share(double tau) const {
    const double width = branch_.to - branch_.from, turns = std::floor((tau - branch_.from) / width);
    return turns * whole() + interpolated(share_of_tau_, tau - turns * width);
  }
  [[nodiscard]] double tau(double share) const {
    const double turns = std::floor(share / whole());
    return turns * (branch_.to - branch_.from) + interpolated(tau_of_share_, share - turns * whole());
  }
  /// Coordinates strictly between two where the share bends.
  [[nodiscard]] std::vector<double> bends(double low, double high) const {
    std::vector<double> found;
    const double width = branch_.to - branch_.from;
    for (double turn = std::floor((low - branch_.from) / width); branch_.from + turn * width < high; ++turn)
      for (std::size_t i = 0; i + 1 < share_of_tau_.size(); ++i) {
        const double tau = share_of_tau_[i][0] + turn * width;
        const bool bend = share_of_tau_.size() > 2;
        if (bend && tau > low && tau < high) found.push_back(tau);
      }
    return found;
  }

 private:
  CurveBranch branch_;
  Knots share_of_tau_, tau_of_share_;
};

// Few enough to send to a page with every frame.
constexpr std::size_t max_bends = 200;

Knots thinned(const Knots& knots) {
  const std::size_t step = (knots.size() + max_bends - 1) / max_bends;
  Knots kept;
  for (std::size_t i = 0; i + 1 < knots.size(); i += step)
    if (kept.empty() || (knots[i][0] > kept.back()[0] && knots[i][1] > kept.back()[1])) kept.push_back(knots[i]);
  while (kept.size() > 1 && !(knots.back()[0] > kept.back()[0] && knots.back()[1] > kept.back()[1])) kept.pop_back();
  kept.push_back(knots.back());
  return kept;
}

std::vector<BranchShare> shares_by_length(const BurmesterCurve& curve) {
  const BurmesterCurve::ArcLengthTable run = curve.arc_length_table();
  std::vector<BranchShare> shares;
  std::size_t at = 0;
  for (const CurveBranch& branch : curve.branches()) {
    if (branch.from == branch.to) continue;
    Knots knots;
    const double before = run.length[at];
    for (; at < run.tau.size() && run.tau[at] < branch.to; ++at)
      knots.push_back({run.tau[at], (run.length[at] - before) / run.length.back()});
    knots.back()[0] = branch.to;
    shares.emplace_back(branch, thinned(knots));
  }
  return shares;
}

std::vector<BranchShare> shares_of(const BurmesterCurve& curve, Spacing spacing) {
  if (spacing == Spacing::arc_length) return shares_by_length(curve);
  std::vector<BranchShare> shares;
  for (const CurveBranch& branch : curve.branches())
    if (branch.from < branch.to)
      shares.emplace_back(branch,
                          Knots{{branch.from, 0}, {branch.to, (branch.to - branch.from) / curve.coordinate_length()}});
  return shares;
}

/// A way along a branch, from one unwrapped coordinate to another.
struct BranchPath {
  std::size_t branch = 0;
  double start = 0, end = 0;
};

std::vector<BranchPath> branch_paths(const BurmesterCurve& curve) {
  std::vector<BranchPath> paths;
  switch (curve.kind()) {
    case CubicKind::one_branch:
      paths = {{0, 0.75, 0.25}, {0, 0.75, 1.25}};
      break;
    case CubicKind::two_branches:
      paths = {{0, -0.5, 0.5}, {1, 1.5, 2.5}};
      break;
    case CubicKind::nodal:
      paths = {{0, 0.25, 0.75}, {0, 0.75, 1.25}};
      break;
    default:
      break;
  }
  const std::size_t laid = paths.empty() ? 0 : paths.back().branch + 1;
  for (std::size_t b = laid; b < curve.branches().size(); ++b) {
    const CurveBranch& branch = curve.branches()[b];
    if (branch.from < branch.to) paths.push_back({b, branch.from, branch.to});
  }
  return paths;
}

// Branches without length take no share, so indices of shares skip them.
std::size_t share_index(const BurmesterCurve& curve, std::size_t branch) {
  std::size_t index = 0;
  for (std::size_t b = 0; b < branch; ++b) index += curve.branches()[b].from < curve.branches()[b].to;
  return index;
}

double sine_between(Homogeneous a, Homogeneous b) { return norm(cross(normalized(a), normalized(b))); }

double distance(const Dyad& a, const Dyad& b, const WorkingFrame& frame) {
  return sine_between(frame.to_working(a.center), frame.to_working(b.center)) +
         sine_between(frame.to_working(a.circle), frame.to_working(b.circle));
}

double wrapped(double tau, const CurveBranch& branch) {
  return branch.from + wrap_period(tau - branch.from, branch.to - branch.from);
}

/// The ways along a curve in the order of a code, and dyads along them by which orders are compared.
class Layout {
 public:
  Layout(const BurmesterCurve& curve, Spacing spacing, const WorkingFrame& frame)
      : curve_(curve), frame_(frame), shares_(shares_of(curve, spacing)), paths_(branch_paths(curve)) {}

  [[nodiscard]] bool can_be_exchanged() const { return paths_.size() == 2; }
  void exchange() { std::swap(paths_.front(), paths_.back()); }
  [[nodiscard]] const std::vector<BranchPath>& paths() const { return paths_; }
  [[nodiscard]] const BranchShare& share(const BranchPath& path) const {
    return shares_[share_index(curve_, path.branch)];
  }

  /// Dyads evenly by place, fixed frame.
  [[nodiscard]] std::vector<Dyad> probes(const BranchPath& path) const {
    constexpr int count = 16;
    const BranchShare& share = this->share(path);
    const double first = share.share(path.start), last = share.share(path.end);
    std::vector<Dyad> found;
    for (int i = 0; i < count; ++i) {
      const double tau = share.tau(first + (last - first) * (i + 0.5) / count);
      found.push_back(frame_.to_user(curve_.dyad(wrapped(tau, curve_.branches()[path.branch]))));
    }
    return found;
  }

 private:
  const BurmesterCurve& curve_;
  const WorkingFrame& frame_;
  std::vector<BranchShare> shares_;
  std::vector<BranchPath> paths_;
};

OrderBlock block_of(const BranchPath& path, const BranchShare& share, double from) {
  const double first = share.share(path.start);
  const auto place = [&](double tau) { return from + std::abs(share.share(tau) - first); };
  OrderBlock block{path.branch, from, place(path.end), {{from, path.start}}};
  std::vector<double> bends = share.bends(std::min(path.start, path.end), std::max(path.start, path.end));
  if (path.end < path.start) std::reverse(bends.begin(), bends.end());
  for (const double tau : bends)
    if (place(tau) > block.knots.back()[0] && place(tau) < block.to) block.knots.push_back({place(tau), tau});
  block.knots.push_back({block.to, path.end});
  return block;
}

}  // namespace

DisplayOrder::DisplayOrder(const BurmesterCurve& curve, Spacing spacing, const WorkingFrame& frame, int code)
    : spacing_(spacing), frame_(frame), branches_(curve.branches()) {
  Layout layout(curve, spacing, frame);
  if (code != 0 && layout.can_be_exchanged()) {
    layout.exchange();
    code_ = 1;
  }
  double place = 0;
  for (const BranchPath& path : layout.paths()) {
    blocks_.push_back(block_of(path, layout.share(path), place));
    place = blocks_.back().to;
    probes_.push_back(layout.probes(path));
  }
  if (!blocks_.empty()) blocks_.back().to = blocks_.back().knots.back()[0] = 1;
}

DisplayOrder::DisplayOrder(std::vector<CurveBranch> branches) : branches_(std::move(branches)) {
  const double length = branches_.empty() ? 0 : branches_.back().to;
  for (std::size_t b = 0; b < branches_.size(); ++b) {
    if (branches_[b].from == branches_[b].to) continue;
    const double from = branches_[b].from / length, to = branches_[b].to / length;
    blocks_.push_back({b, from, to, {{from, branches_[b].from}, {to, branches_[b].to}}});
  }
}

DisplayOrder::DisplayOrder(std::vector<CurveBranch> branches, std::span<const double> samples)
    : branches_(std::move(branches)) {
  const double step = samples.empty() ? 1 : 1 / static_cast<double>(samples.size());
  std::size_t next = 0;
  for (std::size_t b = 0; b < branches_.size(); ++b) {
    const std::size_t first = next;
    while (next < samples.size() && (samples[next] < branches_[b].to || b + 1 == branches_.size())) ++next;
    if (next == first) continue;
    const double from = static_cast<double>(first) * step, to = static_cast<double>(next) * step;
    OrderBlock block{b, from, to, {}};
    // A sample's cell reaches half a step beyond it, or as far as the branch.
    const double width = next - first > 1 ? samples[first + 1] - samples[first] : branches_[b].to - branches_[b].from;
    block.knots.push_back({from, std::max(branches_[b].from, samples[first] - width / 2)});
    for (std::size_t i = first; i < next; ++i)
      block.knots.push_back({(static_cast<double>(i) + 0.5) * step, samples[i]});
    block.knots.push_back({to, std::min(branches_[b].to, samples[next - 1] + width / 2)});
    blocks_.push_back(std::move(block));
  }
  if (!blocks_.empty()) blocks_.back().to = blocks_.back().knots.back()[0] = 1;
}

DisplayOrder DisplayOrder::nearest(const BurmesterCurve& curve, Spacing spacing, const WorkingFrame& frame,
                                   const DisplayOrder& before) {
  DisplayOrder plain(curve, spacing, frame, 0), exchanged(curve, spacing, frame, 1);
  if (exchanged.code() == 0 || before.probes_.size() != 2) return plain;
  return plain.distance_to(before) <= exchanged.distance_to(before) ? plain : exchanged;
}

double DisplayOrder::distance_to(const DisplayOrder& before) const {
  double sum = 0;
  for (std::size_t block = 0; block < probes_.size(); ++block)
    for (std::size_t i = 0; i < probes_[block].size(); ++i)
      sum += distance(probes_[block][i], before.probes_[block][i], before.frame_);
  return sum;
}

double DisplayOrder::coordinate(double place) const {
  const double inside = std::clamp(place, 0.0, 1.0);
  auto block = std::find_if(blocks_.begin(), blocks_.end(), [&](const OrderBlock& b) { return inside < b.to; });
  if (block == blocks_.end()) --block;
  return wrapped(interpolated(block->knots, inside), branches_[block->branch]);
}

std::optional<double> DisplayOrder::place(double tau) const {
  for (const OrderBlock& block : blocks_) {
    const CurveBranch& branch = branches_[block.branch];
    // Where one branch ends the next begins.
    if (!(tau >= branch.from && (tau < branch.to || tau == branches_.back().to))) continue;
    Knots place_of_tau = exchanged(block.knots);
    if (place_of_tau.front()[0] > place_of_tau.back()[0]) std::reverse(place_of_tau.begin(), place_of_tau.end());
    const double low = place_of_tau.front()[0], width = branch.to - branch.from;
    const double unwrapped = low + wrap_period(tau - low, width);
    if (unwrapped < place_of_tau.back()[0]) return interpolated(place_of_tau, unwrapped);
  }
  return std::nullopt;
}

std::vector<double> DisplayOrder::samples(const BurmesterCurve& curve, int count) const {
  std::vector<std::array<double, 2>> placed;
  for (const double tau : curve.samples(count, spacing_)) placed.push_back({place(tau).value_or(1), tau});
  std::sort(placed.begin(), placed.end());
  std::vector<double> coordinates;
  for (const auto& [place, tau] : placed) coordinates.push_back(tau);
  return coordinates;
}

std::vector<double> DisplayOrder::samples(int count, double from, double to) const {
  std::vector<double> coordinates;
  for (int i = 0; i < count; ++i) coordinates.push_back(coordinate(from + (to - from) * (i + 0.5) / count));
  return coordinates;
}

}  // namespace linkwright
