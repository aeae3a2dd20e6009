#include "axis_label.hpp"

namespace linkwright {

bool has_values(AxisQuantity quantity) {
  return quantity != AxisQuantity::curve_coordinate && quantity != AxisQuantity::burmester_point &&
         quantity != AxisQuantity::nothing && quantity != AxisQuantity::layer &&
         quantity != AxisQuantity::fitted_curve && quantity != AxisQuantity::realisation;
}

}  // namespace linkwright
