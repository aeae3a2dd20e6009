#include "region_arrays.hpp"

#include <algorithm>
#include <cstring>

#include "files/json/base64.hpp"
#include "linkwright/planar/four_bar_map.hpp"
#include "linkwright/region/measure.hpp"

namespace linkwright {
namespace {

void write_bytes(JsonWriter& json, std::string_view key, const RegionMap& region, std::span<const std::uint8_t> cells) {
  json.key(key);
  json.begin_text();
  Base64Encoder encoder;
  std::string text;
  for (std::size_t row = 0; row < region.rows(); ++row) {
    text.clear();
    encoder.encode(cells.subspan(row * region.columns(), region.columns()), text);
    json.text_piece(text);
  }
  text.clear();
  encoder.finish(text);
  json.text_piece(text);
  json.end_text();
}

// A code, though the map keeps it among its measures.
void write_valid(JsonWriter& json, const RegionMap& region) {
  const std::span<const float> held = region.values(measures::valid);
  if (held.empty()) return;
  std::vector<std::uint8_t> codes(held.size());
  std::transform(held.begin(), held.end(), codes.begin(), [](float code) { return static_cast<std::uint8_t>(code); });
  write_bytes(json, "valid", region, codes);
}

void put_little_endian(float number, std::uint8_t* bytes) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);
  for (int i = 0; i < 4; ++i) bytes[i] = static_cast<std::uint8_t>(bits >> 8 * i);
}

void write_property(JsonWriter& json, const RegionMap& region, const Measure& measure) {
  json.key(measure.key);
  json.begin_text();
  Base64Encoder encoder;
  std::string text;
  std::vector<float> values(region.columns());
  std::vector<std::uint8_t> bytes(4 * region.columns());
  for (std::size_t row = 0; row < region.rows(); ++row) {
    row_values(region, measure, row, values);
    for (std::size_t column = 0; column < region.columns(); ++column)
      put_little_endian(values[column], &bytes[4 * column]);
    text.clear();
    encoder.encode(bytes, text);
    json.text_piece(text);
  }
  text.clear();
  encoder.finish(text);
  json.text_piece(text);
  json.end_text();
}

}  // namespace

void write_region_arrays(JsonWriter& json, const RegionMap& region) {
  write_bytes(json, "type", region, region.types());
  write_bytes(json, "defects", region, region.defects());
  write_valid(json, region);
  json.key("properties");
  json.begin_object();
  RegionMap empty;  // of a task without a map, whose columns are there all the same
  if (region.measures().empty()) empty.lay({}, {}, planar_measures, false, {});
  const RegionMap& shown = region.measures().empty() ? empty : region;
  for (const Measure& measure : shown.reported_measures())
    if (!(measure == measures::valid)) write_property(json, shown, measure);
  json.end_object();
}

}  // namespace linkwright
