#include "linkwright/planar/chain_family.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

std::span<const Measure> ChainFamily::measures() const { return planar_measures; }

// A climb keeps to one number of branches of the curve of links 5.
LinkageFamily::CellAt ChainFamily::cells(bool /*respect_direction*/) const {
  return [this, first = std::optional<SixBarFamily::WithFirst>()](
             MapPoint place, const auto& is_worth_it) mutable -> std::optional<Cell> {
    if (!first || first->coordinate != place.input) first = six_bars_.with_first(place.input);
    const auto member = first ? six_bars_.member(*first, six_bars_.second_tau(*first, place.output)) : std::nullopt;
    if (!member) return std::nullopt;
    SixBarRating rating{shape_of(member->six_bar), {}};
    if (rating.shape.type == LinkageType::degenerate) return std::nullopt;
    rating.drive.min_sine = std::numeric_limits<double>::quiet_NaN();
    const auto rated = [&] {
      Cell cell = cell_of(member->six_bar, rating);
      cell.place = place;
      cell.hill = first->second->curve->branches().size();
      return cell;
    };
    if (!is_worth_it(rated())) return std::nullopt;
    rating = rating_of(*member, false);
    return rated();
  };
}

double ChainFamily::distance(const Pivots& one, const Pivots& other) const {
  double farthest = 0;
  for (const auto hinges : {&Pivots::ground, &Pivots::moving})
    for (std::size_t i = 0; i < (one.*hinges).size(); ++i)
      farthest = std::max(farthest, norm((one.*hinges)[i] - (other.*hinges)[i]));
  return farthest;
}

AxisStretch ChainFamily::stretch_around(Side side, MapPoint place) const {
  const auto branch = [](const BurmesterCurve& curve, double tau, double unit) {
    const bool has_length = curve.coordinate_length() > 0;  // a degenerate curve has no other places
    return AxisStretch{unit * std::floor(tau), unit * (std::floor(tau) + (has_length ? 1 : 0)), has_length};
  };
  if (side == Side::input) return branch(*six_bars_.first().curve, place.input, 1);
  const auto first = six_bars_.with_first(place.input);
  if (!first) return LinkageFamily::stretch_around(side, place);
  const BurmesterCurve& second = *first->second->curve;
  return branch(second, six_bars_.second_tau(*first, place.output),
                second_is_share() ? 1 / second.coordinate_length() : 1);
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
    return member ? std::optional(pivots_of(member->six_bar)) : std::nullopt;
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
