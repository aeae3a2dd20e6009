#include "problem_writer.hpp"

#include "files/fields/field_writer.hpp"
#include "linkwright/files/problem_file.hpp"
#include "problem_fields.hpp"

namespace linkwright {

void write_requirements(JsonWriter& json, Requirements requirements, const LinkageClass& asked) {
  write_fields(json, RequirementsOf{requirements, asked});
}

std::string write_problem(const Problem& problem) {
  return json_text_of([&](JsonWriter& json) { write_fields(json, problem); });
}

}  // namespace linkwright
