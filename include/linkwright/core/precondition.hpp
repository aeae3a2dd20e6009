#pragma once

namespace linkwright {

/// A caller of the library broke what a function asks for: says the sentence on standard error and ends the program, in
/// every build. What a user can get wrong is a Result instead.
[[noreturn]] void broken_precondition(const char* sentence);

/// What a function asks of its caller, where going on would read or write what is not there.
inline void require(bool holds, const char* sentence) {
  if (!holds) [[unlikely]]
    broken_precondition(sentence);
}

}  // namespace linkwright
