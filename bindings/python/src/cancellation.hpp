#pragma once

#include <atomic>

namespace linkwright::python {

/// Asked by any thread, heard by the one that solves.
struct Cancellation {
  std::atomic<bool> asked{false};
};

}  // namespace linkwright::python
