#include "file_header.hpp"

#include <fmt/format.h>

#include "files/json/json.hpp"
#include "linkwright/files/problem_file.hpp"

namespace linkwright {

std::optional<Error> refuse_version(const JsonValue& root) {
  if (!root.is_object()) return std::nullopt;
  const auto found = root.json().find("linkwright");
  if (found == root.json().end() || !found->is_number()) return std::nullopt;
  const double version = found->get<double>();
  if (!(version > file_version)) return std::nullopt;
  return Error{
      "newer_version",
      "linkwright",
      fmt::format("this file was written by a newer Linkwright (version {}; this is {}); use the newer program",
                  version, file_version),
      {{"version", version}, {"known", file_version}}};
}

}  // namespace linkwright
