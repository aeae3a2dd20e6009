#pragma once

#include <string_view>

#include "json_writer.hpp"
#include "linkwright/io/problem_file.hpp"

namespace linkwright {

/// The problem as one JSON object, every default written out.
void write_problem(JsonWriter& json, const Problem& problem);

/// `{"x": …, "y": …, "theta_deg": …}`, with `"derivatives"` where there are any.
void write_pose(JsonWriter& json, const PrescribedPose& pose);

/// `[x, y]`.
void write_point(JsonWriter& json, Point point);

/// `{"ground": …, "input": …, "coupler": …, "output": …}`.
void write_lengths(JsonWriter& json, const LinkLengths& lengths);

/// `{"input_center": [x, y], "input_circle": …, "output_center": …, "output_circle": …}`.
void write_pivots(JsonWriter& json, const FourBar& four_bar);

}  // namespace linkwright
