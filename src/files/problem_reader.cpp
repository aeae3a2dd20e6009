#include <algorithm>
#include <variant>
#include <vector>

#include "file_header.hpp"
#include "files/fields/field_reader.hpp"
#include "files/json/json.hpp"
#include "files/json/json_document.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/text_file.hpp"
#include "problem_fields.hpp"

namespace linkwright {
namespace {

/// What is asked for although linkages of the class do not have it, the defaults of other classes included.
void refuse_foreign_requirements(const Json& written, const Requirements& requirements, const LinkageClass& asked,
                                 Mistakes& mistakes) {
  std::vector<Error> found = mistakes_in(requirements, asked);
  for (const Criterion& one : criteria()) {
    const bool is_own = place_among(asked.requirements, one.kind) < asked.requirements.size();
    if (is_own || written.value(one.key, Json()).is_null()) continue;
    const Error foreign = foreign_requirement(one.kind, asked);
    if (std::none_of(found.begin(), found.end(), [&](const Error& known) { return known.place == foreign.place; }))
      found.push_back(foreign);
  }
  mistakes.add(found);
}

/// What one part of a file says of another.
void settle(const Json& file, Problem& problem, Mistakes& mistakes) {
  const auto object = Json::object();
  if (!file.value("options", object).contains("objective"))
    problem.options.objective = linkages(problem.task).objectives.front();
  std::visit(
      [&](auto& task) {
        if constexpr (requires { task.box; }) task.box = problem.options.box;
      },
      problem.task);
  mistakes.add_new(mistakes_in(problem.task));
  mistakes.add(mistakes_in(problem.task, problem.requirements, problem.options));
  refuse_foreign_requirements(file.value("requirements", object), problem.requirements, linkages(problem.task),
                              mistakes);
}

}  // namespace

Result<Problem> read_problem(std::string_view text) {
  const auto tree = parse_json(text, {.max_bytes = max_file_bytes, .deepest_nesting = deepest_nesting, .kept = {}});
  if (!tree) return tree.errors();

  Mistakes mistakes;
  const JsonValue root(*tree, "", mistakes);
  if (const auto refusal = refuse_version(root)) return *refusal;
  Problem problem;
  FieldReader reader(root, mistakes);
  fields(reader, problem);
  if (mistakes.empty()) settle(*tree, problem, mistakes);
  if (!mistakes.empty()) return mistakes.take();
  return problem;
}

Result<Problem> read_problem_file(const std::filesystem::path& path) {
  const auto text = read_text_file(path, max_file_bytes);
  return text ? read_problem(*text) : Result<Problem>(text.errors());
}

}  // namespace linkwright
