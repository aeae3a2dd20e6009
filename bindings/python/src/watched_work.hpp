#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "bindings.hpp"
#include "linkwright/core/progress.hpp"

namespace linkwright::python {

/// Work in a thread of its own, while the calling thread, which alone hears Ctrl-C, looks after Python.
class WatchedWork {
 public:
  explicit WatchedWork(std::function<void()> work) : thread_([this, work = std::move(work)] { run(work); }) {}
  ~WatchedWork() { thread_.join(); }
  WatchedWork(const WatchedWork&) = delete;
  WatchedWork& operator=(const WatchedWork&) = delete;

  /// Done before the time is over.
  [[nodiscard]] bool wait_for(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    return finished_.wait_for(lock, time, [this] { return is_finished_; });
  }

 private:
  void run(const std::function<void()>& work) {
    work();
    // Told under the lock: whoever waits may end this object as soon as it is free.
    const std::lock_guard lock(mutex_);
    is_finished_ = true;
    finished_.notify_one();
  }

  std::mutex mutex_;
  std::condition_variable finished_;
  bool is_finished_ = false;
  std::thread thread_;
};

/// What `work` makes of a progress, without the GIL. It is asked to stop by Ctrl-C and by what `report`, which hears
/// the share done, raises, both of which are raised here; and by `cancelled`, where there is one.
template <class Work>
auto watched(const Work& work, const py::object& report = py::none(), const std::atomic<bool>* cancelled = nullptr) {
  constexpr std::chrono::milliseconds between_looks{50};
  std::atomic<double> done{0};
  std::atomic<bool> stop{false};
  const Progress progress{[&](double share) { done = share; }, &stop};
  std::optional<decltype(work(progress))> found;
  std::exception_ptr failed;
  std::optional<py::error_already_set> interruption;
  {
    const py::gil_scoped_release free;
    WatchedWork thread([&] {
      try {
        found.emplace(work(progress));
      } catch (...) {
        failed = std::current_exception();
      }
    });
    while (!thread.wait_for(between_looks)) {
      if (cancelled && *cancelled) stop = true;
      if (stop) continue;
      const py::gil_scoped_acquire python;
      try {
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        if (!report.is_none()) report(done.load());
      } catch (py::error_already_set& error) {
        interruption.emplace(std::move(error));
        stop = true;
      }
    }
  }
  if (interruption) throw *std::move(interruption);
  if (failed) std::rethrow_exception(failed);
  return *std::move(found);
}

}  // namespace linkwright::python
