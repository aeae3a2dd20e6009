#pragma once

#include <string>
#include <vector>

#include "fields/field_visitor.hpp"
#include "files/fields/result_forms.hpp"
#include "linkwright/files/analysis_file.hpp"
#include "linkwright/files/six_bar_file.hpp"

// What `linkwright analyze` writes, file by file; only written: see fields/field_visitor.hpp.
namespace linkwright {

void fields(FieldVisitor& v, const LinkageAnalysis& of);
void fields(FieldVisitor& v, const StoredSixBarAnalysis& of);
void fields(FieldVisitor& v, const StoredSphericalAnalysis& of);
void fields(FieldVisitor& v, const PrescribedInstant& of);

/// Both ends, degrees.
void fields(FieldVisitor& v, const AngleRange& range);

/// The member `position_errors`.
void position_errors_field(FieldVisitor& v, const AnyStoredLinkage& linkage);

/// A column of a motion: of each state what `value_of` makes of it.
template <class State, class Form, class ValueOf>
void column(FieldVisitor& v, const Field& field, const std::vector<State>& motion, const Form& form,
            const ValueOf& value_of) {
  v.member(field, true, [&](FieldVisitor& at) {
    visit_each(at, forms::on_a_line, motion, [&](FieldVisitor& to, const State& state) {
      auto value = value_of(state);
      visit(to, value, form);
    });
  });
}

}  // namespace linkwright
