#pragma once

#include "files/json/json_writer.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/position_error.hpp"

namespace linkwright {

/// The member `position_errors` of an analysis; nothing where the file has one position at most.
inline void write_position_errors(JsonWriter& json, const AnyStoredLinkage& linkage) {
  const std::vector<PositionError> errors = position_errors(linkage);
  if (errors.empty()) return;
  json.key("position_errors");
  json.begin_list();
  for (const auto& [position, error] : errors) {
    json.begin_object(JsonWriter::Layout::one_line);
    json.member("position", position);
    json.key("distance");
    error ? json.value(error->distance) : json.null();
    json.key("angle_deg");
    error ? json.value(degrees(error->angle)) : json.null();
    json.end_object();
  }
  json.end_list();
}

}  // namespace linkwright
