#include "linkwright/core/precondition.hpp"

#include <cstdio>
#include <cstdlib>

namespace linkwright {

void broken_precondition(const char* sentence) {
  std::fputs("linkwright: broken precondition: ", stderr);
  std::fputs(sentence, stderr);
  std::fputs("\n", stderr);
  std::abort();
}

}  // namespace linkwright
