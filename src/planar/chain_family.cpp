#include "linkwright/planar/chain_family.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/planar/four_bar_map.hpp"
#include "linkwright/planar/six_bar_solution.hpp"
#include "planar/six_bar_rater.hpp"

namespace linkwright {
namespace {

MapAxis second_axis(const SixBarFamily& six_bars) {
  if (const AddedLinks* links = six_bars.independent_second())
    return {AxisQuantity::curve_coordinate, links->curve->branches()};
  return {AxisQuantity::curve_coordinate, {{"link_5", 0, 1}}};
}

/// The chain prescribes how the driver turns, whatever the added links are.
DriverTravel driver_travel(const SixBarFamily& family) {
  const BodyPositions& driver = family.bodies()[SixBar::driver];
  double ccw = 0, cw = 0;
  for (std::size_t j = 1; j < driver.at.size(); ++j) {
    const double turn = wrap_positive(std::arg(std::conj(driver.at[j - 1].turn) * driver.at[j].turn));
    ccw += turn;
    cw += turn > 0 ? two_pi - turn : 0;
  }
  const double from_first_to_last = wrap_positive(std::arg(driver.at.back().turn));
  return {ccw < cw ? DriverTravel::ccw : DriverTravel::cw, static_cast<float>(from_first_to_last)};
}

std::vector<std::optional<SixBarFamily::WithFirst>> first_links(const SixBarFamily& family,
                                                                std::span<const double> coordinates, int threads) {
  std::vector<std::optional<SixBarFamily::WithFirst>> links(coordinates.size());
  parallel_for(links.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) links[i] = family.with_first(coordinates[i]);
  });
  return links;
}

}  // namespace

ChainFamily::ChainFamily(const ThreeLinkChain& chain, std::array<BodyPair, 2> added,
                         std::array<BodyPositions, 4> bodies, const Pose& reference)
    : ChainFamily(chain, SixBarFamily(chain, added, bodies), reference) {}

ChainFamily::ChainFamily(const ThreeLinkChain& chain, SixBarFamily six_bars, const Pose& reference)
    : LinkageFamily({AxisQuantity::curve_coordinate, six_bars.first().curve->branches()}, second_axis(six_bars)),
      chain_(chain),
      six_bars_(std::move(six_bars)),
      reference_(reference) {}

std::shared_ptr<const ChainFamily> ChainFamily::of(const SixBarTask& task) {
  const auto bodies = task.chain ? chain_positions(task.poses, *task.chain) : std::nullopt;
  if (!bodies) return nullptr;
  return std::make_shared<ChainFamily>(*task.chain, task.added, *bodies, task.poses.front().pose);
}

const AddedLinks* ChainFamily::links(Side side) const {
  return side == Side::input ? &six_bars_.first() : six_bars_.independent_second();
}

std::optional<SixBarMember> ChainFamily::member(MapPoint point) const {
  const auto first = six_bars_.with_first(point.input);
  return first ? six_bars_.member(*first, six_bars_.second_tau(*first, point.output)) : std::nullopt;
}

MapPoint ChainFamily::point_of(const SixBarMember& member) const {
  const auto [tau_4, tau_5] = member.coordinates;
  const auto first = six_bars_.with_first(tau_4);
  return {tau_4, first ? six_bars_.second_coordinate(*first, tau_5) : tau_5};
}

std::vector<double> ChainFamily::samples(Side side, int count, Spacing /*spacing*/) const {
  std::vector<double> coordinates;
  for (int i = 0; i < count; ++i) coordinates.push_back(axis(side).coordinate_length() * (i + 0.5) / count);
  return coordinates;
}

std::optional<LinkageOutput> ChainFamily::output(MapPoint place) const {
  const auto found = member(place);
  return found ? std::optional(output_of(*found, reference_)) : std::nullopt;
}

std::function<std::optional<SixBarMember>(std::size_t row, std::size_t column)> ChainFamily::members_of(
    const RegionMap& map) const {
  return [this, &map, links = first_links(six_bars_, map.input_coordinates(), map.threads())](
             std::size_t row, std::size_t column) -> std::optional<SixBarMember> {
    const auto& first = links[row];
    if (!first) return std::nullopt;
    return six_bars_.member(*first, six_bars_.second_tau(*first, map.output_coordinates()[column]));
  };
}

LinkageFamily::OutputOfCells ChainFamily::outputs_of(const RegionMap& map) const {
  return [this, members = members_of(map)](std::size_t row, std::size_t column) -> std::optional<LinkageOutput> {
    const auto found = members(row, column);
    return found ? std::optional(output_of(*found, reference_)) : std::nullopt;
  };
}

MapPivots ChainFamily::pivots(const RegionMap& map) const {
  const auto of_cell = [members = members_of(map)](std::size_t row, std::size_t column) -> std::optional<Pivots> {
    const auto member = members(row, column);
    if (!member) return std::nullopt;
    Pivots pivots;
    for (const SixBarJoint& joint : member->six_bar.joints)
      (is_on_ground(joint) ? pivots.ground : pivots.moving).push_back(in_space(joint.point));
    return pivots;
  };
  return {{}, {}, of_cell};
}

void ChainFamily::fill(RegionMap& map, std::span<const double> input, std::span<const double> output,
                       bool /*respect_direction*/, const RegionOptions& options, const Progress& progress) const {
  const auto seconds = six_bars_.independent_hinges(output);
  const auto put_rows = [&](std::size_t first_row, std::span<MapCell> cells) {
    SixBarRater rater([&](std::size_t cell, const SixBarRating& rating) { cells[cell] = rating.cell(); }, options.simd);
    const std::size_t columns = output.size();
    for (std::size_t begin = 0; begin < cells.size() && !progress.is_cancelled(); begin += columns) {
      const auto first = six_bars_.with_first(input[first_row + begin / columns]);
      for (std::size_t k = 0; first && k < columns && !progress.is_cancelled(); ++k)
        if (const auto member = six_bars_.member(*first, output, seconds, k)) rater.add(begin + k, *member);
    }
    if (!progress.is_cancelled()) rater.finish();
  };
  map.evaluate_rows(input, output, planar_measures, driver_travel(six_bars_), put_rows, options, progress);
}

}  // namespace linkwright
