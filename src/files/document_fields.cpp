#include "document_fields.hpp"

#include <fmt/format.h>

#include "linkwright/files/problem_file.hpp"

namespace linkwright {

void version_field(FieldVisitor& v) {
  const Wanted missing = {"file_version", "the version of the file: \"linkwright\": 1"};
  double version = file_version;
  v.member(Field("linkwright", "Version of the file format.").missing(missing), true, [&](FieldVisitor& to) {
    to.number(version, {.least = file_version, .most = file_version});
    if (version != file_version)
      to.mistake("unknown_version", fmt::format("there is no version {}; this is {}", version, file_version),
                 {{"version", version}, {"known", file_version}});
  });
}

}  // namespace linkwright
