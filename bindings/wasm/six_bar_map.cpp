#include "six_bar_map.hpp"

#include "linkwright/planar/pose_conditions.hpp"

namespace linkwright::wasm {
namespace {

std::unique_ptr<const SixBarFamily> family_of(const SixBarTask& task) {
  if (!task.chain) return nullptr;
  const auto bodies = chain_positions(task.poses, *task.chain);
  if (!bodies) return nullptr;
  return std::make_unique<SixBarFamily>(*task.chain, task.added, *bodies);
}

DrawnCurves drawn_links(const AddedLinks& links) {
  if (links.curve->coordinate_length() == 0) return {};
  return drawn_dyads(links.curve->polygon(drawn_side), links.curve->branches(), links.conditions.frame);
}

}  // namespace

SixBarMap::SixBarMap(SixBarTask task) : task_(std::move(task)), family_(family_of(task_)) {}

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
  axes.input.axis.branches = family_->first().curve->branches();
  const auto first = family_->second_depends_on_first() ? std::nullopt : family_->with_first(0.1);
  axes.output.axis.branches =
      first ? first->second->curve->branches() : std::vector<CurveBranch>{{"link_5", 0, family_->second_axis_length()}};
  axes.input.order = DisplayOrder(axes.input.axis.branches);
  axes.output.order = DisplayOrder(axes.output.axis.branches);
  return axes;
}

DrawnCurves SixBarMap::drawn(Side side) const {
  if (!family_) return {};
  if (side == Side::input) return drawn_links(family_->first());
  const auto first = family_->second_depends_on_first() ? std::nullopt : family_->with_first(0.1);
  return first ? drawn_links(*first->second) : DrawnCurves{};
}

void SixBarMap::classify(RegionMap& map, std::span<const double> first, std::span<const double> second) const {
  constexpr bool circuits = false;  // takes a walk round the whole circuit
  classify_six_bars(map, *family_, first, second, circuits);
}

RequirementFilter SixBarMap::filter(const RegionMap& map, const Requirements& wanted) const {
  return filter_of_six_bars(*family_, map, wanted);
}

std::optional<std::array<double, 2>> SixBarMap::improved(std::array<double, 2> place, const Requirements& wanted,
                                                         Objective objective) const {
  return family_ ? improved_six_bar(*task_.chain, *family_, wanted, objective, place) : std::nullopt;
}

std::optional<SixBarSolution> SixBarMap::at(double first, double second) const {
  const auto with = family_ ? family_->with_first(first) : std::nullopt;
  const auto member = with ? family_->member(*with, family_->second_tau(*with, second)) : std::nullopt;
  const auto row = six_bar_row(task_.added);
  if (!member || !row) return std::nullopt;
  return solution_of(task_.poses, *task_.chain, *row, *member);
}

std::array<double, 2> SixBarMap::place_of(const SixBarSolution& found) const {
  const auto [first, second] = found.member.coordinates;
  const auto with = family_ ? family_->with_first(first) : std::nullopt;
  return {first, with ? family_->second_coordinate(*with, second) : second};
}

}  // namespace linkwright::wasm
