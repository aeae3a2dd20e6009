#pragma once

#include <string>

#include "linkwright/files/angular_motion_file.hpp"
#include "linkwright/files/displacement_file.hpp"
#include "linkwright/files/link_chain_file.hpp"
#include "linkwright/files/orientation_file.hpp"
#include "linkwright/files/twist_file.hpp"

namespace linkwright::cli {

// Reports of `linkwright attitude` in words and tables for people; angles in degrees, at most 100 columns wide.

[[nodiscard]] std::string orientation_words(const OrientationReport& report);
[[nodiscard]] std::string displacement_words(const DisplacementReport& report);
[[nodiscard]] std::string twist_words(const TwistReport& report);
[[nodiscard]] std::string angular_motion_words(const AngularMotionReport& report);
[[nodiscard]] std::string link_chain_words(const LinkChainReport& report);

}  // namespace linkwright::cli
