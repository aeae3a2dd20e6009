#pragma once

#include <vector>

#include "fields/field_visitor.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "linkwright/synthesis/solve.hpp"

// What result files say, struct by struct; only written: see fields/field_visitor.hpp.
namespace linkwright {

/// A result file.
struct ResultRecord {
  const Problem& problem;
  const Answer& answer;
  bool with_region = true;  ///< with the arrays of the map
};
void fields(FieldVisitor& v, const ResultRecord& of);

void fields(FieldVisitor& v, const Notice& notice);
void fields(FieldVisitor& v, const CurveBranch& branch);
void fields(FieldVisitor& v, const InsideWindows& inside);
void fields(FieldVisitor& v, const Relaxation& relaxation);
void fields(FieldVisitor& v, const JointRelaxation& joint);
/// The member `requirement`.
void requirement_field(FieldVisitor& v, RequirementKind requirement);
/// Keys of requirements.
void visit_requirements(FieldVisitor& v, const List& list, const std::vector<RequirementKind>& kinds);

}  // namespace linkwright
