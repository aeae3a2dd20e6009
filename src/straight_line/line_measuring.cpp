#include "linkwright/straight_line/line_measuring.hpp"

namespace linkwright {

std::string_view name(LineMeasure measure) { return measure == LineMeasure::strip ? "strip" : "tangent"; }

}  // namespace linkwright
