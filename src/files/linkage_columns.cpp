#include "linkage_columns.hpp"

#include <string_view>
#include <variant>

#include "analyses/analyses.hpp"
#include "kinds/kinds.hpp"

namespace linkwright {

void LinkageColumns::number(std::string name, std::string unit, std::string description, bool is_usual) {
  list_.push_back({std::move(name), LinkageColumn::Kind::number, std::move(unit), std::move(description), is_usual});
}

void LinkageColumns::length(std::string name, std::string description, bool is_usual) {
  number(std::move(name), length_, std::move(description), is_usual);
}

void LinkageColumns::angle(std::string name, std::string description, bool is_usual) {
  number(std::move(name), "deg", std::move(description), is_usual);
}

void LinkageColumns::flag(std::string name, std::string description, bool is_usual) {
  list_.push_back({std::move(name), LinkageColumn::Kind::flag, "", std::move(description), is_usual});
}

void LinkageColumns::text(std::string name, std::string description, bool is_usual) {
  list_.push_back({std::move(name), LinkageColumn::Kind::text, "", std::move(description), is_usual});
}

void LinkageColumns::coordinates(const std::string& name, std::string unit, const std::string& what, bool is_usual,
                                 int count) {
  constexpr std::string_view axes = "xyz";
  for (int k = 0; k < count; ++k)
    number(name + "[" + std::to_string(k) + "]", unit, what + ", " + axes[static_cast<std::size_t>(k)], is_usual);
}

void LinkageColumns::point(const std::string& name, const std::string& what, bool is_usual) {
  coordinates(name, length_, what, is_usual, 2);
}

void LinkageColumns::axis(const std::string& name, const std::string& what, bool is_usual) {
  coordinates(name, "", what, is_usual, 3);
}

void LinkageColumns::lengths(std::initializer_list<std::pair<const char*, const char*>> names) {
  for (const auto& [name, what] : names) length(std::string("lengths.") + name, what, LinkageColumn::usual);
}

void list_motion(LinkageColumns& list) {
  list.text("type", "Type of the linkage, of a six-bar that of its four-bar loop", LinkageColumn::usual);
  list.flag("defects.order", "It reaches the positions in another order", LinkageColumn::usual);
  list.flag("defects.branch", "It passes a dead point between positions", LinkageColumn::usual);
  list.flag("defects.circuit", "Positions lie on different circuits", LinkageColumn::usual);
  list.text("drive", "Sense in which the input turns through the positions: ccw, cw, either", LinkageColumn::usual);
  list.angle("driver_sweep_deg", "How far the input turns from the first to the last position", LinkageColumn::usual);
  list.angle("min_transmission_angle_deg", "Minimum transmission angle over the task", LinkageColumn::usual);
}

void list_function(LinkageColumns& list) {
  list.angle("precision_error_deg", "Largest error of the output at the precision points");
  list.angle("max_structural_error_deg", "Largest error of the output over the range", LinkageColumn::usual);
  list.angle("worst_input_deg", "Input where the error is largest");
  list.number("free_value", "", "Free parameter of the function");
}

void list_verdict(LinkageColumns& list) {
  list.number("residual", "", "Relative change of the grounded links' lengths over the positions");
  list.flag("local_optimum", "No neighbour on the map is better");
  list.flag("verified_by_driving", "Simulation of the motion confirms it", LinkageColumn::usual);
}

std::vector<LinkageColumn> linkage_columns(const Problem& problem) {
  LinkageColumns list(problem.length_unit);
  std::visit([&](const auto& task) { list_columns(list, task); }, problem.task);
  list_analyses(list, problem);
  return list.take();
}

}  // namespace linkwright
