#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/attitude/hartenberg_denavit.hpp"
#include "linkwright/attitude/screw.hpp"
#include "linkwright/core/result.hpp"

namespace linkwright {

/// What `linkwright attitude dh` reads: schema/attitude.schema.json. Angles in radians here, degrees in the file.
struct LinkChainTask {
  std::string length_unit;  ///< echoed, never converted
  HartenbergDenavitForm form = HartenbergDenavitForm::classic;
  std::vector<HartenbergDenavit> links;
  std::vector<Vector3> points;  ///< in the frame of the last link
  /// Instead of links: a displacement whose four parameters are asked for.
  std::optional<Displacement> displacement;
};

/// `{"linkwright": 1, "form": "classic" | "modified", "links": [{"theta_deg", "d", "a", "alpha_deg"}, …], "points":
/// [[x, y, z], …]}`, what is missing of a link is 0; or `displacement` (as in displacement_file.hpp) instead of
/// `links`.
[[nodiscard]] Result<LinkChainTask> read_link_chain_task(std::string_view text);

struct LinkChainReport {
  LinkChainTask task;
  std::vector<Displacement> joints;  ///< T_{j−1,j}
  std::vector<Displacement> frames;  ///< T_0j; the last one is the tip
  Screw tip;                         ///< the displacement of the last frame as one screw
  std::vector<Vector3> points;       ///< the task's points in frame 0
  std::optional<HartenbergDenavitFit> fit;
};

/// Errors: those of hartenberg_denavit_frames().
[[nodiscard]] Result<LinkChainReport> link_chain_report(const LinkChainTask& task);

[[nodiscard]] std::string write_link_chain_report(const LinkChainReport& report);

/// "classic", "modified".
[[nodiscard]] std::string_view name(HartenbergDenavitForm form);

}  // namespace linkwright
