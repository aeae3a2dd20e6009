#include "linkwright/files/length_unit.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <string>

#include "files/text/plain_text.hpp"
#include "linkwright/files/nearest_name.hpp"

namespace linkwright {
namespace {

struct NamedUnit {
  LengthUnit unit;
  std::string_view names;  ///< in small letters, each between two blanks
};

constexpr std::array<NamedUnit, 12> known_units = {
    {{{1e-3, 13}, " µm μm um micron microns micrometre micrometres micrometer micrometers 微米 "},
     {{1, 4}, " mm millimetre millimetres millimeter millimeters 毫米 "},
     {{10, 5}, " cm centimetre centimetres centimeter centimeters 厘米 "},
     {{100, 14}, " dm decimetre decimetres decimeter decimeters 分米 "},
     {{1000, 6}, " m metre metres meter meters 米 "},
     {{1e6, 7}, " km kilometre kilometres kilometer kilometers 千米 "},
     {{25.4e-6, 8}, " µin μin uin microinch microinches "},
     {{0.0254, 9}, " mil mils thou "},
     {{25.4, 1}, " in inch inches \" ″ ” 英寸 "},
     {{304.8, 2}, " ft foot feet ' ′ ’ 英尺 "},
     {{914.4, 10}, " yd yard yards 码 "},
     {{1609344, 3}, " mi mile miles 英里 "}}};

template <class IsMeant>
std::optional<LengthUnit> first_unit(const IsMeant& is_meant) {
  const auto found = std::find_if(known_units.begin(), known_units.end(), is_meant);
  return found == known_units.end() ? std::nullopt : std::optional(found->unit);
}

}  // namespace

std::optional<LengthUnit> length_unit(std::string_view name) {
  std::string written = in_small_letters(name);
  if (written.ends_with('.')) written.pop_back();
  if (written.empty() || written.find(' ') != std::string::npos) return std::nullopt;
  return first_unit(
      [&](const NamedUnit& one) { return one.names.find(' ' + written + ' ') != std::string_view::npos; });
}

std::optional<LengthUnit> length_unit(int insunits) {
  return first_unit([&](const NamedUnit& one) { return one.unit.insunits == insunits; });
}

std::optional<double> millimetres(std::string_view unit) {
  const auto known_unit = length_unit(unit);
  return known_unit ? std::optional(known_unit->mm) : std::nullopt;
}

std::string spoken_unit(std::string_view unit) { return unit == "in" ? "inches" : std::string(unit); }

std::string unit_warning(std::string_view unit, std::string_view consequence) {
  if (length_unit(unit)) return "";
  return fmt::format(
      "{}, so that {}",
      unit.empty() ? "no unit of length is given" : "the unit of length " + in_quotes(unit) + " is not known",
      consequence);
}

}  // namespace linkwright
