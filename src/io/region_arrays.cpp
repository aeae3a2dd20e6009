#include "region_arrays.hpp"

#include <cmath>
#include <cstring>
#include <functional>

#include "base64.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

using Property = std::function<double(std::size_t row, std::size_t column)>;

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

void put_little_endian(float number, std::uint8_t* bytes) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);
  for (int i = 0; i < 4; ++i) bytes[i] = static_cast<std::uint8_t>(bits >> 8 * i);
}

void write_property(JsonWriter& json, std::string_view key, const RegionMap& region, const Property& property) {
  json.key(key);
  json.begin_text();
  Base64Encoder encoder;
  std::string text;
  std::vector<std::uint8_t> bytes(4 * region.columns());
  for (std::size_t row = 0; row < region.rows(); ++row) {
    for (std::size_t column = 0; column < region.columns(); ++column) {
      const auto number = static_cast<float>(property(row, column));
      put_little_endian(std::isfinite(number) ? number : 0, &bytes[4 * column]);
    }
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
  json.key("properties");
  json.begin_object();
  write_property(json, "min_transmission_angle_deg", region, [&](std::size_t row, std::size_t column) {
    return degrees(region.min_transmission_angle(region.index(row, column)));
  });
  write_property(json, "min_transmission_angle_full_turn_deg", region, [&](std::size_t row, std::size_t column) {
    return degrees(region.min_transmission_angle_full_turn(region.index(row, column)));
  });
  write_property(json, "link_ratio", region, [&](std::size_t row, std::size_t column) {
    return double{region.link_ratios()[region.index(row, column)]};
  });
  write_property(json, "longest_link", region, [&](std::size_t row, std::size_t column) {
    return double{region.longest_links()[region.index(row, column)]};
  });
  write_property(json, "driver_sweep_deg", region,
                 [&](std::size_t row, std::size_t column) { return degrees(region.driver_sweep(row, column)); });
  json.end_object();
}

}  // namespace linkwright
