#include "axis_label.hpp"

namespace linkwright {

bool has_values(AxisQuantity quantity) {
  return quantity == AxisQuantity::side_direction || quantity == AxisQuantity::side_length ||
         quantity == AxisQuantity::output_scale || quantity == AxisQuantity::pair_output;
}

}  // namespace linkwright
