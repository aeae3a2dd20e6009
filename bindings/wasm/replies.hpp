#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/loads/spring_place.hpp"
#include "linkwright/machine/machine.hpp"
#include "linkwright/mechanism/linkage_output.hpp"
#include "linkwright/solve/session.hpp"
#include "machine/linkage_loads.hpp"
#include "reply_fields.hpp"

// What the page gets, as JSON text and columns of numbers (web/src/contract, web/src/engine/adapter.ts).
namespace linkwright::wasm {

/// TaskAnswer without its arrays, after a map was asked for.
[[nodiscard]] std::string task_reply(Session& session);
/// A linkage, the object of the result file with what else the page shows of it, and its drive.
struct LinkageReply {
  std::string linkage;  ///< JSON text; empty: the task has no map
  /// Rows of state_columns; of a six-bar followed by x and y of each hinge, of spherical four-bars by the input's and
  /// the output's moving axis and the coupler's turn from position 1 as a quaternion (w, x, y, z).
  std::vector<double> states;
  std::string tolerance;  ///< JSON text; empty without tolerances and at a dead point
};
/// What a state has whatever the kind of linkage: the driver's angle from position 1, in the sense of travel positive;
/// the moving pivots of input and output; the pose of the moving frame; the angles of coupler and output from
/// position 1; dψ/dφ, output by input, 0 at a dead point; output torque over input torque, |dφ/dψ|, 0 where unbounded.
inline constexpr std::array state_columns = {"input_deg",
                                             "ax",
                                             "ay",
                                             "bx",
                                             "by",
                                             "x",
                                             "y",
                                             "theta_deg",
                                             "transmission_angle_deg",
                                             "coupler_deg",
                                             "output_deg",
                                             "velocity_ratio",
                                             "mechanical_advantage"};
inline constexpr std::size_t state_width = state_columns.size(),
                             six_bar_state_width = state_width + 2 * SixBar::joint_count,
                             spherical_state_width = state_width + 10;
[[nodiscard]] LinkageReply linkage_reply(Session& session, MapPoint place);
/// `record`: the object of the result file, empty for none.
[[nodiscard]] LinkageReply linkage_reply(const PickedLinkage& picked, std::string record, LinkageMore more);
/// What a kind of linkage has.
[[nodiscard]] LinkageMore more_of(const SixBar& six_bar);
[[nodiscard]] LinkageMore more_of(const LinkAngles& angles);

/// The best of the usual map, and what its list is to be read with.
[[nodiscard]] std::string best_reply(const Session& session, int most);

/// The linkage of a problem of the page whose task is one, `{"kind": "linkage", "mechanism", "file": what a linkage
/// file has}`, or its mistakes; nothing where the task is another.
[[nodiscard]] std::optional<Result<AnyStoredLinkage>> opened_linkage(std::string_view text);
/// It and its drive over the whole travel, with `rates`: by state how its bodies and the point move (Rates of the
/// page).
[[nodiscard]] LinkageReply opened_reply(const AnyStoredLinkage& linkage);
[[nodiscard]] Travel opened_travel(const AnyStoredLinkage& linkage);
/// The path of a point of its body (as it lies in position 1) over that travel; about a centre none.
[[nodiscard]] std::vector<Point> opened_trace(const AnyStoredLinkage& linkage, Point traced);

/// What tolerances do to one linkage, and some of the linkages made.
struct ToleranceReply {
  std::string report;  ///< JSON text: ToleranceAnswer of the protocol; empty at a dead point
  /// By sample, position, joint: x and y, on the sphere x, y, z. Joints: of four-bars input's fixed and moving pivot,
  /// output's moving and fixed pivot, in the plane and the body's origin; of six-bars their seven hinges and the body's
  /// origin.
  std::vector<double> drawn;
};
/// `drawn`: how many samples; of a straight line at its ends and in the middle. The turning length of the tolerances is
/// set.
[[nodiscard]] ToleranceReply tolerance_reply(const LinkageOutput& output, const Tolerances& tolerances, int bins,
                                             int drawn);
/// The same before it is looked at closely: `tolerance` of a result's linkages, by few samples; empty at a dead point.
[[nodiscard]] std::string tolerance_at_a_glance(const LinkageOutput& output, const Tolerances& tolerances);

/// What loads do to one linkage, with its curves; empty where it does not get through its positions in order.
[[nodiscard]] std::string loads_reply(const LinkageLoads& on);

/// The spring of a file of boxes placed for a linkage: JSON text {"placed": what write_placed_spring() has, "why_not":
/// worded, where there is none}, or {"mistakes"}. `most_boxes`: at which the proof is given up; 0: there is none.
/// docs/theory/loads.md.
[[nodiscard]] std::string place_spring_reply(const LinkageLoads& on, std::string_view boxes, std::size_t most_boxes);
/// The least largest hand force over the box of one stud, the other in the middle of its box: {"columns", "rows",
/// "force": by rows from low y to high y, null where nothing can be built}, or {"mistakes"}.
[[nodiscard]] std::string stud_map_reply(const LinkageLoads& on, std::string_view boxes, Stud over, int columns,
                                         int rows);

/// A longer search for the linkages of a problem file that come near its points or poses (FitEffort::deep):
/// FitSearchReply, or {"mistakes"}. `progress` is told of it.
[[nodiscard]] std::string fit_search_reply(std::string_view problem, const Progress& progress);

/// A linkage as one builds it, to be looked at before it is made.
struct MachineReply {
  std::string plan;                      ///< JSON text: a MachinePlan; or {"mistakes"}, and nothing else
  std::vector<float> vertices;           ///< x, y, z as they lie in position 1, user's unit
  std::vector<std::uint32_t> triangles;  ///< three of these vertices each, part by part
  /// By rising driver angle, all states on which the plan stands: the angle (degrees, as drives have it), then of each
  /// body but the ground its displacement from position 1, a quaternion (w, x, y, z) and a translation.
  /// The quaternion's sign runs on from row to row, from w > 0 in position 1.
  std::vector<double> travel;
};
/// `drive`: by which the page drives it.
[[nodiscard]] MachineReply machine_reply(const Result<Machine>& made, const Travel& drive);

/// One instant of a planar four-bar as the page draws it: of {"pivots": {…}} as linkage files have them, the object
/// `instant` of an analysis, and beside it `circling_points` and `centering_points`, lists of polylines [[x, y], …]
/// about the linkage up to ten times its size. In place of it {"mistakes": […]}.
[[nodiscard]] std::string instant_reply(std::string_view text);

/// The shapes of a drawing as outlines of a body: of {"format", "length_unit", "size"} (that of the task, and about how
/// large its body may be) and the "text" of a `dxf`, or the "elements" of an `svg` in their order, each [index of the
/// one around it, name, attributes], the outermost one's index -1. In place of them {"mistakes": […]}.
[[nodiscard]] std::string outlines_reply(std::string_view text);

/// What the page shows of an attitude, which is no linkage and has no session: JSON text to JSON text, each an object
/// with the reports of `linkwright attitude` as they are written to files. In place of them {"mistakes": […]}, their
/// places `task.…`.
///
/// `of` "orientation": {"orientation", "turn"} → `convert`, the report on it. An orientation is one of
/// orientation_file.hpp; the optional `turn` {"axis", "angle_deg"} is made after it, about axes that it carries along.
///
/// `of` "attitude": these, and "sequence", "turning", "vector" (to be turned), "from" {"orientation", "translation"}
/// and "translation" (the first pose, and where the body's origin is in the second), "rates_deg" (of the sequence's
/// angles), "at" {"turns" in [0, 3], "rotation", "screw" in [0, 1]}: how far each is played. To it `convert` and
///
/// - `turns`: `angles_deg` (as given, where the orientation is given by this sequence), `given`, `locked`, `near_lock`,
///   `lock_distance`, `determined` as in `convert`, `frames` (after each turn), `axes` (of the turns, as they stand at
///   last), `now` {`frame`, `axes`};
/// - `rotation`: `path` (of the vector), `now` {`frame`, `vector`};
/// - `screw` (report), `motion` {`path` (of the body's origin), `from`, `now` (poses, 4×4)};
/// - `rates` (report), `rate_matrix`.
[[nodiscard]] std::string attitude_reply(std::string_view of, std::string_view text);

}  // namespace linkwright::wasm
