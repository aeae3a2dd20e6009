#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "linkwright/analyses/spring_places.hpp"
#include "linkwright/files/number_text.hpp"
#include "report.hpp"
#include "text_table.hpp"

namespace linkwright::cli {
namespace {

std::string spoken(Point at) {
  return fmt::format("({}, {})", significant_text(at.real(), 5), significant_text(at.imag(), 5));
}

std::string spring_line(const Spring& spring, const std::string& unit) {
  const auto& gas = std::get<GasSpring>(spring.law);
  const std::string name = spring.name.empty() ? "Gas spring" : printable(spring.name);
  const std::string count = spring.count > 1 ? fmt::format(", {} side by side", spring.count) : "";
  return wrapped(fmt::format(
      "{}{}: from {} on the ground to {} on the body, extended length {}{}, stroke {}{}, F1 {} N, "
      "F2 {} N.",
      name, count, spoken(spring.from.at), spoken(spring.to.at), significant_text(gas.extended_length, 5), unit,
      significant_text(gas.stroke, 5), unit, significant_text(gas.f1, 4), significant_text(gas.f2, 4)));
}

std::string fit_table(const PlacedSpring& placed) {
  const bool is_whole = placed.parts->fit.size() + placed.parts->missed.size() == placed.catalogue.size();
  if (placed.parts->fit.empty())
    return is_whole ? "\nNone of the parts of the catalogue does.\n"
                    : "\nThe parts of the catalogue were not all looked at.\n";
  TextTable table({"<part", "F1, N", "hand, N", "would do from", "to", "<ground", "<body"});
  for (const PlacedPart& part : placed.parts->fit)
    table.add_row({printable(placed.catalogue[part.part].name),
                   significant_text(std::get<GasSpring>(part.spring.law).f1, 4),
                   significant_text(part.max_hand_force, 3), significant_text(part.low, 4),
                   std::isfinite(part.high) ? significant_text(part.high, 4) : "–", spoken(part.spring.from.at),
                   spoken(part.spring.to.at)});
  return "\nParts of the catalogue, the least force of the hand first:\n" + table.text();
}

std::string missed_words(const PlacedSpring& placed) {
  constexpr std::size_t most = 5;
  std::string text;
  for (std::size_t k = 0; k < std::min(most, placed.parts->missed.size()); ++k) {
    const MissedPart& part = placed.parts->missed[k];
    text += wrapped(fmt::format("{}: {}", printable(placed.catalogue[part.part].name), part.why.message));
  }
  return text.empty() ? text : "\nParts that do not do, the nearest first:\n" + text;
}

}  // namespace

std::string spring_words(const PlacedSpring& placed) {
  const std::string unit = placed.length_unit.empty() ? "" : " " + printable(placed.length_unit);
  std::string text = "\n";
  if (placed.place.found) {
    const SpringPlace& found = *placed.place.found;
    text += spring_line(found.spring, unit);
    text +=
        wrapped(fmt::format("Largest force of the hand: {:.2f} N; {:.2f} N at the stations, without friction of pins.",
                            found.max_hand_force, found.at_stations));
    text += wrapped(proof_words(found));
  } else {
    text += wrapped(placed.place.why_not->message);
  }
  return placed.parts ? text + fit_table(placed) + missed_words(placed) : text;
}

}  // namespace linkwright::cli
