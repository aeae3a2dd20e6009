#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "linkwright/files/number_text.hpp"
#include "linkwright/machine/plate_layers.hpp"

namespace linkwright {
namespace {

std::vector<Error> out_of_range(const WantedSizes& wanted) {
  std::vector<Error> errors;
  const auto check = [&](const char* name, double value, bool ok) {
    if (!ok)
      errors.push_back({"size_out_of_range",
                        fmt::format("--{}", name),
                        fmt::format("the {} of the plates is {}; it is a positive length below 1e9", name,
                                    significant_text(value, 4)),
                        {{"size", name}, {"value", value}}});
  };
  const auto length = [&](const char* name, double value) { check(name, value, value >= 0 && value < 1e9); };
  length("width", wanted.width);
  length("thickness", wanted.thickness);
  length("gap", wanted.gap);
  length("pin", wanted.pin);
  length("radius", wanted.radius);
  check("clearance", wanted.clearance, wanted.clearance < 1e9 && !std::isnan(wanted.clearance));
  return errors;
}

}  // namespace

Result<PlateSizes> plate_sizes(const MovingLinkage& linkage, const WantedSizes& wanted) {
  if (auto errors = out_of_range(wanted); !errors.empty()) return errors;
  const auto given = [](double value, double usual) { return value > 0 ? value : usual; };
  PlateSizes sizes;
  sizes.radius = linkage.spherical ? given(wanted.radius, 100) : 0;
  const double size = linkage.spherical ? sizes.radius : linkage.longest_link();
  sizes.thickness = given(wanted.thickness, 0.06 * size);
  sizes.gap = given(wanted.gap, 0.1 * sizes.thickness);
  // About a centre the innermost layer, where links are shortest, is some six layers below the outermost.
  const double inner = linkage.spherical ? sizes.radius - 4 * sizes.pitch() : 1;
  const double shortest = linkage.shortest_link() * inner;
  sizes.pin = given(wanted.pin, std::min(0.05 * size, 0.4 * shortest));
  sizes.clearance = wanted.clearance >= 0 ? wanted.clearance : 0.02 * sizes.pin;
  sizes.width = given(wanted.width, std::max(2.4 * sizes.pin, std::min(0.12 * size, 1.2 * shortest)));
  if (inner <= 0)
    return Error{"sphere_too_small",
                 "--thickness",
                 fmt::format("four layers of plates {} thick reach the centre of a sphere of radius {}; choose a "
                             "larger radius or thinner plates",
                             significant_text(sizes.thickness, 4), significant_text(sizes.radius, 4)),
                 {{"thickness", sizes.thickness}, {"radius", sizes.radius}}};
  if (const double widest = sizes.width / 1.3 - sizes.clearance; sizes.pin > widest)
    return Error{
        "pin_too_wide",
        "--pin",
        fmt::format("plates {} wide have no room for holes {} wide; choose a pin below {}",
                    significant_text(sizes.width, 4), significant_text(sizes.hole(), 4), significant_text(widest, 4)),
        {{"width", sizes.width}, {"hole", sizes.hole()}, {"widest", widest}}};
  if (const double widest = shortest / 1.05 - sizes.clearance; sizes.pin > widest)
    return Error{"pins_overlap",
                 "--pin",
                 fmt::format("the holes of the shortest link, {} apart, would meet; choose a pin below {}",
                             significant_text(shortest, 4), significant_text(widest, 4)),
                 {{"apart", shortest}, {"widest", widest}}};
  return sizes;
}

}  // namespace linkwright
