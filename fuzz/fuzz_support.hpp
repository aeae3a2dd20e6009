#pragma once

#include <cstdlib>
#include <vector>

#include "linkwright/core/result.hpp"

// What every fuzz target asks of what it tests.
namespace linkwright::fuzz {

inline void require(bool holds) {
  if (!holds) std::abort();
}

/// A refusal says what and has a code.
inline void check_errors(const std::vector<Error>& errors) {
  require(!errors.empty());
  for (const Error& error : errors) require(!error.code.empty() && !error.message.empty());
}

}  // namespace linkwright::fuzz
