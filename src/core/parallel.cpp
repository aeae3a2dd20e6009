#include "linkwright/core/parallel.hpp"

#include <algorithm>
#include <thread>

#ifndef __EMSCRIPTEN__
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace linkwright {

#ifdef __EMSCRIPTEN__

int available_threads() { return 1; }

void parallel_for(std::size_t count, int /*threads*/, const std::function<void(std::size_t, std::size_t)>& body) {
  if (count > 0) body(0, count);
}

#else

int available_threads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  const int workers = threads > 0 ? std::min(threads, available_threads()) : available_threads();
  if (workers == 1 || count == 1) return body(0, count);
  tbb::task_arena arena(workers);
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
                      [&](const tbb::blocked_range<std::size_t>& range) { body(range.begin(), range.end()); });
  });
}

#endif

}  // namespace linkwright
