#pragma once

#include <string>

#include "linkwright/core/values.hpp"

namespace linkwright {

/// Something to tell the user about an answer: a sentence, and what it says in a form that others can word anew.
struct Notice {
  std::string code;     ///< stable identifier, e.g. ill_conditioned
  std::string message;  ///< one sentence or two, with the way out
  Values values;        ///< the numbers and words in the message
};

}  // namespace linkwright
