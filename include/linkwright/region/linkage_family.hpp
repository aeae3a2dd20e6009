#pragma once

#include <array>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/algebra/vector3.hpp"
#include "linkwright/core/progress.hpp"
#include "linkwright/mechanism/linkage_output.hpp"
#include "linkwright/region/linkage_class.hpp"
#include "linkwright/region/map_axis.hpp"
#include "linkwright/region/pivot_windows.hpp"
#include "linkwright/region/region_map.hpp"

namespace linkwright {

struct DefectReport;

/// A few hinges in position 1, user's frame: of planar linkages their points in the plane z = 0, of spherical ones unit
/// vectors along their axes.
class Hinges {
 public:
  static constexpr std::size_t most = 5;  ///< of a six-bar, beside two of the others

  Hinges(std::initializer_list<Vector3> hinges = {}) {
    for (const Vector3 hinge : hinges) push_back(hinge);
  }
  void push_back(Vector3 hinge) { hinges_[count_++] = hinge; }
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] Vector3 operator[](std::size_t i) const { return hinges_[i]; }
  [[nodiscard]] const Vector3* begin() const { return hinges_.data(); }
  [[nodiscard]] const Vector3* end() const { return hinges_.data() + count_; }

 private:
  std::array<Vector3, most> hinges_;
  std::size_t count_ = 0;
};

/// The hinges of a linkage: those on the ground, and all others; of a four-bar those of the input link first.
struct Pivots {
  Hinges ground, moving;
};

/// The linkage at a place by itself: the verdict of its cell in double precision, numbers that are not known yet being
/// NaN, and what a search goes by.
struct Cell : MapCell {
  MapPoint place;
  Pivots pivots;
  double change_point_margin = 1;  ///< how far from another type, as a share of the linkage's size
  std::size_t hill = 0;            ///< a climb stays where it is the same: the type, if not another number
};

/// With what its linkage was found to do in the positions of the task, of whose measures the transmission angle's over
/// travel and over a full turn come first; nothing where the linkage is degenerate.
[[nodiscard]] std::optional<Cell> driven(Cell cell, const DefectReport& report);

/// The pivots of a map's linkages: of its rows and its columns, where each grounded link depends on its own coordinate
/// alone, otherwise of its cells.
struct MapPivots {
  std::vector<GroundedLinkPivots> rows, columns;
  /// Nothing where a pivot is at infinity; called from several threads.
  std::function<std::optional<Pivots>(std::size_t row, std::size_t column)> of_cell;
};

class FourBarCells;
struct SphericalCells;

/// What a task leaves open: linkages over two coordinates. Map, filter, census and search ask it for nothing else, so
/// that they do not know what kind of linkage they are about.
class LinkageFamily {
 public:
  /// Rows of the map run along `input`, columns along `output`.
  LinkageFamily(MapAxis input, MapAxis output) : input_axis_(std::move(input)), output_axis_(std::move(output)) {}
  LinkageFamily(const LinkageFamily&) = delete;
  LinkageFamily& operator=(const LinkageFamily&) = delete;
  virtual ~LinkageFamily() = default;

  [[nodiscard]] const MapAxis& axis(Side side) const { return side == Side::input ? input_axis_ : output_axis_; }

  /// What its linkages can be and what can be required of them.
  [[nodiscard]] virtual const LinkageClass& linkages() const { return planar_linkages; }

  /// Both axes carry the same grounded links: (u, v) and (v, u) are the same bars, driven from the other side.
  [[nodiscard]] virtual bool is_symmetric() const { return false; }

  /// (u, v) and (v, u) are cognates: other bars that do the same, alike in all that the family measures but their size.
  /// Lists have one of the two, the better or, where both score alike, the smaller.
  [[nodiscard]] virtual bool has_cognates() const { return false; }

  /// The side whose coordinate takes longer to change: a search over both changes it the less often.
  [[nodiscard]] virtual Side costlier_side() const { return Side::input; }

  /// What people read at a coordinate (degrees, user's length, …): the coordinate unless the quantity is another.
  [[nodiscard]] virtual double axis_value(Side side, double coordinate) const;

  /// `count` coordinates along an axis; a discrete one has one to each branch, whatever is asked.
  [[nodiscard]] virtual std::vector<double> samples(Side side, int count, Spacing spacing) const;

  /// The map over these coordinates. Rows left out because `progress` was cancelled are degenerate. Throws
  /// std::bad_alloc.
  void classify(RegionMap& map, std::span<const double> input, std::span<const double> output, bool respect_direction,
                const RegionOptions& options = {}, const Progress& progress = {}) const {
    fill(map, input, output, respect_direction, options, progress);
  }

  /// The stretches of an axis on which the grounded link has its hinges in the windows. Nothing where that depends on
  /// the other coordinate, too.
  [[nodiscard]] virtual std::optional<AxisArcs> arcs_within(Side /*side*/, const PivotWindows& /*windows*/) const {
    return std::nullopt;
  }

  /// The same of the output axis at an input coordinate, where the output link depends on it; nothing where that is not
  /// known.
  [[nodiscard]] virtual std::optional<std::vector<AxisArc>> output_arcs_within(double /*input*/,
                                                                               const PivotWindows& /*windows*/) const {
    return std::nullopt;
  }

  /// What the cells of its maps hold, in this order.
  [[nodiscard]] virtual std::span<const Measure> measures() const = 0;
  /// The linkages at places, one after the other: what those near each other have in common is worked out once. Nothing
  /// where there is none, a link has no length, or `is_worth_it` does not hold of what is known before what takes long.
  /// Of one thread; refers to the family, which must outlive it.
  using CellAt =
      std::function<std::optional<Cell>(MapPoint place, const std::function<bool(const Cell&)>& is_worth_it)>;
  [[nodiscard]] virtual CellAt cells(bool respect_direction) const = 0;
  /// One of them.
  [[nodiscard]] std::optional<Cell> cell(MapPoint place, bool respect_direction = true) const;
  /// Places at which linkages were found before there was a map: a search begins there, too.
  [[nodiscard]] virtual std::vector<MapPoint> known_places() const { return {}; }
  /// A place takes so long that climbs are rougher: it is driven through.
  [[nodiscard]] virtual bool cells_take_long() const { return false; }
  /// How far apart two designs are: the largest distance of a hinge, the grounded links named whichever way is nearer.
  [[nodiscard]] virtual double distance(const Pivots& one, const Pivots& other) const;
  /// The stretch of an axis that a climb from a place keeps to.
  [[nodiscard]] virtual AxisStretch stretch_around(Side side, MapPoint place) const;

  /// Where the hinges of a map of this family lie. Refers to the family and the map, which must outlive it.
  [[nodiscard]] virtual MapPivots pivots(const RegionMap& map) const = 0;

  /// How the linkage at a place lies in the positions of its task, user's frame: what analyses look at. Turns count as
  /// no length (with_turning_length()). Nothing where there is no linkage.
  [[nodiscard]] virtual std::optional<LinkageOutput> output(MapPoint place) const = 0;
  /// The same of the cells of a map; what they share is worked out once. May be called from several threads. Refers to
  /// the family and the map, which must outlive it.
  using OutputOfCells = std::function<std::optional<LinkageOutput>(std::size_t row, std::size_t column)>;
  [[nodiscard]] virtual OutputOfCells outputs_of(const RegionMap& map) const;
  /// An output without positions of the kind that all of them are, with the same dimensions; nothing where these
  /// differ.
  [[nodiscard]] virtual std::optional<LinkageOutput> output_form() const { return PlanarOutput{}; }
  /// An output takes so long that only cells that meet all else are worth it.
  [[nodiscard]] virtual bool outputs_take_long() const { return false; }
  /// For kernels: the links of a map's cells in all positions. Null: its linkages are others. Refers as outputs_of().
  [[nodiscard]] virtual std::shared_ptr<const FourBarCells> four_bar_cells(const RegionMap& map) const;
  [[nodiscard]] virtual std::shared_ptr<const SphericalCells> spherical_cells(const RegionMap& map) const;

 private:
  virtual void fill(RegionMap& map, std::span<const double> input, std::span<const double> output,
                    bool respect_direction, const RegionOptions& options, const Progress& progress) const = 0;

  MapAxis input_axis_, output_axis_;
};

/// Coordinates along an axis: family.samples(), within a window evenly.
[[nodiscard]] std::vector<double> samples_within(const LinkageFamily& family, Side side,
                                                 const std::optional<MapWindow>& window, int count, Spacing spacing);

/// True where no window leaves the point out.
[[nodiscard]] bool is_within(const LinkageFamily& family, const std::optional<MapWindow>& window, MapPoint point);

}  // namespace linkwright
