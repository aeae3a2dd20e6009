#include "linkwright/files/motion_table.hpp"

#include <cmath>
#include <fmt/format.h>

#include "linkwright/files/number_text.hpp"

namespace linkwright {

std::string csv_text(const MotionTable& table) {
  std::string text = fmt::format("{}\n", fmt::join(table.columns, ","));
  const std::size_t columns = table.columns.size();
  for (std::size_t i = 0; i < table.values.size(); ++i) {
    if (!std::isnan(table.values[i])) text += exact_text(table.values[i]);
    text += (i + 1) % columns == 0 ? '\n' : ',';
  }
  return text;
}

}  // namespace linkwright
