#include "linkwright/core/parallel.hpp"

#include <algorithm>
#include <thread>

#ifndef __EMSCRIPTEN__
#include <atomic>
#include <exception>
#include <tbb/task_group.h>
#endif

namespace linkwright {

#ifdef __EMSCRIPTEN__

int available_threads() { return 1; }

void parallel_for(std::size_t count, int /*threads*/, const std::function<void(std::size_t, std::size_t)>& body) {
  if (count > 0) body(0, count);
}

#else

namespace {

/// The ranges of one call, taken one by one by whoever has time: the caller from the start, helpers as they come.
class Ranges {
 public:
  Ranges(std::size_t count, std::size_t size, const std::function<void(std::size_t, std::size_t)>& body)
      : count_(count), size_(size), body_(body) {}

  void take_part() {
    for (std::size_t begin = next_.fetch_add(size_); begin < count_ && !failed_; begin = next_.fetch_add(size_))
      call(begin, std::min(begin + size_, count_));
  }

  void rethrow_failure() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  /// The first exception is the caller's to hear; what is not begun then is left.
  void call(std::size_t begin, std::size_t end) {
    try {
      body_(begin, end);
    } catch (...) {
      if (!failed_.exchange(true)) failure_ = std::current_exception();
    }
  }

  const std::size_t count_, size_;
  const std::function<void(std::size_t, std::size_t)>& body_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> failed_ = false;
  std::exception_ptr failure_;
};

}  // namespace

int available_threads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

// On a busy machine a helper may come late or never. The caller does the work alone meanwhile, and what no helper has
// begun is taken back: it waits for ranges that are under way, not for helpers.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  const int workers = threads > 0 ? std::min(threads, available_threads()) : available_threads();
  if (workers == 1 || count == 1) return body(0, count);
  constexpr std::size_t ranges_a_worker = 16;  // small: one that a helper is stopped in is waited for
  const std::size_t size = std::max<std::size_t>(1, count / (ranges_a_worker * static_cast<std::size_t>(workers)));
  Ranges ranges(count, size, body);
  tbb::task_group helpers;
  for (int helper = 1; helper < workers; ++helper) helpers.run([&ranges] { ranges.take_part(); });
  ranges.take_part();
  helpers.wait();
  ranges.rethrow_failure();
}

#endif

}  // namespace linkwright
