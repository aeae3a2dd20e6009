#include "linkwright/attitude/euler_sequence.hpp"

#include <fmt/format.h>
#include <optional>

namespace linkwright {
namespace {

std::optional<Axis> axis_of(char letter) {
  switch (letter) {
    case 'x':
    case 'X':
    case '1':
      return Axis::x;
    case 'y':
    case 'Y':
    case '2':
      return Axis::y;
    case 'z':
    case 'Z':
    case '3':
      return Axis::z;
    default:
      return std::nullopt;
  }
}

/// Three letters or digits; two hyphens, as in 3-1-3, or none.
std::string without_hyphens(std::string_view name) {
  if (name.size() != 5 || name[1] != '-' || name[3] != '-') return std::string(name);
  return {name[0], name[2], name[4]};
}

}  // namespace

Result<EulerSequence> EulerSequence::named(std::string_view name, Turning turning) {
  const std::string letters = without_hyphens(name);
  if (letters.size() == 3) {
    const auto a = axis_of(letters[0]), b = axis_of(letters[1]), c = axis_of(letters[2]);
    if (a && b && c && a != b && b != c) return EulerSequence(*a, *b, *c, turning);
  }
  return Error{"unknown_sequence",
               "sequence",
               fmt::format("\"{}\" is no sequence of three turns about axes: take xyz, xzy, yxz, yzx, zxy, zyx, xyx, "
                           "xzx, yxy, yzy, zxz or zyz",
                           name),
               {{"given", fmt::format("\"{}\"", name)}}};
}

const std::array<EulerSequence, 12>& EulerSequence::all(Turning turning) {
  constexpr auto list = [](Turning t) {
    constexpr Axis x = Axis::x, y = Axis::y, z = Axis::z;
    return std::array<EulerSequence, 12>{{{x, y, z, t},
                                          {x, z, y, t},
                                          {y, x, z, t},
                                          {y, z, x, t},
                                          {z, x, y, t},
                                          {z, y, x, t},
                                          {x, y, x, t},
                                          {x, z, x, t},
                                          {y, x, y, t},
                                          {y, z, y, t},
                                          {z, x, z, t},
                                          {z, y, z, t}}};
  };
  static constexpr auto intrinsic = list(Turning::intrinsic), extrinsic = list(Turning::extrinsic);
  return turning == Turning::intrinsic ? intrinsic : extrinsic;
}

std::string EulerSequence::name() const {
  constexpr std::string_view letters = "xyz";
  return {letters[static_cast<std::size_t>(first_)], letters[static_cast<std::size_t>(second_)],
          letters[static_cast<std::size_t>(third_)]};
}

}  // namespace linkwright
