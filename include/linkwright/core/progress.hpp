#pragma once

#include <atomic>
#include <functional>

namespace linkwright {

/// How long work tells how far it is and learns that it should stop. Both are optional.
struct Progress {
  std::function<void(double done)> report;       ///< done in [0, 1]; called from the calling thread only
  const std::atomic<bool>* cancelled = nullptr;  ///< looked at between rows of a region and between refinements

  /// The caller asks to stop; may be asked from any thread.
  [[nodiscard]] bool is_cancelled() const { return cancelled && cancelled->load(std::memory_order_relaxed); }
  void operator()(double done) const {
    if (report) report(done);
  }
};

}  // namespace linkwright
