#pragma once

#include <cstddef>
#include <functional>

namespace linkwright {

/// Calls `body(begin, end)` over disjoint ranges that cover [0, count), on up to `threads` threads
/// (0 = as many as the machine has, which is also the most). The split never shows in results: bodies write to their
/// own rows. Serial where the platform has no threads (WebAssembly).
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t)>& body);

/// The number of threads that `threads` = 0 stands for.
[[nodiscard]] int available_threads();

}  // namespace linkwright
