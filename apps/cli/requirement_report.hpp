#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/synthesis/solve.hpp"

namespace linkwright::cli {

/// "x −450…60, y −220…−30".
[[nodiscard]] std::string box_words(const Box& box);
/// "30° of (0, 0, 1)".
[[nodiscard]] std::string cone_words(const Cone& cone);

/// The requirements of the class in plain words, "no defects, transmission angle at least 30°, …". `position`: in which
/// the moving pivots are told, from 1.
[[nodiscard]] std::string requirement_words(const Requirements& requirements, const LinkageClass& asked,
                                            std::string_view unit, int position = 1);

/// The limits at which a linkage lies (to half a percent), in words.
[[nodiscard]] std::vector<std::string> limits_touched(const Requirements& requirements, const FourBarSolution& found,
                                                      std::string_view unit);

/// Of a six-bar; `search`: the box in which its hinges were looked for.
[[nodiscard]] std::vector<std::string> limits_touched(const Requirements& requirements, const SixBarSolution& found,
                                                      const std::optional<Box>& search, std::string_view unit);

/// Of a spherical four-bar.
[[nodiscard]] std::vector<std::string> limits_touched(const Requirements& requirements, const SphericalSolution& found);

/// "touches no limit: …", or at which it lies.
[[nodiscard]] std::string held_back_words(const std::vector<std::string>& limits);

/// "a transmission angle of at least 24° would leave 112", or what dropping the requirement would.
[[nodiscard]] std::string relaxation_words(const Relaxation& relaxation, std::string_view unit);

}  // namespace linkwright::cli
