#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/core/result.hpp"

namespace linkwright::cli {

/// What a flag of `linkwright attitude` holds, and what becomes of it in the file that says the same.
enum class FlagContent {
  number,
  numbers,    ///< 1,2,3 as a list
  list_item,  ///< 1,2,3 as one more element of a list
  matrix,     ///< nine or sixteen numbers as a list of rows
  sequence,   ///< two texts: a sequence and three angles
  link,       ///< θ,d,a,α as one more element of a list of links
  text,
  position,  ///< 1,2,3 as the position of one more point of a list
  set,       ///< no value: what `fixed_value` says
};

/// Flags that add to a list.
[[nodiscard]] constexpr bool may_repeat(FlagContent content) {
  return content == FlagContent::list_item || content == FlagContent::link || content == FlagContent::position;
}

struct AttitudeFlag {
  std::string_view name;   ///< "--axis"
  std::string_view place;  ///< in the file: "orientation.axis"
  FlagContent content = FlagContent::numbers;
  std::string_view shape;  ///< of the value, for the help: "x,y,z"
  std::string_view help;
  std::string_view fixed_value = {};  ///< JSON
};

/// The flags of a command, in the order of its help. `command`: convert, screw, twist, rates or dh.
[[nodiscard]] const std::vector<AttitudeFlag>& attitude_flags(std::string_view command);

/// The values of the flags that were given, by name; each in the order of the command line.
using FlagValues = std::map<std::string, std::vector<std::string>>;

/// The file (JSON text) that says what the flags say. Errors have the flag as their place.
[[nodiscard]] Result<std::string> file_of_flags(std::string_view command, const FlagValues& values);

/// Errors of that file, their places turned back into flags where one is meant.
[[nodiscard]] std::vector<Error> in_terms_of_flags(std::string_view command, const FlagValues& values,
                                                   std::vector<Error> errors);

}  // namespace linkwright::cli
