#include "line_check.hpp"

#include <algorithm>

namespace linkwright::soak {
namespace {

using nlohmann::json;

constexpr double slack = 1e-6;  // of limits that a linkage may stand right on

double number(const json& object, const char* key) { return object[key].get<double>(); }

}  // namespace

std::vector<std::string> wrongs_of_line(const json& wanted, const json& options, const json& entry) {
  std::vector<std::string> wrongs;
  const json &tangent = entry["usable"], &strip = entry["usable_strip"], &over = entry["over_usable"];
  const double longest = std::max_element(entry["lengths"].begin(), entry["lengths"].end())->get<double>();
  for (const json* usable : {&tangent, &strip})
    if (!(number(*usable, "from_s") <= 0 && number(*usable, "to_s") >= 0 && number(*usable, "length") > 0))
      wrongs.push_back("a usable length does not hold the place where the linkage lies");
  if (number(strip, "length") < number(tangent, "length") * (1 - slack))
    wrongs.push_back("the strip is shorter than the tangent");
  if (!(number(over, "best_line_deviation") <= number(over, "parallel_line_deviation") * (1 + slack) &&
        number(over, "parallel_line_deviation") <= number(over, "max_deviation") * (1 + slack)))
    wrongs.push_back("a better line is worse");
  const bool by_strip = options.value("measure", "tangent") == "strip";
  const double off = number(over, by_strip ? "parallel_line_deviation" : "max_deviation");
  if (off > number(entry, "deviation") * (1 + slack)) wrongs.push_back("the usable length leaves its strip");
  if (number(by_strip ? strip : tangent, "length") < wanted.value("min_stroke", 0.0) * (1 - slack))
    wrongs.push_back("less than min_stroke");
  if (number(entry, "residual") > 0.1 * longest) wrongs.push_back("the point is off the line");
  return wrongs;
}

}  // namespace linkwright::soak
