#include "region_arrays.hpp"

#include <algorithm>
#include <cstring>

#include "linkwright/planar/four_bar_map.hpp"
#include "linkwright/region/measure.hpp"

namespace linkwright {
namespace {

using Bytes = std::vector<std::uint8_t>;

void cells_field(FieldVisitor& v, const Field& field, const RegionMap& region, std::span<const std::uint8_t> cells) {
  const auto of_row = [&](std::size_t row) { return cells.subspan(row * region.columns(), region.columns()); };
  v.member(field, false, [&](FieldVisitor& to) { to.bytes(region.rows(), of_row); });
}

// A code, though the map keeps it among its measures.
void valid_field(FieldVisitor& v, const RegionMap& region, bool is_written) {
  const std::span<const float> held = region.values(measures::valid);
  Bytes codes(held.size());
  std::transform(held.begin(), held.end(), codes.begin(), [](float code) { return static_cast<std::uint8_t>(code); });
  const Field field("valid", "Of straight lines, u8: 0 none, 1 a four-bar, 2 a slider.");
  cells_field(v, field.written(is_written && !held.empty()), region, codes);
}

void put_little_endian(float number, std::uint8_t* bytes) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);
  for (int i = 0; i < 4; ++i) bytes[i] = static_cast<std::uint8_t>(bits >> 8 * i);
}

void visit_property(FieldVisitor& v, const RegionMap& region, const Measure& measure) {
  std::vector<float> values(region.columns());
  Bytes bytes(4 * region.columns());
  v.bytes(region.rows(), [&](std::size_t row) {
    row_values(region, measure, row, values);
    for (std::size_t column = 0; column < values.size(); ++column)
      put_little_endian(values[column], &bytes[4 * column]);
    return std::span<const std::uint8_t>(bytes);
  });
}

void visit_properties(FieldVisitor& v, const RegionMap& region) {
  std::vector<Measure> told;
  std::vector<std::string> keys;
  for (const Measure& measure : region.reported_measures()) {
    if (measure == measures::valid) continue;
    told.push_back(measure);
    keys.emplace_back(measure.key);
  }
  v.keyed({.pattern = "^[a-z_0-9]+$", .on_lines = true}, keys,
          [&](FieldVisitor& to, std::size_t i) { visit_property(to, region, told[i]); });
}

}  // namespace

void region_array_fields(FieldVisitor& v, const RegionMap& region, bool are_written) {
  cells_field(v, Field("type", "u8 by type, row-major [input][output].").written(are_written), region, region.types());
  cells_field(v, Field("defects", "u8: 1 order, 2 branch, 4 circuit.").written(are_written), region, region.defects());
  valid_field(v, region, are_written);
  RegionMap empty;  // of a task without a map, whose columns are there all the same
  if (region.measures().empty()) empty.lay({}, {}, planar_measures, false, {});
  const RegionMap& shown = region.measures().empty() ? empty : region;
  v.member(Field("properties", "Little-endian f32; 0 where not defined.").written(are_written), false,
           [&](FieldVisitor& to) { visit_properties(to, shown); });
}

}  // namespace linkwright
