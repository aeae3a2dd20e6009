#pragma once

#include "fields/field_visitor.hpp"

// How files begin.
namespace linkwright {

/// The member `linkwright`.
void version_field(FieldVisitor& v);

/// The members with which files begin that tell of one linkage; `of` has a title and a unit of length.
template <class Titled>
void head_fields(FieldVisitor& v, const Titled& of) {
  version_field(v);
  v.shown("title", of.title);
  v.shown("length_unit", of.length_unit);
}

}  // namespace linkwright
