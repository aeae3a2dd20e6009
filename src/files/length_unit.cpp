#include "linkwright/files/length_unit.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "files/text/plain_text.hpp"

namespace linkwright {

std::optional<double> millimetres(std::string_view unit) {
  struct Length {
    std::string_view name;
    double mm;
  };
  constexpr std::array<Length, 11> lengths = {{{"µm", 1e-3},
                                               {"μm", 1e-3},
                                               {"um", 1e-3},
                                               {"mm", 1},
                                               {"cm", 10},
                                               {"dm", 100},
                                               {"m", 1000},
                                               {"in", 25.4},
                                               {"inch", 25.4},
                                               {"\"", 25.4},
                                               {"ft", 304.8}}};
  const std::string name = in_small_letters(unit);
  const auto found =
      std::find_if(lengths.begin(), lengths.end(), [&](const Length& length) { return length.name == name; });
  return found == lengths.end() ? std::nullopt : std::optional(found->mm);
}

}  // namespace linkwright
