#include <algorithm>
#include <cmath>

#include "linkwright/planar/chain_family.hpp"
#include "linkwright/planar/six_bar_synthesis.hpp"
#include "six_bar_kind.hpp"

namespace linkwright {
namespace {

// What a cell takes in the page (docs/performance.md), and how long maps may take: one that follows the pointer, one at
// rest, all those of a halo. What is asked for is meant for four-bars, of which solve() takes four times as many, too.
constexpr double cell_us = 3;
constexpr double live_ms = 150, rest_ms = 600, halo_ms = 150;
constexpr int four_bar_samples_to_one = 4, least_of_map = 20, least_of_halo = 10;
constexpr int samples_of_the_usual_map = 400;

int samples_within(double ms, std::size_t maps = 1) {
  return static_cast<int>(std::sqrt(1000 * ms / (cell_us * static_cast<double>(maps))));
}

}  // namespace

Requirements with_defaults(Requirements wanted, const SixBarAnswer& known) {
  return with_default_lengths(std::move(wanted),
                              known.task.chain ? known.task.chain->size() : known.characteristic_length);
}

Notice no_map(const SixBarAnswer& /*known*/) {
  return {"chain_wanted", "No chain is given: place its three hinges, or let one be searched for.", {}};
}

Notice nothing_on_map(const SixBarAnswer& /*known*/, const RegionMap& /*map*/) {
  return {
      "no_pair",
      "No two added links make a six-bar of this chain: in every pair a hinge is at infinity or a link has no length.",
      {}};
}

LinkPolygon links_along(const SixBarAnswer& known, Side side) {
  LinkPolygon polygon;
  const AddedLinks* links = known.chain ? known.chain->links(side) : nullptr;
  if (links != nullptr && links->curve->coordinate_length() > 0)
    append_links(polygon, links->curve->polygon(drawn_side), links->curve->branches(), links->conditions.frame);
  return polygon;
}

ShownAxis shown_axis(const SixBarAnswer& known, Side side, int /*order*/, const ShownAxis* /*before*/) {
  return known.chain ? shown_by_branches(*known.chain, side) : ShownAxis{};
}

int live_samples(const SixBarAnswer& /*known*/, int asked) {
  const double ms = asked > samples_of_the_usual_map ? rest_ms : live_ms;
  return std::clamp(asked / four_bar_samples_to_one, least_of_map, samples_within(ms));
}

int halo_samples(const SixBarAnswer& /*known*/, int asked, std::size_t places) {
  return std::max(least_of_halo, std::min(asked, samples_within(halo_ms, places)));
}

std::optional<SixBarSolution> solution_at(const SixBarAnswer& known, MapPoint place, bool /*verify*/) {
  const auto member = known.chain ? known.chain->member(place) : std::nullopt;
  const auto row = six_bar_row(known.task.added);
  if (!member || !row) return std::nullopt;
  return solution_of(known.task.poses, *known.task.chain, *row, *member);
}

std::optional<Notice> six_bar_defect(const SixBarDriveReport& drive) {
  if (drive.completed && drive.defects.none()) return std::nullopt;
  if (drive.defects.circuit())
    return Notice{"six_bar_circuit", "Circuit defect: some position needs taking it apart.", {}};
  if (drive.defects.branch())
    return Notice{"six_bar_branch", "Branch defect: it passes a dead point before it has passed all positions.", {}};
  return Notice{"six_bar_order", "Order defect: it comes to the positions in another order.", {}};
}

void describe(PickedLinkage& picked, const SixBarAnswer& known, const SixBarSolution* found) {
  if (found == nullptr) {
    picked.reason = {
        "no_six_bar",
        "There is no six-bar here: an added link has no hinge, no length, or is one that is there already.",
        {}};
    return;
  }
  const SixBarDriveReport& drive = found->rating.drive;
  picked.reason = six_bar_defect(drive);
  const SixBar& six_bar = found->member.six_bar;
  const int sense = drive.sense == DriveSense::cw ? -1 : 1;
  picked.travel = travel_of(six_bar, known.task.poses, check_by_driving(six_bar, known.task.poses, sense), sense);
}

double residual_of(const SixBarSolution& found) { return found.residual * found.rating.shape.longest; }

}  // namespace linkwright
