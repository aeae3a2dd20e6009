#include "linkwright/core/parallel.hpp"

#include <algorithm>
#include <thread>

#ifndef __EMSCRIPTEN__
#include <atomic>
#include <exception>
#include <memory>
#include <tbb/task_arena.h>
#endif

namespace linkwright {

#ifdef __EMSCRIPTEN__

int available_threads() { return 1; }

void parallel_for(std::size_t count, int /*threads*/, const std::function<void(std::size_t, std::size_t)>& body) {
  if (count > 0) body(0, count);
}

#else

namespace {

/// The ranges of one call, taken one by one by whoever has time: the caller from the start, helpers as they come. One
/// that comes when all are taken touches nothing but this.
class Ranges {
 public:
  Ranges(std::size_t count, std::size_t size, const std::function<void(std::size_t, std::size_t)>& body)
      : count_(count), size_(size), left_(count), body_(&body) {}

  void take_part() {
    for (;;) {
      const std::size_t begin = next_.fetch_add(size_);
      if (begin >= count_) return;
      const std::size_t end = std::min(begin + size_, count_);
      if (!failed_) call(begin, end);
      if (left_.fetch_sub(end - begin) == end - begin) left_.notify_all();
    }
  }

  /// Until those that others have begun are done, too.
  void finish() {
    for (std::size_t left = left_; left > 0; left = left_) left_.wait(left);
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  /// The first exception is the caller's to hear; what is not begun then is left.
  void call(std::size_t begin, std::size_t end) {
    try {
      (*body_)(begin, end);
    } catch (...) {
      if (!failed_.exchange(true)) failure_ = std::current_exception();
    }
  }

  const std::size_t count_, size_;
  std::atomic<std::size_t> next_ = 0, left_;
  std::atomic<bool> failed_ = false;
  std::exception_ptr failure_;
  const std::function<void(std::size_t, std::size_t)>* body_;
};

/// Threads last: making them takes longer than most of what they do.
tbb::task_arena& helpers() {
  static tbb::task_arena arena(available_threads());
  return arena;
}

}  // namespace

int available_threads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

// On a busy machine a helper may come late or never, and the caller does the work alone meanwhile: it waits for what a
// helper has begun, not for the helper.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  const int workers = threads > 0 ? std::min(threads, available_threads()) : available_threads();
  if (workers == 1 || count == 1) return body(0, count);
  constexpr std::size_t ranges_a_worker = 16;  // small: one that a helper is stopped in is waited for
  const std::size_t size = std::max<std::size_t>(1, count / (ranges_a_worker * static_cast<std::size_t>(workers)));
  const auto ranges = std::make_shared<Ranges>(count, size, body);
  for (int helper = 1; helper < workers; ++helper) helpers().enqueue([ranges] { ranges->take_part(); });
  ranges->take_part();
  ranges->finish();
}

#endif

}  // namespace linkwright
