#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "linkwright/function/wanted_function.hpp"
#include "linkwright/planar/four_bar_family.hpp"

namespace linkwright {

/// A grounded link in all positions, working frame.
struct LinkPositions {
  static constexpr std::size_t most_positions = 5;

  Point center{};
  std::array<Point, most_positions> circle{};
  bool is_whole = false;  ///< neither pivot is at infinity
};

/// Where the links of a map's four-bars are in the positions of their task, working frame. Those of rows and columns
/// that depend on their own coordinate alone are moved once.
class FourBarCells {
 public:
  /// Refers to the family and the map, which must outlive it. `poses`: of all linkages, working frame.
  FourBarCells(const FourBarFamily& family, const RegionMap& map, const std::vector<PrescribedPose>& poses);
  /// `pairs`: angles of the grounded links, to each column of the map.
  FourBarCells(const FourBarFamily& family, const RegionMap& map, const std::vector<std::vector<AnglePair>>& pairs);

  [[nodiscard]] double scale() const { return frame_.scale; }  ///< user's unit
  [[nodiscard]] Point to_user(Point working) const { return frame_.to_user(working); }
  [[nodiscard]] std::size_t positions() const { return input_moves_.front().size(); }
  /// Angles are asked for, not poses.
  [[nodiscard]] bool is_function() const { return origins_.empty(); }
  /// The body's origin; of motions.
  [[nodiscard]] Point origin(std::size_t position) const { return origins_[position]; }
  /// e^{i turn} of the body from position 1; of motions.
  [[nodiscard]] Point turn(std::size_t position) const { return input_moves_.front()[position].turn; }
  /// Links of rows and columns depend on their own coordinate alone: otherwise there are those of at() alone.
  [[nodiscard]] bool has_rows_and_columns() const { return !rows_.empty() && !columns_.empty(); }
  [[nodiscard]] const LinkPositions& input_link(std::size_t row) const { return rows_[row]; }
  [[nodiscard]] const LinkPositions& output_link(std::size_t column) const { return columns_[column]; }
  /// Input and output link; not whole where there is none.
  [[nodiscard]] std::pair<LinkPositions, LinkPositions> at(std::size_t row, std::size_t column) const;

 private:
  /// z → turn · (z − about(z)) + to: a pose carries all points along, an angle turns a link about its own pivot.
  struct Move {
    Point turn{1, 0}, from{}, to{};
    bool about_center = false;
  };
  using Moves = std::vector<Move>;

  [[nodiscard]] static LinkPositions moved(const Dyad& link, const Moves& moves);

  WorkingFrame frame_;
  FourBarFamily::DyadPairsOfCells pairs_;
  std::vector<Moves> input_moves_, output_moves_;  ///< one for all columns, or one to each
  std::vector<Point> origins_;
  std::vector<LinkPositions> rows_, columns_;
};

}  // namespace linkwright
