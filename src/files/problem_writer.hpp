#pragma once

#include "files/json/json_writer.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/region/linkage_class.hpp"

namespace linkwright {

/// Those of the class as one object, `respect_direction` last.
void write_requirements(JsonWriter& json, Requirements requirements, const LinkageClass& asked);

/// `[x, y]`, on one line.
void write_point(JsonWriter& json, Point point);
/// `[low, high]`, on one line.
void write_interval(JsonWriter& json, double low, double high);

/// `{"input_center": [x, y], "input_circle": …, "output_center": …, "output_circle": …}`.
void write_pivots(JsonWriter& json, const FourBar& four_bar);

}  // namespace linkwright
