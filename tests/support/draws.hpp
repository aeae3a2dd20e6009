#pragma once

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define LINKWRIGHT_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define LINKWRIGHT_SANITIZED
#endif

namespace linkwright::testing {

/// How many random cases a law is tried on: a tenth of them under sanitizers, which look at code, not at statistics.
[[nodiscard]] constexpr int draws(int count) {
#ifdef LINKWRIGHT_SANITIZED
  return (count + 9) / 10;
#else
  return count;
#endif
}

}  // namespace linkwright::testing
