#include "linkwright/machine/machine_export.hpp"

#include <array>

#include "linkwright/machine/print_file.hpp"
#include "linkwright/machine/simulator_file.hpp"
#include "linkwright/machine/step_file.hpp"

namespace linkwright {
namespace {

constexpr std::array<std::string_view, 7> formats = {"step", "stl", "3mf", "plates", "mjcf", "sdf", "urdf"};

Result<std::string> content_of(const Machine& made, std::string_view format, const MachineWishes& wishes) {
  if (format == "step") return write_step(made, wishes.position);
  if (format == "stl" || format == "3mf" || format == "plates") return write_parts(made, format);
  return simulator_text(made, format, wishes.density);
}

std::string warning_of(const Machine& made) {
  if (std::string collisions = collision_text(made); !collisions.empty()) return collisions;
  if (made.layers.over == PlateLayers::Over::task)
    return "the plates are free of collisions from the first position to the last, but not over the whole travel";
  return "";
}

}  // namespace

std::span<const std::string_view> machine_formats() { return formats; }

Result<MachineFile> exported_machine(const AnyStoredLinkage& linkage, std::string_view format,
                                     const MachineWishes& wishes) {
  const auto made = machine(moving_linkage(linkage), wishes.sizes);
  if (!made) return made.errors();
  auto content = content_of(*made, format, wishes);
  if (!content) return content.errors();
  return MachineFile{std::move(content.value()), warning_of(*made)};
}

}  // namespace linkwright
