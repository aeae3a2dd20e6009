#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "function/generator_search.hpp"
#include "linkwright/solve/session.hpp"
#include "synthesis/kinds.hpp"

// What a session asks of the kinds of tasks, of what is known of a task before linkages are looked for. Where a kind
// has nothing to say, what holds for all of them (Findings) answers.
namespace linkwright {

/// What was known of the task with one problem's requirements and options is known with another's.
[[nodiscard]] bool serves(const Findings& known, const Problem& before, const Problem& now);
[[nodiscard]] bool serves(const MotionAnswer& known, const Problem& before, const Problem& now);
[[nodiscard]] bool serves(const StraightLineAnswer& known, const Problem& before, const Problem& now);

/// With the defaults of the kind filled in.
[[nodiscard]] Requirements with_defaults(Requirements wanted, const FourBarAnswer& known);
[[nodiscard]] Requirements with_defaults(Requirements wanted, const SixBarAnswer& known);
[[nodiscard]] Requirements with_defaults(Requirements wanted, const SphericalAnswer& known);
[[nodiscard]] Requirements with_defaults(Requirements wanted, const StraightLineAnswer& known);

/// Why there is no map.
[[nodiscard]] Notice no_map(const FourBarAnswer& known);
[[nodiscard]] Notice no_map(const SixBarAnswer& known);
[[nodiscard]] Notice no_map(const SphericalAnswer& known);
[[nodiscard]] Notice no_map(const StraightLineAnswer& known);
/// Why all of the map is degenerate.
[[nodiscard]] Notice nothing_on_map(const FourBarAnswer& known);
[[nodiscard]] Notice nothing_on_map(const SixBarAnswer& known);
[[nodiscard]] Notice nothing_on_map(const SphericalAnswer& known);
[[nodiscard]] Notice nothing_on_map(const StraightLineAnswer& known);

[[nodiscard]] LinkPolygon links_along(const FourBarAnswer& known, Side side);
[[nodiscard]] LinkPolygon links_along(const SixBarAnswer& known, Side side);
[[nodiscard]] LinkPolygon links_along(const SphericalAnswer& known, Side side);
[[nodiscard]] LinkPolygon links_along(const StraightLineAnswer& known, Side side);
void append_link(LinkPolygon& polygon, double coordinate, Vector3 fixed, Vector3 moving,
                 const std::vector<CurveBranch>& branches);
/// `polygon`: working frame of `frame`.
void append_links(LinkPolygon& polygon, std::span<const Dyad> links, const std::vector<CurveBranch>& branches,
                  const WorkingFrame& frame);

[[nodiscard]] std::vector<CurveMark> marks_of(const Findings& known);
[[nodiscard]] std::vector<CurveMark> marks_of(const MotionAnswer& known);

/// The axis as it is shown. `before`: as it was shown last, or null.
[[nodiscard]] ShownAxis shown_axis(const FourBarAnswer& known, Side side, int order, const ShownAxis* before);
[[nodiscard]] ShownAxis shown_axis(const SixBarAnswer& known, Side side, int order, const ShownAxis* before);
[[nodiscard]] ShownAxis shown_axis(const SphericalAnswer& known, Side side, int order, const ShownAxis* before);
[[nodiscard]] ShownAxis shown_axis(const StraightLineAnswer& known, Side side, int order, const ShownAxis* before);
/// In the order of its branches, evenly; through samples of the usual map, so that its cells are solve()'s.
[[nodiscard]] ShownAxis shown_by_branches(const LinkageFamily& family, Side side);
[[nodiscard]] ShownAxis shown_by_samples(const LinkageFamily& family, Side side, Spacing spacing);

/// Coordinates of the rows or columns that are asked for. `request`: as many samples as are computed.
[[nodiscard]] std::vector<double> coordinates_of(const Findings& known, const LinkageFamily& family,
                                                 const MapRequest& request, const ShownAxis& shown, Side side);
[[nodiscard]] std::vector<double> coordinates_of(const FourBarAnswer& known, const LinkageFamily& family,
                                                 const MapRequest& request, const ShownAxis& shown, Side side);
[[nodiscard]] std::vector<double> coordinates_of(const StraightLineAnswer& known, const LinkageFamily& family,
                                                 const MapRequest& request, const ShownAxis& shown, Side side);

/// As many samples as are asked for, where so many are soon computed.
[[nodiscard]] int live_samples(const Findings& known, int asked);
[[nodiscard]] int live_samples(const FunctionAnswer& known, int asked);
[[nodiscard]] int live_samples(const SixBarAnswer& known, int asked);
[[nodiscard]] int live_samples(const StraightLineAnswer& known, int asked);
/// The same of each map of a halo of so many places.
[[nodiscard]] int halo_samples(const Findings& known, int asked, std::size_t places);
[[nodiscard]] int halo_samples(const SixBarAnswer& known, int asked, std::size_t places);
/// SynthesisOptions::region_samples for the best of the usual map.
[[nodiscard]] int samples_for_best(const Findings& known);
[[nodiscard]] int samples_for_best(const StraightLineAnswer& known);
/// SynthesisOptions::window says how far the axes run, rather than what of them is looked at.
[[nodiscard]] bool window_sets_axes(const Findings& known);
[[nodiscard]] bool window_sets_axes(const StraightLineAnswer& known);

[[nodiscard]] std::vector<MissedBox> boxes_missed(const Findings& known);
[[nodiscard]] std::vector<MissedBox> boxes_missed(const FourBarAnswer& known);

/// Writes a property of the kind's own, by cell; false where it has none of this name.
bool write_property(const Findings& known, const ColouredMap& map, std::string_view property, std::span<float> values);
bool write_property(const MotionAnswer& known, const ColouredMap& map, std::string_view property,
                    std::span<float> values);
bool write_property(const FunctionAnswer& known, const ColouredMap& map, std::string_view property,
                    std::span<float> values);
bool write_property(const SphericalFunctionAnswer& known, const ColouredMap& map, std::string_view property,
                    std::span<float> values);

/// The linkage at a place, with `verify` driven through; nothing where there is none.
[[nodiscard]] std::optional<FourBarSolution> solution_at(const MotionAnswer& known, MapPoint place, bool verify);
[[nodiscard]] std::optional<FourBarSolution> solution_at(const FunctionAnswer& known, MapPoint place, bool verify);
[[nodiscard]] std::optional<SixBarSolution> solution_at(const SixBarAnswer& known, MapPoint place, bool verify);
[[nodiscard]] std::optional<SphericalSolution> solution_at(const SphericalMotionAnswer& known, MapPoint place,
                                                           bool verify);
[[nodiscard]] std::optional<SphericalSolution> solution_at(const SphericalFunctionAnswer& known, MapPoint place,
                                                           bool verify);
[[nodiscard]] std::optional<StraightLineSolution> solution_at(const StraightLineAnswer& known, MapPoint place,
                                                              bool verify);

/// Adds reason, travel and positions. Null: there is no linkage.
void describe(PickedLinkage& picked, const FourBarAnswer& known, const FourBarSolution* found);
void describe(PickedLinkage& picked, const SixBarAnswer& known, const SixBarSolution* found);
void describe(PickedLinkage& picked, const SphericalAnswer& known, const SphericalSolution* found);
void describe(PickedLinkage& picked, const StraightLineAnswer& known, const StraightLineSolution* found);

/// Why a driven linkage does not do its task; nothing without defects.
[[nodiscard]] std::optional<Notice> six_bar_defect(const SixBarDriveReport& drive);
[[nodiscard]] std::optional<Notice> spherical_defect(const DefectReport& report);

/// Where the cells of the map are estimated: measured exactly the linkage meets what is required.
[[nodiscard]] bool meets_exactly(const Findings& known, MapPoint place);
[[nodiscard]] bool meets_exactly(const StraightLineAnswer& known, MapPoint place);

/// User's unit.
[[nodiscard]] double residual_of(const FourBarSolution& found);
[[nodiscard]] double residual_of(const SixBarSolution& found);
[[nodiscard]] double residual_of(const SphericalSolution& found);
[[nodiscard]] double residual_of(const StraightLineSolution& found);

/// The family as one of linkages that generate a function; null where it is none.
[[nodiscard]] const GeneratorFamily* generators_of(const Findings& known);
[[nodiscard]] const GeneratorFamily* generators_of(const FunctionAnswer& known);
[[nodiscard]] const GeneratorFamily* generators_of(const SphericalFunctionAnswer& known);

}  // namespace linkwright
