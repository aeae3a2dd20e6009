#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "linkwright/files/number_text.hpp"
#include "linkwright/machine/plate_layers.hpp"

namespace linkwright {
namespace {

constexpr double least_share = 1e-4, largest_share = 10;  // of the longest link, or of the sphere's radius
constexpr double widest_on_sphere = 0.8;                  // of its radius: plates that are still bars
constexpr double layers_on_sphere = 4;                    // below the outermost, of a spherical four-bar's

std::string text(double length) { return significant_text(length, 4); }

Error out_of_range(const char* name, double value, double least, double largest) {
  return {"size_out_of_range",
          fmt::format("--{}", name),
          fmt::format("the {} is {}; beside this linkage it is a length from {} to {}", name, text(value), text(least),
                      text(largest)),
          {{"size", name}, {"value", value}, {"least", least}, {"largest", largest}}};
}

/// What is wrong with what is given; `size` of the linkage.
std::vector<Error> out_of_range(const WantedSizes& wanted, bool spherical, double size) {
  std::vector<Error> errors;
  const auto check = [&](const char* name, double value, double least, double largest) {
    if (!(value >= least && value <= largest)) errors.push_back(out_of_range(name, value, least, largest));
  };
  const auto length = [&](const char* name, double value, double largest) {
    if (value != 0) check(name, value, least_share * size, largest * size);
  };
  length("width", wanted.width, spherical ? widest_on_sphere : largest_share);
  length("thickness", wanted.thickness, largest_share);
  length("gap", wanted.gap, largest_share);
  length("pin", wanted.pin, largest_share);
  if (!(wanted.clearance < 0)) check("clearance", wanted.clearance, 0, largest_share * size);
  return errors;
}

}  // namespace

Result<PlateSizes> plate_sizes(const MovingLinkage& linkage, const WantedSizes& wanted) {
  const auto given = [](double value, double usual) { return value > 0 ? value : usual; };
  if (wanted.radius != 0 && !(wanted.radius >= 1e-9 && wanted.radius <= 1e9))
    return out_of_range("radius", wanted.radius, 1e-9, 1e9);
  PlateSizes sizes;
  sizes.radius = linkage.spherical ? given(wanted.radius, 100) : 0;
  const double size = linkage.spherical ? sizes.radius : linkage.longest_link();
  if (auto errors = out_of_range(wanted, linkage.spherical, size); !errors.empty()) return errors;
  sizes.thickness = given(wanted.thickness, 0.06 * size);
  sizes.gap = given(wanted.gap, 0.1 * sizes.thickness);
  const double inner = linkage.spherical ? sizes.radius - layers_on_sphere * sizes.pitch() : 1;
  const double narrowed = linkage.spherical ? inner / sizes.radius : 1;
  const double shortest = linkage.shortest_link() * inner;
  sizes.pin = given(wanted.pin, std::min(0.05 * size, 0.4 * shortest));
  sizes.clearance = wanted.clearance >= 0 ? wanted.clearance : 0.02 * sizes.pin;
  sizes.width = given(wanted.width, std::max(2.4 * sizes.pin, std::min(0.12 * size, 1.2 * shortest)));
  if (inner <= 0)
    return Error{"sphere_too_small",
                 "--thickness",
                 fmt::format("four layers of plates {} thick reach the centre of a sphere of radius {}; choose a "
                             "larger radius or thinner plates",
                             text(sizes.thickness), text(sizes.radius)),
                 {{"thickness", sizes.thickness}, {"radius", sizes.radius}}};
  if (const double widest = narrowed * sizes.width / 1.3; sizes.hole() > widest)
    return Error{"pin_too_wide",
                 "--pin",
                 fmt::format("plates {} wide have no room for holes {} wide; choose a pin that with its clearance is "
                             "narrower than {}, or wider plates",
                             text(narrowed * sizes.width), text(sizes.hole()), text(widest)),
                 {{"width", narrowed * sizes.width}, {"hole", sizes.hole()}, {"widest", widest}}};
  if (const double widest = shortest / 1.05; sizes.hole() > widest)
    return Error{
        "pins_overlap",
        "--pin",
        fmt::format("the holes of the shortest link, {} apart, would meet; choose a pin that with its clearance "
                    "is narrower than {}",
                    text(shortest), text(widest)),
        {{"apart", shortest}, {"widest", widest}}};
  return sizes;
}

}  // namespace linkwright
