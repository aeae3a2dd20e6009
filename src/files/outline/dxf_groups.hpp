#pragma once

#include <limits>
#include <map>
#include <string_view>
#include <vector>

#include "linkwright/core/result.hpp"

namespace linkwright {

/// A line with a code and the line after it.
struct DxfGroup {
  int code = 0;
  std::string_view value;
};

/// What begins with a group of code 0: its type, and its groups up to the next.
struct DxfEntity {
  static constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

  std::string_view type;
  std::vector<DxfGroup> groups;

  /// The last group of a code.
  [[nodiscard]] std::string_view text(int code) const;
  [[nodiscard]] double number(int code, double otherwise = nothing) const;
  [[nodiscard]] int whole_number(int code) const;  ///< 0 where there is none
};

struct DxfBlock {
  double x = 0, y = 0;  ///< base point
  std::vector<DxfEntity> entities;
};

struct DxfFile {
  int unit = 0;  ///< $INSUNITS
  std::map<std::string_view, DxfBlock> blocks;
  std::vector<DxfEntity> entities;
};

/// The groups of an ASCII DXF: views of the text.
[[nodiscard]] Result<DxfFile> read_dxf(std::string_view text);

}  // namespace linkwright
