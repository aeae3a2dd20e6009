#pragma once

#include <string_view>

#include "files/json/json_writer.hpp"
#include "linkwright/analysis/defects.hpp"
#include "linkwright/files/problem_file.hpp"
#include "task_writer.hpp"

namespace linkwright {

/// The problem as one JSON object, every default written out.
void write_problem(JsonWriter& json, const Problem& problem);

/// Those of the class as one object, `respect_direction` last.
void write_requirements(JsonWriter& json, const Requirements& requirements, const LinkageClass& asked);

/// `{"axis": [x, y, z], "half_angle_deg": …}`.
void write_cone(JsonWriter& json, const Cone& cone);

/// `{"x": [low, high], "y": [low, high]}`.
void write_box(JsonWriter& json, const Box& box);

/// `{"ground": …, "input": …, "coupler": …, "output": …}`.
void write_lengths(JsonWriter& json, const LinkLengths& lengths);

/// `{"order": …, "branch": …, "circuit": …}`.
void write_defects(JsonWriter& json, Defects defects);

/// `{"input_center": [x, y], "input_circle": …, "output_center": …, "output_circle": …}`.
void write_pivots(JsonWriter& json, const FourBar& four_bar);
/// The same with the point of the coupler: `{"input_fixed": …, "input_moving": …, "output_moving": …, "output_fixed":
/// …, "point": …}`.
void write_pivots(JsonWriter& json, const TracingFourBar& linkage);

}  // namespace linkwright
