#include "linkwright/files/label.hpp"

#include <array>
#include <fmt/format.h>
#include <utility>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {
namespace {

constexpr std::array<std::string_view, linkage_type_count> type_labels = {"Crank-rocker",
                                                                          "Rocker-crank",
                                                                          "Double crank",
                                                                          "Double rocker",
                                                                          "Triple rocker, ground longest",
                                                                          "Triple rocker, input longest",
                                                                          "Triple rocker, coupler longest",
                                                                          "Triple rocker, output longest",
                                                                          "Change point",
                                                                          "Slider or zero link",
                                                                          "Triple rocker"};

constexpr std::array<std::string_view, linkage_type_count> short_type_labels = {
    "Crank-rocker",          "Rocker-crank",         "Double crank",           "Double rocker",
    "Triple rocker, ground", "Triple rocker, input", "Triple rocker, coupler", "Triple rocker, output",
    "Change point",          "Slider or zero link",  "Triple rocker"};

constexpr std::array<std::string_view, 4> sense_labels = {"", "counter-clockwise", "clockwise", "either way"};

constexpr std::array<std::string_view, 4> topology_labels = {"Watt I", "Stephenson I", "Stephenson II",
                                                             "Stephenson III"};

constexpr std::array<std::string_view, 9> cubic_labels = {"one branch",
                                                          "two branches",
                                                          "one branch with a node",
                                                          "a line and a circle",
                                                          "a line and an isolated point",
                                                          "the line at infinity and a conic",
                                                          "the line at infinity and two lines",
                                                          "a line",
                                                          "every point"};

constexpr std::array<std::string_view, 6> cone_labels = {"a cubic cone of one component",
                                                         "a cubic cone of two components",
                                                         "a cubic cone with a node",
                                                         "a plane and a quadratic cone",
                                                         "planes",
                                                         "every axis"};

constexpr std::array<std::string_view, 7> change_point_labels = {"",
                                                                 "crank-rocker at its limit (input shortest)",
                                                                 "rocker-crank at its limit (output shortest)",
                                                                 "double crank at its limit (ground shortest)",
                                                                 "double rocker at its limit (coupler shortest)",
                                                                 "parallelogram or kite",
                                                                 "rhombus"};

constexpr std::array<std::pair<std::string_view, std::string_view>, 23> branch_labels = {{
    {"odd", "branch through infinity"},
    {"oval", "closed branch"},
    {"nodal", "branch with a node"},
    {"line", "line"},
    {"circle", "circle"},
    {"conic", "conic"},
    {"line_at_infinity", "line at infinity"},
    {"center_line", "line of centre points"},
    {"sheet_1", "sheet 1"},
    {"sheet_2", "sheet 2"},
    {"sheet_1_opposite", "sheet 1, opposite"},
    {"sheet_2_opposite", "sheet 2, opposite"},
    {"direction_1", "direction 1"},
    {"direction_2", "direction 2"},
    {"direct", "as given"},
    {"opposite", "opposite"},
    {"range", ""},
    {"alpha", "α₀"},
    {"alpha_plus_90", "α₀ + 90°"},
    {"first", "first linkage"},
    {"second", "second linkage"},
    {"minimax", "minimax"},
    {"near_minimax", "near-minimax"},
}};

constexpr std::array<std::pair<std::string_view, std::string_view>, 6> dimension_labels = {{
    {"input_center_x", "input's fixed pivot, x"},
    {"input_center_y", "input's fixed pivot, y"},
    {"output_center_x", "output's fixed pivot, x"},
    {"output_center_y", "output's fixed pivot, y"},
    {"point_along", "point, along the coupler"},
    {"point_across", "point, across the coupler"},
}};

constexpr std::array<std::pair<std::string_view, std::string_view>, 7> cone_branch_labels = {{
    {"odd", "odd branch"},
    {"oval", "oval"},
    {"nodal", "branch with a node"},
    {"point", "isolated axis"},
    {"great_circle", "plane"},
    {"cone", "quadratic cone"},
    {"fixed_circle", "fixed axes of one moving axis"},
}};

template <std::size_t count>
std::string_view words_for(std::string_view name,
                           const std::array<std::pair<std::string_view, std::string_view>, count>& labels) {
  for (const auto& [known, words] : labels) {
    if (known == name) return words;
  }
  return name;
}

}  // namespace

std::string_view label(LinkageType type) { return type_labels[static_cast<std::size_t>(type)]; }
std::string_view short_label(LinkageType type) { return short_type_labels[static_cast<std::size_t>(type)]; }
std::string_view label(DriveSense sense) { return sense_labels[static_cast<std::size_t>(sense)]; }
std::string_view label(CubicKind kind) { return cubic_labels[static_cast<std::size_t>(kind)]; }
std::string_view label(CubicConeKind kind) { return cone_labels[static_cast<std::size_t>(kind)]; }
std::string_view label(SixBarTopology topology) { return topology_labels[static_cast<std::size_t>(topology)]; }
std::string_view label(ChangePointKind kind) { return change_point_labels[static_cast<std::size_t>(kind)]; }

std::string_view branch_label(std::string_view name) { return words_for(name, branch_labels); }
std::string dimension_label(std::string_view name) {
  // Of six-bars: "center_c4_x", "length 2:b-d".
  constexpr std::string_view center = "center_";
  if (name.starts_with(center) && name.size() > center.size() + 2) {
    const std::string_view joint = name.substr(center.size(), name.size() - center.size() - 2);
    return fmt::format("fixed pivot {}, {}", joint, name.back());
  }
  return std::string(words_for(name, dimension_labels));
}
std::string_view cone_branch_label(std::string_view name) { return words_for(name, cone_branch_labels); }

std::string range_sentence(const std::vector<AngleRange>& ranges) {
  const auto text_of = [](double angle) { return rounded_text(degrees(angle), 2) + "°"; };
  std::string text = "the input rocks";
  for (std::size_t i = 0; i < ranges.size(); ++i)
    text += fmt::format("{} from {} to {} ({})", i == 0 ? "" : ", or in the other assembly mode,",
                        text_of(ranges[i].from), text_of(ranges[i].to), text_of(ranges[i].to - ranges[i].from));
  return text;
}

}  // namespace linkwright
