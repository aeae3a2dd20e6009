#pragma once

#include <functional>
#include <initializer_list>
#include <string_view>

#include "files/document_fields.hpp"
#include "files/fields/field_reader.hpp"
#include "files/file_header.hpp"
#include "files/json/json.hpp"
#include "files/json/json_document.hpp"
#include "files/json/json_object.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/files/problem_file.hpp"

namespace linkwright {

/// What all files of `linkwright attitude` have in common: a JSON object with the version and known keys, of which
/// `members` reads what it knows. Nothing but the mistakes where there are any.
template <class Task>
[[nodiscard]] Result<Task> read_attitude_task(std::string_view text, std::initializer_list<std::string_view> known,
                                              const std::function<Task(const JsonObject&, Mistakes&)>& members) {
  const auto tree = parse_json(text, {.max_bytes = max_file_bytes, .deepest_nesting = deepest_nesting, .kept = {}});
  if (!tree) return tree.errors();
  Mistakes mistakes;
  const JsonValue root(*tree, "", mistakes);
  if (const auto refusal = refuse_version(root)) return *refusal;
  const JsonObject file(root, mistakes, known);
  Task task;
  if (root.is_object()) {
    FieldReader reader(root, mistakes);
    version_field(reader);
    if (const auto title = file.find("title")) static_cast<void>(title->as_text());  // for the reader of the file only
    task = members(file, mistakes);
  }
  if (!mistakes.empty()) return mistakes.take();
  return task;
}

}  // namespace linkwright
