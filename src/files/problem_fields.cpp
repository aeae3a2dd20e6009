#include "problem_fields.hpp"

#include <array>
#include <fmt/format.h>
#include <variant>

#include "analyses/analyses.hpp"
#include "document_fields.hpp"
#include "files/json/json.hpp"
#include "kinds/kinds.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {
namespace {

template <class Held>
Kind kind(std::string_view name, std::string_view mechanism, Task& task) {
  return {name, mechanism, [&task](FieldVisitor& v) { fields(v, as<Held>(task)); }};
}

/// Three points [x, y] or more; none of another list, which is the workbench's business.
std::vector<Point> outline_of(const Json& list) {
  std::vector<Point> outline;
  if (!list.is_array()) return outline;
  for (const Json& point : list) {
    if (!point.is_array() || point.size() != 2 || !point[0].is_number() || !point[1].is_number()) return {};
    outline.emplace_back(point[0].get<double>(), point[1].get<double>());
  }
  return outline.size() < 3 ? std::vector<Point>() : outline;
}

/// The outline, and what else the workbench keeps.
std::string view_text(const Problem& problem) {
  if (problem.outline.empty()) return problem.view;
  std::string text = R"({"outline": [)";
  for (const Point& p : problem.outline)
    text +=
        fmt::format("{}[{}, {}]", &p == problem.outline.data() ? "" : ", ", exact_text(p.real()), exact_text(p.imag()));
  const std::string_view rest = problem.view;
  return text + (rest.size() > 2 ? fmt::format("], {}", rest.substr(1)) : "]}");
}

void take_view(const std::string& text, Problem& problem) {
  Json rest = Json::parse(text);
  if (const auto outline = rest.find("outline"); outline != rest.end()) problem.outline = outline_of(*outline);
  if (!problem.outline.empty()) rest.erase("outline");
  if (problem.outline.empty() || !rest.empty()) problem.view = rest.dump();
}

void view_field(FieldVisitor& v, Problem& problem) {
  const std::string before = view_text(problem);
  const Field field(
      "view",
      "The workbench's own; kept. Of it the program reads only the `outline`, which it draws: corners [x, "
      "y] of the guided body in the moving frame.");
  v.member(field.absent(before.empty()), false, [&](FieldVisitor& to) {
    std::string text = before;
    to.foreign(text);
    if (text != before) take_view(text, problem);
  });
}

}  // namespace

void fields(FieldVisitor& v, Task& task) {
  const std::array kinds = {kind<MotionTask>("motion", "four_bar", task),
                            kind<FunctionTask>("function", "four_bar", task),
                            kind<SixBarTask>("motion", "six_bar", task),
                            kind<SphericalMotionTask>("motion", "spherical_four_bar", task),
                            kind<SphericalFunctionTask>("function", "spherical_four_bar", task),
                            kind<StraightLineTask>("straight_line", "four_bar", task),
                            kind<PathTask>("path", "four_bar", task)};
  static_assert(kinds.size() == std::variant_size_v<Task>, "each kind has its line");
  v.kinds(task.index(), kinds);
}

void fields(FieldVisitor& v, Problem& problem) {
  v.object({.on_lines = true}, [&](FieldVisitor& to) {
    version_field(to);
    to.optional("title", problem.title);
    to.optional(
        Field("length_unit",
              "Echoed, never converted. Drawings and models know µm, mm, cm, dm, m, km, mil, in, ft, yd and mi by "
              "symbol or name, in any spelling that is usual (inch, inches, \", millimeter, MM); of another the "
              "export says that it does not know it."),
        problem.length_unit);
    to.required(Field("task").missing({"task", "the task: \"task\": {\"kind\": \"motion\", …}"}), problem.task);
    RequirementsOf requirements = {problem.requirements, linkages(problem.task)};
    to.optional("requirements", requirements);
    analysis_fields(to, problem.options, problem.length_unit);
    OptionsOf options = {problem.options, output_kind(problem.task) == OutputKind::line};
    to.optional("options", options);
    view_field(to, problem);
  });
}

}  // namespace linkwright
