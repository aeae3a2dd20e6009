#include "curve_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

namespace linkwright {
namespace {

constexpr int first_steps = 256;     // of a branch
constexpr int max_halvings = 12;     // of a first step
constexpr double longest_step = 3;   // px
constexpr double longest_line = 60;  // px of what is seen

using Path = std::vector<Point>;  // px

/// Traces K curves that run together, by one parameter, in one window.
template <std::size_t K>
class CurveTracer {
 public:
  using Points = std::array<Homogeneous, K>;  ///< fixed frame
  using Paths = std::array<std::vector<Path>, K>;

  CurveTracer(std::function<Points(double parameter)> points, const PlaneWindow& window)
      : points_(std::move(points)), window_(window) {}

  /// A closed branch over [from, to).
  void trace(double from, double to) {
    const auto at = [&](int step) { return from + (to - from) * (step + 0.5) / first_steps; };
    from_ = from;
    to_ = to;
    Sample last = sample(at(0));
    for (int step = 1; step <= first_steps; ++step) {
      const Sample next = sample(at(step));
      connect(last, next, max_halvings);
      last = next;
    }
  }

  [[nodiscard]] Paths paths() && { return std::move(paths_); }

 private:
  /// A place on the curves; the parameter may lie beyond the branch's end, where it closes.
  struct Sample {
    double parameter = 0;
    Points points{};
  };

  [[nodiscard]] Sample sample(double parameter) const {
    Sample there{parameter, points_(parameter < to_ ? parameter : parameter - (to_ - from_))};
    for (Homogeneous& point : there.points) point = normalized(point);
    return there;
  }

  void connect(const Sample& from, const Sample& to, int halvings) {
    bool is_smooth = true;
    for (std::size_t i = 0; i < K; ++i) is_smooth = is_smooth && is_fine(from.points[i], to.points[i]);
    if (is_smooth || halvings == 0) {  // what is still a leap after all halvings is one: no line
      for (std::size_t i = 0; i < K; ++i) add(paths_[i], from.points[i], to.points[i]);
      return;
    }
    const Sample middle = sample((from.parameter + to.parameter) / 2);
    connect(from, middle, halvings - 1);
    connect(middle, to, halvings - 1);
  }

  /// The stretch between two points of a curve in px; nothing where it runs through infinity.
  [[nodiscard]] std::optional<std::pair<Point, Point>> stretch(Homogeneous from, Homogeneous to) const {
    if (dot(from, to) < 0) to = -1 * to;
    if (!(from.w * to.w > 0)) return std::nullopt;
    return std::pair{window_.to_px(Point{from.x / from.w, from.y / from.w}),
                     window_.to_px(Point{to.x / to.w, to.y / to.w})};
  }

  /// Short enough to be drawn, or far enough away not to be.
  [[nodiscard]] bool is_fine(Homogeneous from, Homogeneous to) const {
    const auto ends = stretch(from, to);
    if (!ends) return far_away(from) && far_away(to);
    const double length = std::abs(ends->second - ends->first);
    if (length <= longest_step) return true;
    const double nearest = std::min(distance_to_window(ends->first), distance_to_window(ends->second));
    return nearest > 2 * length;  // a smooth curve does not come back within so short a stretch
  }

  [[nodiscard]] bool far_away(Homogeneous p) const {
    if (p.w == 0) return true;
    const PixelBox& box = window_.box();
    return distance_to_window(window_.to_px(Point{p.x / p.w, p.y / p.w})) > 4 * (box.width + box.height);
  }

  [[nodiscard]] double distance_to_window(Point px) const {
    const PixelBox& box = window_.box();
    const double dx = std::max({box.left - px.real(), px.real() - box.right(), 0.0});
    const double dy = std::max({box.top - px.imag(), px.imag() - box.bottom(), 0.0});
    return std::hypot(dx, dy);
  }

  void add(std::vector<Path>& paths, Homogeneous from, Homogeneous to) const {
    const auto ends = stretch(from, to);
    if (!ends) return;
    const auto seen = window_.clipped(ends->first, ends->second);
    if (!seen || std::abs(seen->second - seen->first) > longest_line) return;
    const bool continues = !paths.empty() && paths.back().back() == seen->first && seen->first == ends->first;
    if (!continues) paths.push_back({seen->first});
    paths.back().push_back(seen->second);
  }

  std::function<Points(double)> points_;
  const PlaneWindow& window_;
  double from_ = 0, to_ = 1;
  Paths paths_;
};

/// Paths of one pivot, a new one at each branch, leap, and run through infinity.
std::vector<Path> paths_of(std::span<const Dyad> dyads, Homogeneous Dyad::*point, const PlaneWindow& window) {
  std::vector<Path> paths;
  double branch = -1;
  bool continues = false;
  for (const Dyad& dyad : dyads) {
    const Homogeneous p = dyad.*point;
    continues = continues && std::floor(dyad.coordinate) == branch && p.w != 0;
    branch = std::floor(dyad.coordinate);
    if (p.w == 0) continue;
    const Point px = window.to_px(p.vector() / p.w);
    if (!continues || !(std::abs(px - paths.back().back()) <= longest_line)) paths.emplace_back();
    paths.back().push_back(px);
    continues = true;
  }
  return paths;
}

/// Two sheets meet where a direction ceases to have grounded links, between samples: each path goes on to the nearest
/// end. Ends are looked through from left to right: of curves that leap from sample to sample there are thousands.
void join_ends(std::vector<Path>& paths) {
  struct End {
    Point at;
    std::size_t path = 0;
    bool is_dot = false;
  };
  std::vector<End> ends;
  for (std::size_t i = 0; i < paths.size(); ++i)
    for (const Point at : {paths[i].front(), paths[i].back()}) ends.push_back({at, i, paths[i].size() < 3});
  std::erase_if(ends, [](const End& end) { return !is_finite(end.at); });
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) {
    if (a.at.real() != b.at.real()) return a.at.real() < b.at.real();
    return a.at.imag() != b.at.imag() ? a.at.imag() < b.at.imag() : a.path < b.path;
  });
  const auto nearest_to = [&](std::size_t i) {
    const End& here = ends[i];
    std::size_t nearest = i;
    double least = longest_line * longest_line;
    const auto look = [&](std::size_t k) {
      const double aside = ends[k].at.real() - here.at.real();
      if (aside * aside > least) return false;
      const double distance = std::norm(ends[k].at - here.at);
      if (distance <= least && !(here.is_dot && ends[k].path == here.path)) {
        nearest = k;
        least = distance;
      }
      return true;
    };
    for (std::size_t k = i; k > 0 && look(k - 1);) --k;
    for (std::size_t k = i + 1; k < ends.size() && look(k);) ++k;
    return nearest;
  };
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (const std::size_t k = nearest_to(i); k > i) paths.push_back({ends[i].at, ends[k].at});
}

/// Without points closer to the last one than can be seen; the ends stay.
Path thinned(const Path& path) {
  constexpr double visible = 1.5;
  Path kept;
  for (std::size_t i = 0; i < path.size(); ++i)
    if (i == 0 || i + 1 == path.size() || std::abs(path[i] - kept.back()) >= visible) kept.push_back(path[i]);
  return kept;
}

std::vector<Path> visible_path(std::span<const Dyad> dyads, Homogeneous Dyad::*point, const PlaneWindow& window) {
  std::vector<Path> paths = paths_of(dyads, point, window), seen;
  join_ends(paths);
  for (const Path& path : paths)
    for (const Path& piece : window.clipped(path)) seen.push_back(thinned(piece));
  return seen;
}

}  // namespace

CurvePaths visible_polygon(std::span<const Dyad> dyads, const PlaneWindow& window) {
  return {visible_path(dyads, &Dyad::center, window), visible_path(dyads, &Dyad::circle, window)};
}

CurvePaths visible_curves(const BurmesterCurve& curve, const WorkingFrame& frame, const PlaneWindow& window) {
  const auto pivots = [&](double tau) {
    const Dyad dyad = frame.to_user(curve.dyad(tau));
    return std::array{dyad.center, dyad.circle};
  };
  CurveTracer<2> tracer(pivots, window);
  for (const CurveBranch& branch : curve.branches())
    if (branch.to > branch.from) tracer.trace(branch.from, branch.to);
  auto [centers, circles] = std::move(tracer).paths();
  return {std::move(centers), std::move(circles)};
}

std::vector<Path> visible_curve(const std::function<Homogeneous(double)>& curve, const PlaneWindow& window) {
  CurveTracer<1> tracer([&](double share) { return std::array{curve(share)}; }, window);
  tracer.trace(0, 1);
  return std::move(tracer).paths()[0];
}

}  // namespace linkwright
