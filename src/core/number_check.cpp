#include "number_check.hpp"

#include <cmath>
#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"

namespace linkwright {

void check_number(double value, std::string_view what, const std::string& place, std::vector<Error>& found) {
  if (std::abs(value) <= largest_coordinate) return;
  const std::string most = limit_text(largest_coordinate);
  found.push_back({"number_range",
                   place,
                   fmt::format("{0} must be a number between −{1} and {1}", what, most),
                   {{"name", what}, {"most", most}}});
}

void check_angle(double angle, std::string_view what, const std::string& place, std::vector<Error>& found) {
  if (!(std::abs(angle) <= radians(largest_coordinate))) check_number(degrees(angle), what, place, found);
}

}  // namespace linkwright
