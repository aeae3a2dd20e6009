#include <algorithm>
#include <array>
#include <cmath>

#include "linkwright/region/cell_judge.hpp"
#include "straight_line/line_travel.hpp"
#include "straight_line_kind.hpp"

namespace linkwright {
namespace {

constexpr int samples_of_line_map = 200;  // the path of every cell is traced

bool are_same(const std::optional<MapWindow>& a, const std::optional<MapWindow>& b) {
  return a.has_value() == b.has_value() && (!a || (a->input == b->input && a->output == b->output));
}

}  // namespace

bool serves(const StraightLineAnswer& /*known*/, const Problem& before, const Problem& now) {
  return before.options.line == now.options.line && are_same(before.options.window, now.options.window);
}

Requirements with_defaults(Requirements wanted, const StraightLineAnswer& known) {
  return with_default_length(std::move(wanted), known.task);
}

Notice no_map(const StraightLineAnswer& known) { return no_straight_line(known.task); }

// Of a few linkages their grounded links, one to each layer; otherwise none, as none depends on its own coordinate
// alone.
LinkPolygon links_along(const StraightLineAnswer& known, Side side) {
  LinkPolygon polygon;
  if (!known.lines || !known.lines->axis(Side::input).is_discrete()) return polygon;
  std::vector<Dyad> links;
  for (int layer = 0; layer < known.lines->layers(); ++layer) {
    const auto place = static_cast<double>(layer);
    const LineDesign design = known.lines->design({place, 0});
    if (design.kind != DesignKind::four_bar) continue;
    const FourBar& bars = design.linkage.bars;
    const auto homogeneous = [](Point p) { return Homogeneous{1, p.real(), p.imag()}; };
    links.push_back(side == Side::input ? Dyad{homogeneous(bars.input_fixed), homogeneous(bars.input_moving), place}
                                        : Dyad{homogeneous(bars.output_fixed), homogeneous(bars.output_moving), place});
  }
  append_links(polygon, links, known.lines->axis(Side::input).branches, {});
  return polygon;
}

ShownAxis shown_axis(const StraightLineAnswer& known, Side side, int /*order*/, const ShownAxis* /*before*/) {
  return known.lines ? shown_by_branches(*known.lines, side) : ShownAxis{};
}

std::vector<double> coordinates_of(const StraightLineAnswer& known, const LinkageFamily& family,
                                   const MapRequest& request, const ShownAxis& shown, Side side) {
  // All layers together have about as many cells as one that is looked at alone.
  const int layers = request.input == MapRequest::whole ? known.lines->layers() : 1;
  MapRequest of_layer = request;
  of_layer.samples = static_cast<int>(std::lround(request.samples / std::sqrt(layers)));
  if (side == Side::input && !shown.axis.is_discrete()) of_layer.samples *= layers;
  return coordinates_of(static_cast<const Findings&>(known), family, of_layer, shown, side);
}

int live_samples(const StraightLineAnswer& /*known*/, int asked) { return std::min(asked, samples_of_line_map); }

int samples_for_best(const StraightLineAnswer& /*known*/) { return samples_of_line_map; }

bool window_sets_axes(const StraightLineAnswer& /*known*/) { return true; }

std::optional<StraightLineSolution> solution_at(const StraightLineAnswer& known, MapPoint place, bool /*verify*/) {
  return known.lines ? make_straight_line(*known.lines, place) : std::nullopt;
}

void describe(PickedLinkage& picked, const StraightLineAnswer& known, const StraightLineSolution* found) {
  if (found != nullptr) {
    picked.travel = travel_of(*known.lines, *found);
    if (found->defects.none()) return;
    const auto& contacts = std::get<straight_cases::MixedContacts>(known.task.given).contacts;
    const auto poses = contact_poses(found->linkage, known.task.line, contacts);
    picked.reason = defect_notice(found->defects, pose_visits(found->linkage.bars, poses));
  } else if (known.lines->design(picked.place).kind == DesignKind::slider) {
    picked.reason = {
        "slider_in_straight_line", "Slider: a pivot is at infinity; a slider takes the place of a link.", {}};
  } else {
    picked.reason = {
        "nothing_in_straight_line",
        "There is no linkage here: the equations of this case have no real solution, or a link has no length.",
        {}};
  }
}

bool meets_exactly(const StraightLineAnswer& known, MapPoint place) {
  const auto cell = known.lines->cell(place);
  return cell && CellJudge(known.requirements, known.lines->linkages(), known.lines->measures()).passes(*cell);
}

double residual_of(const StraightLineSolution& found) { return found.residual; }

}  // namespace linkwright
