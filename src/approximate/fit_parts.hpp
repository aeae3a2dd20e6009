#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

#include "linkwright/core/parallel.hpp"
#include "linkwright/core/progress.hpp"

namespace linkwright {

/// Each index by itself, in parts between which progress is told.
inline void for_all_in_parts(std::size_t count, int threads, const Progress& progress, double from, double to,
                             const std::function<void(std::size_t)>& body) {
  constexpr std::size_t parts = 8;
  for (std::size_t part = 0; part < parts && !progress.is_cancelled(); ++part) {
    const std::size_t begin = count * part / parts, end = count * (part + 1) / parts;
    parallel_for(end - begin, threads, [&](std::size_t low, std::size_t high) {
      for (std::size_t k = begin + low; k < begin + high && !progress.is_cancelled(); ++k) body(k);
    });
    progress(from + (to - from) * static_cast<double>(part + 1) / static_cast<double>(parts));
  }
}

/// The least cost first.
template <class Start>
void sort_by_cost(std::vector<Start>& starts) {
  std::stable_sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) { return a.cost() < b.cost(); });
}

}  // namespace linkwright
