#pragma once

#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/files/csv_table.hpp"
#include "linkwright/files/linkage_file.hpp"
#include "linkwright/files/spherical_file.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/six_bar.hpp"
#include "linkwright/mechanism/six_bar_motion.hpp"
#include "linkwright/planar/six_bar_solution.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright {

/// A six-bar as files carry it.
struct StoredSixBar {
  SixBar six_bar;                      ///< as it lies in position 1
  SixBarRow row;                       ///< how it is put together
  std::array<int, 4> assembly_mode{};  ///< of the chain, as ThreeLinkChain::assembly_mode
  std::string title, length_unit;      ///< empty when the file does not say
  std::vector<PrescribedPose> poses;   ///< empty when the file does not say
  std::string record;                  ///< the element of a result's `linkages` it came from, JSON text; or empty
};

using AnyStoredLinkage = std::variant<StoredLinkage, StoredSixBar, StoredSphericalFourBar>;

/// As read_linkage(), other linkages among them: an element of a result's `linkages`, or what write_linkage() wrote, or
/// `{"mechanism": "six_bar", "chain": {"a": [x, y], "b": …, "d": …}, "added": [{"between": "0-2", "points": [[x, y],
/// [x, y]]}, …]}`, or `{"mechanism": "spherical_four_bar", "axes": {"input_fixed": [x, y, z], "input_moving": …,
/// "output_moving": …, "output_fixed": …}}` (of any length), or `{"mechanism": "spherical_four_bar", "angles_deg":
/// {"ground": …, "input": …, "coupler": …, "output": …}}`, laid with the fixed axes (0, 0, 1) and (sin α₄, 0, cos α₄),
/// the input as that of a four-bar given by its lengths.
[[nodiscard]] Result<AnyStoredLinkage> read_any_linkage(std::string_view text);

/// As read_result_linkages(), other linkages among them.
[[nodiscard]] Result<std::vector<AnyStoredLinkage>> read_any_result_linkages(std::string_view text);

/// What can be taken out of a file.
struct LinkagesOfFile {
  std::vector<AnyStoredLinkage> linkages;
  bool is_result = false;  ///< as read_any_result_linkages(); else one linkage, as read_any_linkage()
};
[[nodiscard]] Result<LinkagesOfFile> read_linkages_of_file(std::string_view text);

/// The linkages of an answer, best first, as the result file carries them.
[[nodiscard]] std::vector<AnyStoredLinkage> stored_linkages(const Problem& problem, const Answer& answer);

/// As JSON text that read_any_linkage() reads back bit-identical.
[[nodiscard]] std::string write_linkage(const StoredSixBar& linkage);

/// A motion, a row a state: the driver's turn from position 1 in degrees, counter-clockwise positive; the seven hinges
/// and the moving frame in the fixed frame; the transmission angle (asin of SixBarTransmission::sine) in degrees; the
/// number of the pose that the body comes nearest to there, from 1, and how far it is from it, not defined between.
[[nodiscard]] MotionTable motion_columns(const SixBarMotion& motion);
/// The same as csv_text().
[[nodiscard]] std::string motion_table(const SixBarMotion& motion);

/// The poses, or where the file has none a moving frame in hinge d.
[[nodiscard]] std::vector<PrescribedPose> framed_poses(const StoredSixBar& linkage);

/// The analysis of a six-bar and the file that it came from.
struct StoredSixBarAnalysis : SixBarAnalysis {
  StoredSixBar linkage;
};
[[nodiscard]] StoredSixBarAnalysis analyze(const StoredSixBar& linkage);

/// As JSON text (schema/analysis.schema.json): angles in degrees with `_deg`, columns of the motion by name.
[[nodiscard]] std::string write_analysis(const StoredSixBarAnalysis& analysis);

}  // namespace linkwright
