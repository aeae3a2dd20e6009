#include "linkwright/mechanism/spherical_analysis.hpp"
#include "mechanism/spherical_travel.hpp"
#include "spherical/spherical_function_family.hpp"
#include "spherical_kind.hpp"

namespace linkwright {

Requirements with_defaults(Requirements wanted, const SphericalAnswer& /*known*/) {
  return with_default_angles(std::move(wanted));
}

Notice nothing_on_map(const SphericalAnswer& /*known*/, const RegionMap& /*map*/) {
  return {"no_pair", "No pair of dyads makes a four-bar: in every pair a link has no length.", {}};
}

LinkPolygon links_along(const SphericalAnswer& known, Side side) {
  LinkPolygon polygon;
  if (!known.family()) return polygon;
  for (const SphericalDyad& link : known.family()->polygon(side))
    append_link(polygon, link.coordinate, link.fixed_axis, link.moving_axis,
                known.family()->axis(Side::input).branches);
  return polygon;
}

ShownAxis shown_axis(const SphericalAnswer& known, Side side, int /*order*/, const ShownAxis* /*before*/) {
  return known.family() ? shown_by_samples(*known.family(), side, known.options.spacing) : ShownAxis{};
}

bool write_property(const SphericalFunctionAnswer& known, const ColouredMap& map, std::string_view property,
                    std::span<float> values) {
  if (property != "max_structural_error_deg" || !known.given.functions->has_function() || known.task.free) return false;
  structural_errors_deg(*known.given.functions, map.region, values);
  return true;
}

std::optional<SphericalSolution> solution_at(const SphericalMotionAnswer& known, MapPoint place, bool verify) {
  return linkage_at(known, place, verify);
}

std::optional<SphericalSolution> solution_at(const SphericalFunctionAnswer& known, MapPoint place, bool verify) {
  auto found = linkage_at(known, place, verify);
  if (found && known.given.functions) measure_function(*found, *known.given.functions);
  return found;
}

std::optional<Notice> spherical_defect(const DefectReport& report) {
  if (report.defects.none()) return std::nullopt;
  if (report.defects.circuit())
    return Notice{"spherical_circuit", "Circuit defect: some orientation needs taking it apart.", {}};
  if (report.defects.branch())
    return Notice{
        "spherical_branch", "Branch defect: it passes a dead point before it has passed all orientations.", {}};
  return Notice{"spherical_order", "Order defect: it comes to the orientations in another order.", {}};
}

void describe(PickedLinkage& picked, const SphericalAnswer& known, const SphericalSolution* found) {
  if (found == nullptr) {
    picked.reason = {"zero_link", "A link has no length: this is no four-bar.", {}};
    return;
  }
  picked.reason = spherical_defect(found->report);
  const auto orientations = known.family()->orientations(picked.place, found->four_bar);
  picked.travel = travel_of(analyze(found->four_bar, orientations), orientations.size());
}

double residual_of(const SphericalSolution& found) { return found.residual; }

const GeneratorFamily* generators_of(const SphericalFunctionAnswer& known) { return known.given.functions.get(); }

}  // namespace linkwright
