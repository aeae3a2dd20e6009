#include <algorithm>
#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"
#include "report.hpp"
#include "text_table.hpp"

namespace linkwright::cli {
namespace {

constexpr int digits = 3;

std::string small_angle(double radians) { return significant_text(degrees(radians), digits) + "°"; }

std::string precision_text(const FunctionError& error) {
  return error.reaches_pairs ? small_angle(error.precision_error) : "not reached";
}

std::string reach_text(const FunctionError& error) {
  if (error.samples.empty()) return "–";  // only pairs are given
  if (error.unreached.empty()) return "whole range";
  std::string text = "not";
  for (const AngleRange& gap : error.unreached) text += fmt::format(" {}…{}", angle_text(gap.from), angle_text(gap.to));
  return text;
}

bool has_free_number(const LinkageFamily& family) {
  const AxisQuantity quantity = family.axis(Side::output).quantity;
  return quantity == AxisQuantity::output_scale || quantity == AxisQuantity::pair_output;
}

std::string free_text(const LinkageFamily& family, double tau) {
  const std::string value = significant_text(family.axis_value(Side::output, tau), 5);
  return family.axis(Side::output).quantity == AxisQuantity::pair_output ? value + "°" : "× " + value;
}

template <class KindAnswer>
std::string error_table(const KindAnswer& answer) {
  if (answer.linkages.empty()) return "";
  const auto& first = answer.linkages.front().function;
  if (!first) return "";
  const bool with_free = has_free_number(*answer.family());
  if (first->samples.empty() && !with_free) return "";  // only pairs, which are exact
  std::vector<std::string> headings = {"#", "at the pairs", "structural error", "at input", "<reach"};
  if (with_free) headings.insert(headings.begin() + 1, "output");
  TextTable table(headings);
  for (std::size_t i = 0; i < answer.linkages.size(); ++i) {
    const auto& found = answer.linkages[i];
    if (!found.function) continue;
    const FunctionError& error = *found.function;
    std::vector<std::string> cells = {fmt::format("{}", i + 1), precision_text(error),
                                      error.max_structural_error ? small_angle(*error.max_structural_error) : "–",
                                      error.max_structural_error ? angle_text(error.worst_input) : "–",
                                      reach_text(error)};
    if (with_free) cells.insert(cells.begin() + 1, free_text(*answer.family(), found.output.coordinate));
    table.add_row(std::move(cells));
  }
  return "Largest errors of the output, generated minus desired, over the range:\n" + table.text();
}

template <class KindAnswer>
std::string largest_at_pairs(const KindAnswer& answer) {
  double worst = 0;
  for (const auto& found : answer.linkages)
    if (found.function) worst = std::max(worst, found.function->precision_error);
  return fmt::format("the output is exact at every pair reached to {}", small_angle(worst));
}

}  // namespace

std::string function_error_words(const FourBarAnswer& answer) { return error_table(answer); }
std::string function_error_words(const SphericalAnswer& answer) { return error_table(answer); }
std::string precision_words(const FourBarAnswer& answer) { return largest_at_pairs(answer); }
std::string precision_words(const SphericalAnswer& answer) { return largest_at_pairs(answer); }

std::string function_map_words(const LinkageFamily& family, const RegionMap& map) {
  if (family.axis(Side::input).is_discrete()) return "The solution region of all linkages";
  return family.axis(Side::output).is_discrete()
             ? fmt::format("The curve of couplers, sampled at {} points,", map.rows())
             : fmt::format("The solution region of {} couplers × {} values of the free parameter", map.rows(),
                           map.columns());
}

std::string function_free_words(const LinkageFamily* family, const WantedFunction& wanted) {
  if (family == nullptr || position_count(wanted.pairs) == 5) return "";
  return wrapped(wanted.free ? "2 parameters are free, the axes of the solution region: the coupler's position on its "
                               "curve and the parameter left free in the task."
                             : "1 parameter is free: the coupler's position on its curve.");
}

}  // namespace linkwright::cli
