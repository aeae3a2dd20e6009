#include "outer_contours.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

namespace linkwright {
namespace {

double area_of(const std::vector<Point>& points) {
  double twice = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    twice += cross(points[i] - points.front(), points[(i + 1) % points.size()] - points.front());
  return twice / 2;
}

/// Numbers for places where ends meet.
class Nodes {
 public:
  explicit Nodes(double reach) : reach_(reach), width_(reach > 0 ? reach : 1) {}

  std::size_t at(Point point) {
    const auto [column, row] = cell_of(point);
    for (const int dx : {0, -1, 1})
      for (const int dy : {0, -1, 1})
        if (const auto cell = cells_.find({column + dx, row + dy}); cell != cells_.end())
          for (const auto& [place, node] : cell->second)
            if (std::abs(place - point) <= reach_) return node;
    cells_[{column, row}].emplace_back(point, count_);
    return count_++;
  }
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  [[nodiscard]] std::pair<double, double> cell_of(Point p) const {
    return {std::floor(p.real() / width_), std::floor(p.imag() / width_)};
  }
  double reach_, width_;
  std::size_t count_ = 0;
  std::map<std::pair<double, double>, std::vector<std::pair<Point, std::size_t>>> cells_;
};

/// Chains as edges of a graph in the plane. A way is a chain in one direction: 2 · chain, or + 1 from its last point.
class ChainGraph {
 public:
  ChainGraph(const std::vector<Stroke>& chains, double reach) : chains_(chains), reach_(reach) {
    Nodes nodes(reach);
    for (const Stroke& chain : chains) {
      from_.push_back(nodes.at(chain.points.front()));
      from_.push_back(nodes.at(chain.points.back()));
    }
    leaving_.resize(nodes.count());
    is_left_.assign(chains.size(), true);
    for (std::size_t way = 0; way < from_.size(); ++way) leaving_[from_[way]].push_back(way);
    leave_out_dead_ends();
    for (std::vector<std::size_t>& ways : leaving_) {
      std::erase_if(ways, [&](std::size_t way) { return !is_left_[way / 2]; });
      std::sort(ways.begin(), ways.end(), [&](std::size_t a, std::size_t b) { return angle(a) < angle(b); });
    }
  }

  [[nodiscard]] std::vector<Stroke> outer_contours() const {
    std::vector<Stroke> contours;
    std::vector<bool> is_walked(from_.size(), false);
    for (std::size_t way = 0; way < from_.size(); ++way) {
      if (!is_left_[way / 2] || is_walked[way]) continue;
      const std::vector<std::size_t> face = face_left_of(way);
      for (const std::size_t walked : face) is_walked[walked] = true;
      if (area_of(points_of(face)) >= 0) continue;  // a face within
      for (const std::vector<std::size_t>& loop : simple_loops(face)) contours.push_back({points_of(loop), true});
    }
    return contours;
  }

 private:
  [[nodiscard]] std::size_t to(std::size_t way) const { return from_[way ^ 1]; }

  /// Chains with a free end border no face.
  void leave_out_dead_ends() {
    std::vector<std::size_t> degree, ends;
    for (std::size_t node = 0; node < leaving_.size(); ++node) {
      degree.push_back(leaving_[node].size());
      if (degree.back() == 1) ends.push_back(node);
    }
    while (!ends.empty()) {
      const std::size_t node = ends.back();
      ends.pop_back();
      for (const std::size_t way : leaving_[node]) {
        if (!is_left_[way / 2]) continue;
        is_left_[way / 2] = false;
        --degree[node];
        if (--degree[to(way)] == 1) ends.push_back(to(way));
      }
    }
  }

  /// Of the way's beginning.
  [[nodiscard]] double angle(std::size_t way) const {
    constexpr double clear = 10;  // of the reach: what is nearer may be drawn badly
    const std::vector<Point>& points = chains_[way / 2].points;
    const auto at = [&](std::size_t i) { return way % 2 == 0 ? points[i] : points[points.size() - 1 - i]; };
    std::size_t next = 1;
    while (next + 1 < points.size() && std::abs(at(next) - at(0)) <= clear * reach_) ++next;
    return std::arg(at(next) - at(0));
  }

  /// The ways round the face on the left: at each node the next one clockwise from where it came from.
  [[nodiscard]] std::vector<std::size_t> face_left_of(std::size_t first) const {
    std::vector<std::size_t> face;
    std::size_t way = first;
    do {
      face.push_back(way);
      const std::vector<std::size_t>& ways = leaving_[to(way)];
      const auto back = std::find(ways.begin(), ways.end(), way ^ 1);
      way = back == ways.begin() ? ways.back() : *(back - 1);
    } while (way != first && face.size() <= from_.size());
    return face;
  }

  [[nodiscard]] std::vector<Point> points_of(const std::vector<std::size_t>& ways) const {
    std::vector<Point> points;
    for (const std::size_t way : ways) {
      const std::vector<Point>& own = chains_[way / 2].points;
      if (way % 2 == 0)
        points.insert(points.end(), own.begin(), own.end() - 1);
      else
        points.insert(points.end(), own.rbegin(), own.rend() - 1);
    }
    return points;
  }

  /// A closed walk cut where it comes to a node a second time; a chain that is walked to and fro borders nothing.
  [[nodiscard]] std::vector<std::vector<std::size_t>> simple_loops(const std::vector<std::size_t>& walk) const {
    std::vector<std::vector<std::size_t>> loops;
    std::vector<std::size_t> open;
    std::unordered_map<std::size_t, std::size_t> begun;  // by node: where in `open` the way that begins there is
    for (const std::size_t way : walk) {
      begun.emplace(from_[way], open.size());
      open.push_back(way);
      const auto begin = begun.find(to(way));
      if (begin == begun.end()) continue;
      const std::vector<std::size_t> loop(open.begin() + static_cast<std::ptrdiff_t>(begin->second), open.end());
      open.resize(begin->second);
      for (const std::size_t closed : loop) begun.erase(from_[closed]);
      const bool encloses = loop.size() != 2 || loop[0] / 2 != loop[1] / 2;
      if (encloses) loops.push_back(loop);
    }
    return loops;
  }

  const std::vector<Stroke>& chains_;
  double reach_;
  std::vector<std::size_t> from_;                  ///< by way: the node where it begins
  std::vector<std::vector<std::size_t>> leaving_;  ///< by node: the ways that begin there, by their angle
  std::vector<bool> is_left_;                      ///< by chain
};

}  // namespace

std::vector<Stroke> outer_contours(const std::vector<Stroke>& chains, double reach) {
  return ChainGraph(chains, reach).outer_contours();
}

}  // namespace linkwright
