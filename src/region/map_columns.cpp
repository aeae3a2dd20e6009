#include "linkwright/region/map_columns.hpp"

#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace linkwright {

void* allocate_cells(std::size_t bytes) {
  constexpr std::size_t line = 64, large_page = std::size_t{1} << 21;
  const std::size_t unit = bytes < 2 * large_page ? line : large_page;
  void* cells = std::aligned_alloc(unit, (bytes / unit + 1) * unit);
  if (!cells) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  if (unit == large_page) madvise(cells, bytes, MADV_HUGEPAGE);  // a wish; without it the map is only slower
#endif
  return cells;
}

void FreeCells::operator()(void* cells) const { std::free(cells); }

}  // namespace linkwright
