#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "linkwright/region/criterion.hpp"

namespace linkwright {

/// The best cell of each row, or of each column, of a region.
struct Ridge {
  std::vector<float> value;            ///< 0 where no cell passes
  std::vector<std::uint32_t> partner;  ///< its column (row); the first of equals
};

struct Ridges {
  Ridge input, output;  ///< by row, by column
};

/// `values` and `failures`: of each cell, row-major; a cell passes where its failures are 0.
[[nodiscard]] Ridges ridges(std::span<const float> values, std::span<const FailureBits> failures, std::size_t columns,
                            bool larger_is_better);

}  // namespace linkwright
