#include "listed_notes.hpp"

#include "analyses/analyses.hpp"
#include "files/fields/result_forms.hpp"
#include "result_fields.hpp"

namespace linkwright {

void ListedNotes::visit(FieldVisitor& v) const {
  const bool is_picked = found_ && place_ < found_->fails.size();
  const std::vector<RequirementKind> fails = is_picked ? found_->fails[place_] : std::vector<RequirementKind>();
  const List list = {.what = "", .least = 1, .name = "fails"};
  v.shown_if_any(Field("meets_requirements", "Of a linkage at a picked place (options.at)."),
                 forms::where(is_picked, fails.empty()));
  v.member(Field("fails", "The requirements that a linkage at a picked place does not meet; only where there are some.")
               .written(!fails.empty()),
           false, [&](FieldVisitor& to) { visit_requirements(to, list, fails); });
  report_fields(v, found_, place_);
}

}  // namespace linkwright
