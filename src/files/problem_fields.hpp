#pragma once

#include "fields/field_visitor.hpp"
#include "linkwright/region/linkage_class.hpp"
#include "linkwright/synthesis/solve.hpp"

// What problem files say, struct by struct: see fields/field_visitor.hpp.
namespace linkwright {

void fields(FieldVisitor& v, Problem& problem);
void fields(FieldVisitor& v, Task& task);

/// Of the linkages of a class: others are read, too, and refused later.
struct RequirementsOf {
  Requirements& wanted;
  const LinkageClass& linkages;
};
void fields(FieldVisitor& v, RequirementsOf& requirements);

/// Of a task; `of_line`: how lines are measured is written.
struct OptionsOf {
  SynthesisOptions& options;
  bool of_line;
};
void fields(FieldVisitor& v, OptionsOf& options);

void fields(FieldVisitor& v, FitStart& start);
void fields(FieldVisitor& v, Box& box);
void fields(FieldVisitor& v, Cone& cone);
void fields(FieldVisitor& v, LineAtAngle& line);
void fields(FieldVisitor& v, PrescribedPose& pose);
void fields(FieldVisitor& v, PrescribedOrientation& orientation);
void fields(FieldVisitor& v, ThreeLinkChain& chain);
/// The member `poses` of a task.
void pose_fields(FieldVisitor& v, std::vector<PrescribedPose>& poses, std::vector<BodyPoints>& points);
/// The same of a motion, some of whose poses may be near.
void motion_pose_fields(FieldVisitor& v, MotionTask& task);
/// Those of a task.
[[nodiscard]] List orientation_list();
/// The members `pairs` or `function`, and `free`, as members of a task.
void pair_fields(FieldVisitor& v, WantedFunction& wanted);
void free_fields(FieldVisitor& v, WantedFunction& wanted);

}  // namespace linkwright
