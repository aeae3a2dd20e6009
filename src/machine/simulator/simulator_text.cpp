#include <algorithm>
#include <fmt/format.h>

#include "linkwright/files/number_text.hpp"
#include "machine/simulator_file.hpp"

namespace linkwright {
namespace {

/// Of a body, kg m²: MuJoCo takes none below 1e-15, and sums of larger ones lose their digits.
constexpr double least_inertia = 1e-14, largest_inertia = 1e12;

std::vector<Error> weighed(const Machine& machine, double density) {
  for (int body = 1; body < static_cast<int>(machine.linkage.bodies.size()); ++body) {
    const Matrix3x3 inertia = mass_properties(machine, body, density).inertia;
    const double least = std::min({inertia(0, 0), inertia(1, 1), inertia(2, 2)}), most = trace(inertia);
    const std::string& name = machine.linkage.bodies[static_cast<std::size_t>(body)];
    const auto sentence = [&](const char* size, double value) {
      return fmt::format(
          "the {} is too {} for simulators: its moment of inertia is {} kg m², with the unit of length \"{}\"; "
          "set the right \"length_unit\" in the file",
          name, size, significant_text(value, 3), machine.linkage.length_unit);
    };
    if (!(least >= least_inertia))
      return {{"machine_too_small", "length_unit", sentence("small", least), {{"body", name}, {"inertia", least}}}};
    if (!(most <= largest_inertia))
      return {{"machine_too_large", "length_unit", sentence("large", most), {{"body", name}, {"inertia", most}}}};
  }
  return {};
}

}  // namespace

Result<std::string> simulator_text(const Machine& machine, std::string_view format, double density,
                                   const LinkageLoads* loads) {
  if (!(density >= 1e-3 && density <= 1e6))
    return Error{"density_out_of_range",
                 "--density",
                 fmt::format("the density is {} kg/m³; it lies between 0.001 and 1000000, steel's is 7850",
                             significant_text(density, 6)),
                 {{"value", density}}};
  const bool known = format == "mjcf" || format == "sdf" || format == "urdf";
  if (!known)
    return Error{"unknown_simulator",
                 "--format",
                 fmt::format("no simulator's format is called {}; there are mjcf, sdf and urdf", format),
                 {{"format", std::string(format)}}};
  if (auto errors = weighed(machine, density); !errors.empty()) return errors;
  return format == "mjcf"  ? write_mjcf(machine, density, loads)
         : format == "sdf" ? write_sdf(machine, density)
                           : write_urdf(machine, density);
}

}  // namespace linkwright
