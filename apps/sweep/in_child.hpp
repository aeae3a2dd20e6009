#pragma once

#include <chrono>
#include <functional>
#include <optional>

namespace linkwright {

/// How a process ended.
struct ChildEnd {
  std::optional<int> status;  ///< 0 to 255; nothing: it came to no end of its own
  int signal = 0;             ///< that ended it; 0 without a status: it could not be started

  /// Its own doing: it crashed, or had computed for too long.
  [[nodiscard]] bool crashed() const;
};

/// Lets a process of its own do the work, which ends with this one: for what may crash or never end, as HDF5 does on
/// some damaged files. A signal ends it when it has computed for `longest`. To be called while there are no other
/// threads.
[[nodiscard]] ChildEnd in_child(std::chrono::seconds longest, const std::function<int()>& work);

}  // namespace linkwright
