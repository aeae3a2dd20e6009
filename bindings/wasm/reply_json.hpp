#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "files/json/json_writer.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/planar/pose_conditions.hpp"

// The pieces that the replies to the page are written with (web/src/engine/protocol.ts).
namespace linkwright::wasm {

/// {"code", "values", "message"}.
void write_notice(JsonWriter& json, const Notice& notice);
/// [{"code", "place", "values", "message"}, …].
[[nodiscard]] std::string mistakes_json(const std::vector<Error>& mistakes);
/// [x, y], null for none.
void write_point(JsonWriter& json, const std::optional<Point>& point);
void write_numbers(JsonWriter& json, std::span<const double> numbers);
/// [[…], …], on one line.
template <class Rows>
void write_rows(JsonWriter& json, const Rows& rows) {
  json.begin_list(JsonWriter::Layout::one_line);
  for (const auto& row : rows) write_numbers(json, row);
  json.end_list();
}
/// [[x, y], …].
template <class Points, class PointOf = std::identity>
void write_points(JsonWriter& json, const Points& points, PointOf point_of = {}) {
  json.begin_list(JsonWriter::Layout::one_line);
  for (const auto& item : points) write_point(json, point_of(item));
  json.end_list();
}

}  // namespace linkwright::wasm
