#include "of_all_kinds.hpp"

#include <cmath>

namespace linkwright {
namespace {

constexpr int ticks_of_a_branch = 12;
constexpr int samples_of_a_map = 400;  // as solve() takes

std::uint8_t branch_of(const std::vector<CurveBranch>& branches, double coordinate) {
  std::uint8_t at = 0;
  for (std::size_t b = 0; b < branches.size(); ++b)
    if (coordinate >= branches[b].from && branches[b].from < branches[b].to) at = static_cast<std::uint8_t>(b);
  return at;
}

std::vector<std::array<double, 2>> axis_ticks(const LinkageFamily& family, Side side) {
  std::vector<std::array<double, 2>> ticks;
  const MapAxis& axis = family.axis(side);
  if (axis.quantity == AxisQuantity::curve_coordinate || axis.is_discrete()) return ticks;
  for (const CurveBranch& branch : axis.branches)
    for (int i = 0; i < ticks_of_a_branch; ++i) {
      const double coordinate = branch.from + (branch.to - branch.from) * i / ticks_of_a_branch;
      const double value = family.axis_value(side, coordinate);
      if (std::isfinite(value)) ticks.push_back({coordinate, value});
    }
  return ticks;
}

Vector3 unit_vector(Homogeneous point) {
  const Homogeneous unit = normalized(point);
  return {unit.w, unit.x, unit.y};
}

}  // namespace

bool serves(const Findings& /*known*/, const Problem& /*before*/, const Problem& /*now*/) { return true; }

void append_link(LinkPolygon& polygon, double coordinate, Vector3 fixed, Vector3 moving,
                 const std::vector<CurveBranch>& branches) {
  polygon.coordinate.push_back(coordinate);
  polygon.fixed.insert(polygon.fixed.end(), {fixed.x, fixed.y, fixed.z});
  polygon.moving.insert(polygon.moving.end(), {moving.x, moving.y, moving.z});
  polygon.branch.push_back(branch_of(branches, coordinate));
}

void append_links(LinkPolygon& polygon, std::span<const Dyad> links, const std::vector<CurveBranch>& branches,
                  const WorkingFrame& frame) {
  for (const Dyad& link : links) {
    const Dyad user = frame.to_user(link);
    append_link(polygon, link.coordinate, unit_vector(user.center), unit_vector(user.circle), branches);
  }
}

std::vector<CurveMark> marks_of(const Findings& /*known*/) { return {}; }

ShownAxis shown_by_branches(const LinkageFamily& family, Side side) {
  const MapAxis& axis = family.axis(side);
  return {axis, DisplayOrder(axis.branches), axis_ticks(family, side)};
}

ShownAxis shown_by_samples(const LinkageFamily& family, Side side, Spacing spacing) {
  ShownAxis shown = shown_by_branches(family, side);
  if (!shown.axis.is_discrete())
    shown.order = DisplayOrder(shown.axis.branches, family.samples(side, samples_of_a_map, spacing));
  return shown;
}

std::vector<double> coordinates_of(const Findings& /*known*/, const LinkageFamily& family, const MapRequest& request,
                                   const ShownAxis& shown, Side side) {
  if (shown.axis.is_discrete()) return family.samples(side, request.samples, Spacing::coordinate);
  const auto& [from, to] = side == Side::input ? request.input : request.output;
  return shown.order.samples(request.samples, from, to);
}

int live_samples(const Findings& /*known*/, int asked) { return asked; }
int halo_samples(const Findings& /*known*/, int asked, std::size_t /*places*/) { return asked; }
int samples_for_best(const Findings& /*known*/) { return samples_of_a_map; }
bool window_sets_axes(const Findings& /*known*/) { return false; }

std::vector<MissedBox> boxes_missed(const Findings& /*known*/) { return {}; }

bool write_property(const Findings& /*known*/, const ColouredMap& /*map*/, std::string_view /*property*/,
                    std::span<float> /*values*/) {
  return false;
}

bool meets_exactly(const Findings& /*known*/, MapPoint /*place*/) { return false; }

const GeneratorFamily* generators_of(const Findings& /*known*/) { return nullptr; }

}  // namespace linkwright
