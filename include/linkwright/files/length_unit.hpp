#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace linkwright {

/// A unit of length that drawings and models can be given in.
struct LengthUnit {
  double mm;     ///< millimetres to it
  int insunits;  ///< its number in DXF drawings, $INSUNITS
};

/// The unit that is meant by a name, whatever its capitals: its symbol (µm, mm, cm, dm, m, km, mil, in, ", ft, ', yd)
/// or its name in English, singular or plural, or in Chinese.
[[nodiscard]] std::optional<LengthUnit> length_unit(std::string_view name);

/// The unit of this number in DXF drawings.
[[nodiscard]] std::optional<LengthUnit> length_unit(int insunits);

/// Millimetres to a unit that is known by its name.
[[nodiscard]] std::optional<double> millimetres(std::string_view unit);

/// The unit as one says it after "in": "in" itself is "inches".
[[nodiscard]] std::string spoken_unit(std::string_view unit);

/// What a file says before it is written in a unit that is missing or not known: why, and what follows ("lengths are
/// taken for millimetres"). Empty where the unit is known.
[[nodiscard]] std::string unit_warning(std::string_view unit, std::string_view consequence);

}  // namespace linkwright
