#include "chains.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <unordered_map>

#include "outer_contours.hpp"

namespace linkwright {
namespace {

constexpr double meeting = 1e-5;     // of the drawing's size
constexpr std::size_t two_ends = 2;  // where a chain goes on

bool meet(Point a, Point b, double reach) { return std::abs(a - b) <= reach; }

struct End {
  std::size_t stroke;
  bool last;
};

Point end_point(const Stroke& stroke, bool last) { return last ? stroke.points.back() : stroke.points.front(); }

/// A square as wide as ends may be apart.
struct Cell {
  double column, row;
  friend bool operator==(const Cell&, const Cell&) = default;
};
struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    const std::hash<double> hash;
    return hash(cell.column) * 31 + hash(cell.row);
  }
};

/// The ends of open strokes by the cell that they lie in.
class Ends {
 public:
  Ends(const std::vector<Stroke>& strokes, double reach)
      : strokes_(strokes), reach_(reach), is_free_(strokes.size(), true) {
    for (std::size_t i = 0; i < strokes.size(); ++i)
      for (const bool last : {false, true}) cells_[cell_of(point({i, last}))].push_back({i, last});
  }

  bool take(std::size_t stroke) {
    const bool was_free = is_free_[stroke];
    is_free_[stroke] = false;
    return was_free;
  }

  /// Goes on from the last point as long as another stroke begins there, or the chain is closed.
  void extend(std::vector<Point>& points) {
    for (;;) {
      const Point at = points.back();
      if ((points.size() > 2 && meet(points.front(), at, reach_)) || is_crowded(at)) return;
      const auto found = free_end(at);
      if (!found) return;
      is_free_[found->stroke] = false;
      const std::vector<Point>& next = strokes_[found->stroke].points;
      if (found->last)
        points.insert(points.end(), next.rbegin() + 1, next.rend());
      else
        points.insert(points.end(), next.begin() + 1, next.end());
    }
  }

 private:
  [[nodiscard]] Point point(const End& end) const { return end_point(strokes_[end.stroke], end.last); }
  [[nodiscard]] Cell cell_of(Point p) const {
    const double width = reach_ > 0 ? reach_ : 1;
    return {std::floor(p.real() / width), std::floor(p.imag() / width)};
  }
  /// The cells about a point, its own first.
  template <class Visit>
  void near(Point at, const Visit& visit) {
    const Cell own = cell_of(at);
    for (const double dx : {0.0, -1.0, 1.0})
      for (const double dy : {0.0, -1.0, 1.0})
        if (const auto cell = cells_.find({own.column + dx, own.row + dy}); cell != cells_.end())
          if (visit(cell->second)) return;
  }
  [[nodiscard]] bool is_crowded(Point at) {
    std::size_t count = 0;
    near(at, [&](const std::vector<End>& cell) {
      for (const End& end : cell)
        if (meet(point(end), at, reach_) && ++count > two_ends) return true;
      return false;
    });
    return count > two_ends;
  }
  [[nodiscard]] std::optional<End> free_end(Point at) {
    std::optional<End> found;
    near(at, [&](const std::vector<End>& cell) {
      for (std::size_t i = cell.size(); i-- > 0 && !found;)
        if (is_free_[cell[i].stroke] && meet(point(cell[i]), at, reach_)) found = cell[i];
      return found.has_value();
    });
    return found;
  }

  const std::vector<Stroke>& strokes_;
  double reach_;
  std::vector<bool> is_free_;
  std::unordered_map<Cell, std::vector<End>, CellHash> cells_;
};

/// Strokes joined where just two ends meet.
std::vector<Stroke> joined(const std::vector<Stroke>& strokes, double reach) {
  Ends ends(strokes, reach);
  std::vector<Stroke> chains;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    if (!ends.take(i)) continue;
    Stroke chain{strokes[i].points, false};
    ends.extend(chain.points);
    if (!meet(chain.points.front(), chain.points.back(), reach)) {
      std::reverse(chain.points.begin(), chain.points.end());
      ends.extend(chain.points);
      std::reverse(chain.points.begin(), chain.points.end());
    }
    chain.closed = chain.points.size() > 3 && meet(chain.points.front(), chain.points.back(), reach);
    if (chain.closed) chain.points.pop_back();
    chains.push_back(std::move(chain));
  }
  return chains;
}

}  // namespace

std::vector<Stroke> chained(std::vector<Stroke> strokes) {
  const auto is_closed = [](const Stroke& stroke) { return stroke.closed; };
  const auto open = std::stable_partition(strokes.begin(), strokes.end(), is_closed);
  const std::vector<Stroke> to_join(std::make_move_iterator(open), std::make_move_iterator(strokes.end()));
  strokes.erase(open, strokes.end());
  std::vector<Point> points;
  for (const Stroke& stroke : to_join) points.insert(points.end(), stroke.points.begin(), stroke.points.end());
  const double reach = meeting * size_of(points);
  std::vector<Stroke> chains = joined(to_join, reach), open_chains;
  std::copy_if(chains.begin(), chains.end(), std::back_inserter(open_chains), std::not_fn(is_closed));
  std::vector<Stroke> outer = outer_contours(open_chains, reach);
  std::move(chains.begin(), chains.end(), std::back_inserter(strokes));
  std::move(outer.begin(), outer.end(), std::back_inserter(strokes));
  return strokes;
}

}  // namespace linkwright
