#include "line_reader.hpp"

#include "linkwright/core/angle.hpp"

namespace linkwright {

std::optional<LineAtAngle> read_line(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject line(value, mistakes, {"point", "direction_deg"});
  const auto point = line.require_point("point");
  const auto turn = line.require_number("direction_deg");
  if (!point || !turn) return std::nullopt;
  return LineAtAngle(*point, radians(*turn));
}

}  // namespace linkwright
