#pragma once

#include <chrono>
#include <functional>
#include <optional>

namespace linkwright {

/// The exit status, 0 to 255, of work that a process of its own does, which ends with this one: for what may crash or
/// never end, as HDF5 does on some damaged files. Nothing where a signal ended it, or where it had computed for
/// `longest`. To be called while there are no other threads.
[[nodiscard]] std::optional<int> in_child(std::chrono::seconds longest, const std::function<int()>& work);

}  // namespace linkwright
