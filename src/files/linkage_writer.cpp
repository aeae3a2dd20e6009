#include <functional>

#include "files/fields/field_writer.hpp"
#include "files/fields/result_forms.hpp"
#include "files/json/json_writer.hpp"
#include "files/linkage_fields.hpp"
#include "kinds/kinds.hpp"
#include "linkwright/files/linkage_file.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "problem_fields.hpp"
#include "problem_writer.hpp"

namespace linkwright {
namespace {

/// `without_record` writes the linkage where it came from no result.
template <class Stored>
std::string written(const Stored& linkage, FunctionRef<void(JsonWriter&)> without_record) {
  std::string text;
  {
    JsonWriter json([&text](std::string_view piece) { text += piece; });
    json.begin_object();
    json.member("linkwright", file_version);
    json.member("title", std::string_view(linkage.title));
    json.member("length_unit", std::string_view(linkage.length_unit));
    json.key("poses");
    write_fields(json, linkage.poses, forms::on_lines);
    json.key("linkage");
    linkage.record.empty() ? without_record(json) : json.json(linkage.record);
    json.end_object();
  }
  return text;
}

}  // namespace

std::string write_linkage(const StoredLinkage& linkage) {
  return written(linkage, [&linkage](JsonWriter& json) {
    json.begin_object();
    json.key("pivots");
    linkage.point ? write_fields(json, TracingFourBar{linkage.four_bar, *linkage.point})
                  : write_pivots(json, linkage.four_bar);
    json.end_object();
  });
}

std::string write_linkage(const StoredSixBar& linkage) {
  return written(linkage, [&linkage](JsonWriter& json) {
    json.begin_object();
    json.member("mechanism", "six_bar");
    FieldWriter writer(json);
    make_up_fields(writer, linkage.six_bar, linkage.assembly_mode, {});
    json.end_object();
  });
}

}  // namespace linkwright
