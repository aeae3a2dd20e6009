#include "six_bar_map.hpp"

#include "linkwright/planar/pose_conditions.hpp"

namespace linkwright::wasm {
namespace {

DrawnCurves drawn_links(const AddedLinks& links) {
  if (links.curve->coordinate_length() == 0) return {};
  return drawn_dyads(links.curve->polygon(drawn_side), links.curve->branches(), links.conditions.frame);
}

}  // namespace

SixBarMap::SixBarMap(SixBarTask task) : task_(std::move(task)), family_(ChainFamily::of(task_)) {}

TaskFamily SixBarMap::given() const {
  TaskFamily given;
  given.pattern = pattern(task_.poses);
  given.conditions = pose_conditions(task_.poses);
  given.size = task_.chain ? task_.chain->size() : given.frame().scale;
  if (!family_)
    given.degeneracy =
        Notice{"chain_wanted", "No chain is given: place its three hinges, or let one be searched for.", {}};
  return given;
}

ShownAxes SixBarMap::axes() const {
  ShownAxes axes;
  axes.symmetric = false;
  if (!family_) return axes;
  axes.input.axis = family_->axis(Side::input);
  axes.output.axis = family_->axis(Side::output);
  axes.input.order = DisplayOrder(axes.input.axis.branches);
  axes.output.order = DisplayOrder(axes.output.axis.branches);
  return axes;
}

DrawnCurves SixBarMap::drawn(Side side) const {
  const AddedLinks* links = family_ ? family_->links(side) : nullptr;
  return links ? drawn_links(*links) : DrawnCurves{};
}

std::optional<SixBarSolution> SixBarMap::at(MapPoint point) const {
  const auto member = family_ ? family_->member(point) : std::nullopt;
  const auto row = six_bar_row(task_.added);
  if (!member || !row) return std::nullopt;
  return solution_of(task_.poses, *task_.chain, *row, *member);
}

}  // namespace linkwright::wasm
