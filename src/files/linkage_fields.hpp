#pragma once

#include "fields/field_visitor.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/region/linkage_family.hpp"

// What results of several kinds say of a linkage.
namespace linkwright {

void fields(FieldVisitor& v, const LinkLengths& lengths);
void fields(FieldVisitor& v, const Defects& defects);
/// The pivots.
void fields(FieldVisitor& v, const FourBar& four_bar);
/// The pivots and the point of the coupler.
void fields(FieldVisitor& v, const TracingFourBar& linkage);

/// The members `type` and `defects`.
void verdict_fields(FieldVisitor& v, const DefectReport& report);
/// The members that tell how the input does the task.
void drive_fields(FieldVisitor& v, const DefectReport& report);
/// The same of drives of which less is known: `sense` none and nothing where a defect leaves it undefined.
void drive_fields(FieldVisitor& v, DriveSense sense, std::optional<double> sweep_deg);
/// The member `swapped`.
void swapped_field(FieldVisitor& v, const DefectReport& report);

/// What a function task's free parameter is at a place of its map, as files hold it; of other tasks nothing.
[[nodiscard]] std::optional<double> free_value(const LinkageFamily& family, MapPoint place);
/// The member `free_value`.
void free_value_field(FieldVisitor& v, std::optional<double> value);

}  // namespace linkwright
