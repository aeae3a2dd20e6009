#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "function/generator_search.hpp"
#include "linkwright/solve/session.hpp"
#include "linkwright/synthesis/answer.hpp"

// What holds for kinds of tasks that say nothing else (overloads on Findings; what each asks: kinds/kinds.hpp), and
// what several of them use.
namespace linkwright {

/// What was known of the task with one problem's requirements and options is known with another's.
[[nodiscard]] bool serves(const Findings& known, const Problem& before, const Problem& now);
void append_link(LinkPolygon& polygon, double coordinate, Vector3 fixed, Vector3 moving,
                 const std::vector<CurveBranch>& branches);
/// `polygon`: working frame of `frame`.
void append_links(LinkPolygon& polygon, std::span<const Dyad> links, const std::vector<CurveBranch>& branches,
                  const WorkingFrame& frame);
[[nodiscard]] std::vector<CurveMark> marks_of(const Findings& known);
/// In the order of its branches, evenly; through samples of the usual map, so that its cells are solve()'s.
[[nodiscard]] ShownAxis shown_by_branches(const LinkageFamily& family, Side side);
[[nodiscard]] ShownAxis shown_by_samples(const LinkageFamily& family, Side side, Spacing spacing);
/// Coordinates of the rows or columns that are asked for. `request`: as many samples as are computed.
[[nodiscard]] std::vector<double> coordinates_of(const Findings& known, const LinkageFamily& family,
                                                 const MapRequest& request, const ShownAxis& shown, Side side);
/// As many samples as are asked for, where so many are soon computed.
[[nodiscard]] int live_samples(const Findings& known, int asked);
/// The same of each map of a halo of so many places.
[[nodiscard]] int halo_samples(const Findings& known, int asked, std::size_t places);
/// SynthesisOptions::region_samples for the best of the usual map.
[[nodiscard]] int samples_for_best(const Findings& known);
/// SynthesisOptions::window says how far the axes run, rather than what of them is looked at.
[[nodiscard]] bool window_sets_axes(const Findings& known);
[[nodiscard]] std::vector<MissedBox> boxes_missed(const Findings& known);
/// Writes a property of the kind's own, by cell; false where it has none of this name.
bool write_property(const Findings& known, const ColouredMap& map, std::string_view property, std::span<float> values);
/// Where the cells of the map are estimated: measured exactly the linkage meets what is required.
[[nodiscard]] bool meets_exactly(const Findings& known, MapPoint place);
/// The family as one of linkages that generate a function; null where it is none.
[[nodiscard]] const GeneratorFamily* generators_of(const Findings& known);

}  // namespace linkwright
