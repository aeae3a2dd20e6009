#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace linkwright {

/// A motion as numbers: a row a state, a column a quantity.
struct MotionTable {
  std::vector<std::string> columns;  ///< names, units in them
  std::vector<double> values;        ///< row-major; NaN: not defined there

  [[nodiscard]] std::size_t rows() const { return columns.empty() ? 0 : values.size() / columns.size(); }
};

/// As comma-separated values, one header line and one line a row; nothing between two commas where it is not defined.
/// Numbers read back bit-identical.
[[nodiscard]] std::string csv_text(const MotionTable& table);

}  // namespace linkwright
