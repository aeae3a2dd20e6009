#include "four_bar_errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "linkwright/core/angle.hpp"
#include "linkwright/planar/function_family.hpp"
#include "linkwright/region/region_map.hpp"
#include "robust/tolerance_error_kernel.hpp"

namespace linkwright {
namespace {

constexpr std::size_t most_positions = ToleranceErrorBlock::most_positions;

/// A grounded link in all positions, working frame.
struct LinkPositions {
  Point center{};
  std::array<Point, most_positions> circle{};
  bool is_whole = false;  ///< neither pivot is at infinity
};

ToleranceErrorBlock::Variances variances_of(const Tolerances& tolerances, double scale) {
  const PlanarValues all = planar_variances(tolerances);
  const auto of = [&](PlanarParameter parameter) { return all[static_cast<std::size_t>(parameter)] / (scale * scale); };
  return {of(PlanarParameter::input),       of(PlanarParameter::coupler),
          of(PlanarParameter::output),      of(PlanarParameter::input_center_x),
          of(PlanarParameter::point_along), all[static_cast<std::size_t>(PlanarParameter::driver)]};
}

void put(const LinkPositions& link, std::size_t positions, std::size_t lane,
         double center[2][ToleranceErrorBlock::size], double circle[most_positions][2][ToleranceErrorBlock::size]) {
  center[0][lane] = link.center.real();
  center[1][lane] = link.center.imag();
  for (std::size_t j = 0; j < positions; ++j) {
    circle[j][0][lane] = link.circle[j].real();
    circle[j][1][lane] = link.circle[j].imag();
  }
}

/// Where the links of a map's cells are in the positions of its task. Those of rows and columns that depend on their
/// own coordinate alone are moved once.
class LinksOfCells {
 public:
  LinksOfCells(const FourBarFamily& family, const RegionMap& map)
      : pairs_(family.dyad_pairs_of_cells(map.input_coordinates(), map.output_coordinates())) {
    if (const auto* functions = dynamic_cast<const FunctionFamily*>(&family))
      set_turns(*functions, map);
    else
      set_poses(family, map);
  }

  [[nodiscard]] std::size_t positions() const { return input_moves_.front().size(); }
  [[nodiscard]] bool is_function() const { return origins_.empty(); }
  /// The body's origin; of motions.
  [[nodiscard]] Point origin(std::size_t position) const { return origins_[position]; }

  [[nodiscard]] std::pair<LinkPositions, LinkPositions> at(std::size_t row, std::size_t column) const {
    if (!rows_.empty()) return {rows_[row], columns_[column]};
    const auto pair = pairs_(row, column);
    if (!pair) return {};
    const std::size_t moves = input_moves_.size() == 1 ? 0 : column;
    return {moved(pair->input, input_moves_[moves]), moved(pair->output, output_moves_[moves])};
  }

 private:
  /// z → turn · (z − about(z)) + to: a pose carries all points along, an angle turns a link about its own pivot.
  struct Move {
    Point turn{1, 0}, from{}, to{};
    bool about_center = false;
  };
  using Moves = std::vector<Move>;

  void set_poses(const FourBarFamily& family, const RegionMap& map) {
    Moves moves;
    const auto poses = family.working_poses({}, {});  // the same for all of them
    for (const PrescribedPose& there : poses) {
      const Pose &first = poses.front().pose, &pose = there.pose;
      moves.push_back({direction(pose.angle - first.angle), first.origin, pose.origin, false});
      origins_.push_back(pose.origin);
    }
    input_moves_ = output_moves_ = {moves};
    for (const Dyad& link : family.dyads(Side::input, map.input_coordinates())) rows_.push_back(moved(link, moves));
    for (const Dyad& link : family.dyads(Side::output, map.output_coordinates()))
      columns_.push_back(moved(link, moves));
  }
  // The free parameter runs along the columns.
  void set_turns(const FunctionFamily& family, const RegionMap& map) {
    for (const double coordinate : map.output_coordinates()) {
      const auto pairs = family.task_at({0, coordinate}).pairs;
      Moves inputs, outputs;
      for (const AnglePair& pair : pairs) {
        inputs.push_back({direction(pair.input - pairs.front().input), {}, {}, true});
        outputs.push_back({direction(pair.output - pairs.front().output), {}, {}, true});
      }
      input_moves_.push_back(std::move(inputs));
      output_moves_.push_back(std::move(outputs));
    }
  }
  [[nodiscard]] static LinkPositions moved(const Dyad& link, const Moves& moves) {
    const auto center = finite_point(link.center), circle = finite_point(link.circle);
    if (!center || !circle) return {};
    LinkPositions found{*center, {}, true};
    for (std::size_t j = 0; j < moves.size(); ++j) {
      const Move& move = moves[j];
      found.circle[j] =
          move.about_center ? *center + move.turn * (*circle - *center) : move.to + move.turn * (*circle - move.from);
    }
    return found;
  }

  FourBarFamily::DyadPairsOfCells pairs_;
  std::vector<Moves> input_moves_, output_moves_;  ///< one for all columns, or one to each
  std::vector<Point> origins_;
  std::vector<LinkPositions> rows_, columns_;
};

}  // namespace

CellMeasure::Rows four_bar_errors(const FourBarFamily& family, const RegionMap& map, const Tolerances& tolerances) {
  const auto links = std::make_shared<const LinksOfCells>(family, map);
  const double scale = family.frame().scale;
  ToleranceErrorBlock blank{};
  blank.kind = links->is_function() ? ToleranceErrorBlock::angle : ToleranceErrorBlock::pose;
  blank.variances = variances_of(tolerances, scale);
  blank.turning_length = tolerances.turning_length.value_or(0) / scale;
  blank.positions = static_cast<int>(links->positions());
  for (std::size_t j = 0; j < links->positions() && !links->is_function(); ++j) {
    blank.point[j][0] = links->origin(j).real();
    blank.point[j][1] = links->origin(j).imag();
  }
  const double unit = links->is_function() ? degrees(1) : scale;
  return [links, blank, unit, &map](std::size_t row, std::span<float> values) {
    constexpr std::size_t size = ToleranceErrorBlock::size;
    ToleranceErrorBlock block = blank;
    for (std::size_t first = 0; first < values.size(); first += size) {
      const std::size_t count = std::min(size, values.size() - first);
      for (std::size_t lane = 0; lane < size; ++lane) {
        const auto [input, output] = links->at(row, first + std::min(lane, count - 1));
        put(input, links->positions(), lane, block.input_center, block.input_circle);
        put(output, links->positions(), lane, block.output_center, block.output_circle);
      }
      tolerance_error_kernel.for_simd(Simd::automatic)(block);
      for (std::size_t lane = 0; lane < count; ++lane) {
        const bool is_whole = map.type(map.index(row, first + lane)) != LinkageType::degenerate;
        values[first + lane] = is_whole ? static_cast<float>(unit * block.error[lane]) : 0.0F;
      }
    }
  };
}

}  // namespace linkwright
