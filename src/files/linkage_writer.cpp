#include "document_fields.hpp"
#include "files/fields/field_writer.hpp"
#include "files/fields/result_forms.hpp"
#include "files/linkage_fields.hpp"
#include "kinds/kinds.hpp"
#include "linkwright/files/linkage_file.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "problem_fields.hpp"

namespace linkwright {
namespace {

/// `without_record` has the members of the linkage where it came from no result.
template <class Stored>
std::string written(Stored linkage, Visit without_record) {
  return json_text_of([&](JsonWriter& json) {
    FieldWriter writer(json);
    writer.object({.on_lines = true}, [&](FieldVisitor& to) {
      head_fields(to, linkage);
      to.shown("poses", linkage.poses, forms::on_lines);
      to.member("linkage", true, [&](FieldVisitor& at) {
        linkage.record.empty() ? at.object({.on_lines = true}, without_record) : at.foreign(linkage.record);
      });
    });
  });
}

}  // namespace

std::string write_linkage(const StoredLinkage& linkage) {
  return written(linkage, [&linkage](FieldVisitor& v) {
    linkage.point ? v.shown("pivots", TracingFourBar{linkage.four_bar, *linkage.point})
                  : v.shown("pivots", linkage.four_bar);
  });
}

std::string write_linkage(const StoredSixBar& linkage) {
  return written(linkage, [&linkage](FieldVisitor& v) {
    v.constant("mechanism", "six_bar");
    make_up_fields(v, linkage.six_bar, linkage.assembly_mode, {});
  });
}

}  // namespace linkwright
