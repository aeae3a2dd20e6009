#include "planar/four_bar_cells.hpp"

#include "linkwright/core/angle.hpp"
#include "linkwright/region/region_map.hpp"

namespace linkwright {

FourBarCells::FourBarCells(const FourBarFamily& family, const RegionMap& map, const std::vector<PrescribedPose>& poses)
    : frame_(family.frame()), pairs_(family.dyad_pairs_of_cells(map.input_coordinates(), map.output_coordinates())) {
  Moves moves;
  for (const PrescribedPose& there : poses) {
    const Pose &first = poses.front().pose, &pose = there.pose;
    moves.push_back({direction(pose.angle - first.angle), first.origin, pose.origin, false});
    origins_.push_back(pose.origin);
  }
  input_moves_ = output_moves_ = {moves};
  for (const Dyad& link : family.dyads(Side::input, map.input_coordinates())) rows_.push_back(moved(link, moves));
  for (const Dyad& link : family.dyads(Side::output, map.output_coordinates())) columns_.push_back(moved(link, moves));
}

FourBarCells::FourBarCells(const FourBarFamily& family, const RegionMap& map,
                           const std::vector<std::vector<AnglePair>>& pairs)
    : frame_(family.frame()), pairs_(family.dyad_pairs_of_cells(map.input_coordinates(), map.output_coordinates())) {
  for (const std::vector<AnglePair>& of_column : pairs) {
    Moves inputs, outputs;
    for (const AnglePair& pair : of_column) {
      inputs.push_back({direction(pair.input - of_column.front().input), {}, {}, true});
      outputs.push_back({direction(pair.output - of_column.front().output), {}, {}, true});
    }
    input_moves_.push_back(std::move(inputs));
    output_moves_.push_back(std::move(outputs));
  }
}

std::pair<LinkPositions, LinkPositions> FourBarCells::at(std::size_t row, std::size_t column) const {
  if (!rows_.empty()) return {rows_[row], columns_[column]};
  const auto pair = pairs_(row, column);
  if (!pair) return {};
  const std::size_t moves = input_moves_.size() == 1 ? 0 : column;
  return {moved(pair->input, input_moves_[moves]), moved(pair->output, output_moves_[moves])};
}

LinkPositions FourBarCells::moved(const Dyad& link, const Moves& moves) {
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

}  // namespace linkwright
