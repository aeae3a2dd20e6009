#pragma once

#include <cstdlib>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define LINKWRIGHT_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define LINKWRIGHT_SANITIZED
#endif

namespace linkwright::testing {

/// How many random cases a law is tried on: a tenth of them under sanitizers, which look at code, not at statistics; a
/// third every day, and all before a release, when script/test --all sets LINKWRIGHT_ALL_TESTS.
[[nodiscard]] inline int draws(int count) {
#ifdef LINKWRIGHT_SANITIZED
  static const int share = 10;
#else
  static const int share = std::getenv("LINKWRIGHT_ALL_TESTS") != nullptr ? 1 : 3;
#endif
  return (count + share - 1) / share;
}

/// Of what takes long: so many every day, a tenth of them under sanitizers, and so many before a release.
[[nodiscard]] inline int draws(int every_day, int before_release) {
#ifdef LINKWRIGHT_SANITIZED
  return every_day / 10 + 0 * before_release;
#else
  return std::getenv("LINKWRIGHT_ALL_TESTS") != nullptr ? before_release : every_day;
#endif
}

/// Whether they are so many that what is rare must be among them, and shares of them are near what they tend to.
#ifdef LINKWRIGHT_SANITIZED
inline constexpr bool draws_are_many = false;
#else
inline constexpr bool draws_are_many = true;
#endif

}  // namespace linkwright::testing
