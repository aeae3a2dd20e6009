#pragma once

#include <cstdint>
#include <string>

#include "linkwright/core/count_text.hpp"

namespace linkwright {

/// A finite double as the shortest decimal text that reads back as the same bits ("0.1", "1e+22", "-0.0").
[[nodiscard]] std::string exact_text(double value);

/// A number for people with a fixed count of decimals, 0…15; never "-0.0"; powers of ten above 1e15.
[[nodiscard]] std::string rounded_text(double value, int decimals);

/// A number for people with so many significant digits, without trailing zeros: "0.00213", "133.2"; whole numbers
/// in full up to 1e15.
[[nodiscard]] std::string significant_text(double value, int digits);
/// The same, with 0 for what is only rounding (1e-12) beside `size`.
[[nodiscard]] std::string significant_text(double value, int digits, double size);

/// Decimals with which lengths of about this size are told to people: four or five significant digits.
[[nodiscard]] int length_decimals(double typical_length);

/// The degrees with the shortest decimal text that radians() turns into exactly these radians, so that files echo the
/// angle that was given; the nearest degrees where no double does.
[[nodiscard]] double degrees_for_files(double angle);

}  // namespace linkwright
