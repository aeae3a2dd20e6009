#pragma once

#include <string>
#include <string_view>

namespace linkwright::wasm {

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
