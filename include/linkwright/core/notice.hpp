#pragma once

#include <string>
#include <variant>
#include <vector>

namespace linkwright {

/// Something to tell the user about an answer: a sentence, and what it says in a form that others can word anew.
struct Notice {
  struct Value {
    std::string name;
    std::variant<double, std::string> value;
  };

  std::string code;           ///< stable identifier, e.g. ill_conditioned
  std::string message;        ///< one sentence or two, with the way out
  std::vector<Value> values;  ///< the numbers and words in the message
};

}  // namespace linkwright
