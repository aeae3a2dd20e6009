#include "region/window_look.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "linkwright/core/parallel.hpp"
#include "linkwright/region/hill_climb.hpp"

namespace linkwright {
namespace {

std::unique_ptr<JudgedMap> judged(const LinkageFamily& family, const Requirements& requirements,
                                  const MapMaking& making, MapPoint step, const std::vector<double>& input,
                                  const std::vector<double>& output) {
  auto made = std::make_unique<JudgedMap>();
  made->step = step;
  making.fill(made->map, input, output);
  made->filter.emplace(filter_of(family, made->map, requirements));
  return made;
}

// Adds a map of which `inside` linkages have all hinges in the windows. True where some of it meets all requirements.
bool keep(WindowLook& look, std::unique_ptr<JudgedMap> made, std::int64_t inside) {
  const std::int64_t meeting = made->filter->census().meeting;
  look.looked_at += inside;
  look.meeting += meeting;
  if (inside > 0) look.maps.push_back(std::move(made));
  return meeting > 0;
}

// Its linkages with all hinges in the windows.
std::int64_t linkages_inside(const JudgedMap& made) {
  std::int64_t count = 0;
  for (std::size_t row = 0; row < made.map.rows(); ++row)
    for (std::size_t column = 0; column < made.map.columns(); ++column)
      count += made.filter->distance_to_windows(row, column) == 0;
  return count;
}

// The same where each link depends on its own coordinate alone: by rows and columns, of which there are fewer than
// cells.
std::int64_t linkages_inside(const JudgedMap& made, const LinkageFamily& family, const PivotWindows& windows) {
  const MapPivots pivots = family.pivots(made.map);
  if (pivots.of_cell) return linkages_inside(made);
  std::vector<std::size_t> columns;
  for (std::size_t column = 0; column < made.map.columns(); ++column)
    if (windows.hold(pivots.columns[column])) columns.push_back(column);
  std::int64_t count = 0;
  for (std::size_t row = 0; row < made.map.rows(); ++row) {
    if (!windows.hold(pivots.rows[row])) continue;
    for (const std::size_t column : columns)
      count += made.map.type(made.map.index(row, column)) != LinkageType::degenerate;
  }
  return count;
}

/// Of arcs of an axis what lies in the part of the map that is looked at.
std::vector<AxisArc> arcs_seen(std::vector<AxisArc> arcs, const LinkageFamily& family, Side side,
                               const std::optional<MapWindow>& window) {
  if (!window || family.axis(side).is_discrete()) return arcs;
  return clipped(arcs, arcs_of(family.axis(side), window->of(side)));
}

/// The stretches of both axes whose grounded links have their hinges in windows.
class StretchesInside {
 public:
  StretchesInside(const LinkageFamily& family, const PivotWindows& windows, const std::optional<MapWindow>& window)
      : family_(family),
        window_(window),
        found_{family.arcs_within(Side::input, windows), family.arcs_within(Side::output, windows)} {}

  [[nodiscard]] bool prove_it_empty() const {
    return std::any_of(found_.begin(), found_.end(),
                       [](const auto& of_axis) { return of_axis && of_axis->are_all && of_axis->arcs.empty(); });
  }
  /// Of the part of the map that is looked at; nothing where the links of that axis depend on both coordinates.
  [[nodiscard]] std::optional<std::vector<AxisArc>> seen(Side side) const {
    const auto& found = found_[static_cast<std::size_t>(side)];
    if (!found) return std::nullopt;
    return arcs_seen(found->arcs, family_, side, window_);
  }

 private:
  const LinkageFamily& family_;
  const std::optional<MapWindow>& window_;
  std::array<std::optional<AxisArcs>, 2> found_;
};

// Their share of the samples of an axis, and enough of each to climb from.
struct SampledArc {
  std::vector<double> coordinates;
  double step = 0;
};
std::vector<SampledArc> sampled(const std::vector<AxisArc>& arcs, int samples) {
  constexpr int least = 12;
  double width = 0;
  for (const AxisArc& arc : arcs) width += arc.to - arc.from;
  std::vector<SampledArc> found;
  for (const AxisArc& arc : arcs) {
    const double own = arc.to - arc.from;
    const int count = width > 0 ? std::max(least, static_cast<int>(samples * own / width)) : 1;
    found.push_back({samples_over(arc, count), own / count});
  }
  return found;
}

/// Looks closer and closer where hinges come nearest to their windows.
class CloserLook {
 public:
  CloserLook(const LinkageFamily& family, const Requirements& requirements, const MapMaking& making,
             const Progress& progress)
      : family_(family), requirements_(requirements), making_(making), progress_(progress) {}

  /// From the map of the whole family.
  [[nodiscard]] WindowLook from(const SearchMap& seen) && {
    const std::size_t stride = std::max(seen.map->rows(), seen.map->columns()) / looked_at_first + 1;
    const auto step = [&](Side side, std::size_t count) {
      return static_cast<double>(stride) * seen_length(side) / static_cast<double>(count);
    };
    follow(nearest_of(seen, stride, {step(Side::input, seen.map->rows()), step(Side::output, seen.map->columns())},
                      making_.followed));
    return std::move(look_);
  }
  /// From maps of what one axis has in the windows.
  [[nodiscard]] WindowLook from(JudgedMaps& begun) && {
    std::vector<Spot> spots;
    for (auto& map : begun) {
      const std::vector<Spot> nearest = nearest_of(map->view(), 1, map->step, making_.followed);
      spots.insert(spots.end(), nearest.begin(), nearest.end());
      const std::int64_t within = linkages_inside(*map);
      keep(look_, std::move(map), within);
    }
    follow(best_of(std::move(spots)));
    return std::move(look_);
  }

 private:
  static constexpr std::size_t looked_at_first = 120;  // a side of the whole map, at most
  static constexpr int levels = 6;                     // of ever smaller maps
  static constexpr int cells = 12;                     // a side of each of them
  static constexpr double narrowing = 0.25;

  struct Spot {
    MapPoint at, step;
    double badness = 0;  ///< distance from the windows, and requirements failed
  };

  [[nodiscard]] double seen_length(Side side) const {
    const double whole = family_.axis(side).coordinate_length();
    if (!making_.window || family_.axis(side).is_discrete()) return whole;
    const auto [low, high] = making_.window->of(side);
    return std::min(whole, high - low);
  }

  /// Distance first; among places inside, those that fail fewer requirements.
  [[nodiscard]] static double badness(const RequirementFilter& filter, std::size_t row, std::size_t column) {
    constexpr double of_a_failure = 1e-12;
    return filter.distance_to_windows(row, column) + of_a_failure * std::popcount(filter.failures(row, column));
  }

  /// Places of a map, every so many of its rows and columns, that are less bad than those around.
  [[nodiscard]] std::vector<Spot> nearest_of(const SearchMap& seen, std::size_t stride, MapPoint step,
                                             std::size_t most) const {
    const RegionMap& map = *seen.map;
    const std::size_t rows = (map.rows() + stride - 1) / stride, columns = (map.columns() + stride - 1) / stride;
    std::vector<double> scores(rows * columns);
    parallel_for(rows, map.threads(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row)
        for (std::size_t column = 0; column < columns; ++column) {
          const double bad = badness(*seen.filter, row * stride, column * stride);
          scores[row * columns + column] = std::isfinite(bad) ? -bad : no_score;
        }
    });
    const auto input = [&](std::size_t row) { return map.input_coordinates()[row * stride]; };
    const auto output = [&](std::size_t column) { return map.output_coordinates()[column * stride]; };
    const auto score = [&](std::size_t row, std::size_t column) { return scores[row * columns + column]; };
    const auto same_hill = [&](std::size_t row, std::size_t column, std::size_t other_row, std::size_t other_column) {
      return std::floor(input(row)) == std::floor(input(other_row)) &&
             std::floor(output(column)) == std::floor(output(other_column));
    };
    std::vector<Spot> spots;
    for (const RankedCell& cell : hill_tops(rows, columns, {1, most, map.threads()}, score, same_hill))
      spots.push_back({{input(cell.row), output(cell.column)}, step, -cell.score});
    return spots;
  }
  [[nodiscard]] std::vector<Spot> best_of(std::vector<Spot> spots) const {
    std::sort(spots.begin(), spots.end(), [](const Spot& a, const Spot& b) { return a.badness < b.badness; });
    if (spots.size() > making_.followed) spots.resize(making_.followed);
    return spots;
  }

  void follow(std::vector<Spot> spots) {
    for (int level = 0; level < levels && !spots.empty() && !progress_.is_cancelled(); ++level) {
      std::vector<Spot> next;
      for (const Spot& spot : spots) {
        const std::vector<Spot> found = around(spot);
        next.insert(next.end(), found.begin(), found.end());
      }
      spots = best_of(std::move(next));
    }
  }

  [[nodiscard]] std::vector<double> coordinates_around(Side side, double at, double step) const {
    const MapAxis& axis = family_.axis(side);
    if (axis.is_discrete()) return {at};
    AxisStretch stretch = axis.stretch_around(at);
    if (making_.window)
      for (const AxisArc& arc : arcs_of(axis, making_.window->of(side)))
        if (at >= arc.from && at <= arc.to && (arc.from > stretch.from || arc.to < stretch.to))
          stretch = {std::max(stretch.from, arc.from), std::min(stretch.to, arc.to), false};
    std::vector<double> coordinates;
    for (int i = 0; i <= cells; ++i) {
      const double there = stretch.onto(at + step * (2.0 * i / cells - 1));
      if (coordinates.empty() || there != coordinates.back()) coordinates.push_back(there);
    }
    return coordinates;
  }

  /// The places worth following around one; what passes there is kept.
  [[nodiscard]] std::vector<Spot> around(const Spot& spot) {
    const double apart = 2.0 / cells;
    auto made = judged(family_, requirements_, making_, {apart * spot.step.input, apart * spot.step.output},
                       coordinates_around(Side::input, spot.at.input, spot.step.input),
                       coordinates_around(Side::output, spot.at.output, spot.step.output));
    constexpr std::size_t branches = 2;
    std::vector<Spot> nearest =
        nearest_of(made->view(), 1, {narrowing * spot.step.input, narrowing * spot.step.output}, branches);
    const std::int64_t within = linkages_inside(*made);
    if (keep(look_, std::move(made), within)) return {};  // from there on it is climbed
    return nearest;
  }

  const LinkageFamily& family_;
  const Requirements& requirements_;
  const MapMaking& making_;
  const Progress& progress_;
  WindowLook look_;
};

// Of the same requirement the one that dropping it would leave most of.
void add_dearer(std::vector<Relaxation>& known, const std::vector<Relaxation>& more,
                const std::function<bool(RequirementKind)>& wanted) {
  for (const Relaxation& relaxation : more) {
    if (!wanted(relaxation.requirement)) continue;
    const auto same = std::find_if(known.begin(), known.end(), [&](const Relaxation& other) {
      return other.requirement == relaxation.requirement;
    });
    if (same == known.end())
      known.push_back(relaxation);
    else if (relaxation.only_this > same->only_this)
      *same = relaxation;
  }
}

bool is_ground_window(RequirementKind kind) { return criterion(kind).rule == Criterion::Rule::ground_inside; }
bool is_moving_window(RequirementKind kind) { return criterion(kind).rule == Criterion::Rule::moving_inside; }

// One map to each pair of stretches; nothing where a grounded link depends on both coordinates, none where on one of
// the axes none has its hinges inside.
std::optional<JudgedMaps> maps_on(const StretchesInside& stretches, const LinkageFamily& family,
                                  const Requirements& judged_by, const MapMaking& making) {
  const auto input = stretches.seen(Side::input), output = stretches.seen(Side::output);
  if (!input || !output) return std::nullopt;
  JudgedMaps maps;
  const std::vector<SampledArc> rows = sampled(*input, making.samples), columns = sampled(*output, making.samples);
  for (const SampledArc& row : rows)
    for (const SampledArc& column : columns)
      maps.push_back(judged(family, judged_by, making, {row.step, column.step}, row.coordinates, column.coordinates));
  return maps;
}

/// What relaxing a single requirement would leave: of the map, and of what lies in the windows that stay.
class RelaxationSearch {
 public:
  RelaxationSearch(const LinkageFamily& family, const Requirements& requirements, const MapMaking& making,
                   const Progress& progress)
      : family_(family), requirements_(requirements), making_(making), progress_(progress) {}

  [[nodiscard]] std::vector<Relaxation> of(std::span<const SearchMap> maps) && {
    add(maps.front(), [](RequirementKind /*any*/) { return true; });
    for (const SearchMap& closer : maps.subspan(1))
      add(closer, [](RequirementKind kind) { return !is_ground_window(kind) && !is_moving_window(kind); });
    const PivotWindows windows = windows_of(requirements_, family_.linkages());
    if (windows.ground && windows.moving) {
      add_of({windows.ground, std::nullopt}, is_moving_window);
      add_of({std::nullopt, windows.moving}, is_ground_window);
    }
    std::stable_sort(found_.begin(), found_.end(),
                     [](const Relaxation& a, const Relaxation& b) { return a.only_this > b.only_this; });
    return std::move(found_);
  }

 private:
  void add(const SearchMap& map, const std::function<bool(RequirementKind)>& wanted) {
    add_dearer(found_, map.filter->relaxations(map.filter->census(progress_), progress_), wanted);
  }
  void add_of(const PivotWindows& kept, const std::function<bool(RequirementKind)>& wanted) {
    if (const auto maps = maps_on({family_, kept, making_.window}, family_, requirements_, making_))
      for (const auto& map : *maps) add(map->view(), wanted);
  }

  const LinkageFamily& family_;
  const Requirements& requirements_;
  const MapMaking& making_;
  const Progress& progress_;
  std::vector<Relaxation> found_;
};

// The output's stretches at an input, or all of its axis; of either what is looked at.
std::vector<SampledArc> columns_at(const LinkageFamily& family, double input, const PivotWindows& windows,
                                   const std::optional<MapWindow>& window) {
  constexpr int samples = 60;
  if (auto arcs = family.output_arcs_within(input, windows))
    return sampled(arcs_seen(*std::move(arcs), family, Side::output, window), samples);
  const std::vector<double> columns = samples_within(family, Side::output, window, samples, Spacing::coordinate);
  return {{columns, family.axis(Side::output).coordinate_length() / static_cast<double>(columns.size())}};
}

// Where the stretches of one axis are known, on them alone.
WindowLook look_closer(const LinkageFamily& family, const PivotWindows& windows, const StretchesInside& stretches,
                       const SearchMap& seen, const Requirements& requirements, const MapMaking& making,
                       const Progress& progress) {
  if (seen.filter->census(progress).meeting >= static_cast<std::int64_t>(making.followed)) return {};
  const auto rows = stretches.seen(Side::input);
  CloserLook look(family, requirements, making, progress);
  if (!rows || (rows->empty() && making.doubts_samples)) return std::move(look).from(seen);
  JudgedMaps begun;
  for (const SampledArc& arc : sampled(*rows, making.samples))
    for (const double row : arc.coordinates)
      for (const SampledArc& columns : columns_at(family, row, windows, making.window))
        begun.push_back(judged(family, requirements, making, {arc.step, columns.step}, {row}, columns.coordinates));
  return std::move(look).from(begun);
}

}  // namespace

WindowLook look_into_windows(const LinkageFamily& family, const SearchMap& seen, const Requirements& requirements,
                             const MapMaking& making, const Progress& progress) {
  const PivotWindows windows = windows_of(requirements, family.linkages());
  if (!windows.any() || seen.map->rows() == 0 || seen.map->columns() == 0) return {};
  if (family.axis(Side::input).is_discrete() && family.axis(Side::output).is_discrete()) return {};
  const StretchesInside stretches(family, windows, making.window);
  if (stretches.prove_it_empty()) return {{}, 0, 0, true};
  auto made = maps_on(stretches, family, requirements, making);
  if (!made || made->empty()) return look_closer(family, windows, stretches, seen, requirements, making, progress);
  WindowLook look;
  for (auto& map : *made) {
    const std::int64_t inside = linkages_inside(*map, family, windows);
    keep(look, std::move(map), inside);
  }
  return look;
}

std::vector<Relaxation> relaxations(const LinkageFamily& family, std::span<const SearchMap> maps,
                                    const Requirements& requirements, const MapMaking& making,
                                    const Progress& progress) {
  return RelaxationSearch(family, requirements, making, progress).of(maps);
}

}  // namespace linkwright
