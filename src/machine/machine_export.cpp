#include "linkwright/machine/machine_export.hpp"

#include <array>
#include <fmt/format.h>
#include <utility>

#include "linkwright/files/length_unit.hpp"
#include "linkwright/loads/spring_charge.hpp"
#include "print_file.hpp"
#include "simulator_file.hpp"
#include "spring_parts.hpp"
#include "step_file.hpp"

namespace linkwright {
namespace {

constexpr std::array<std::string_view, 7> formats = {"step", "stl", "3mf", "plates", "mjcf", "sdf", "urdf"};

/// Nothing of what is no four-bar with its poses.
std::optional<LinkageLoads> loads_on(const AnyStoredLinkage& linkage, const MachineWishes& wishes) {
  const auto* four_bar = std::get_if<StoredLinkage>(&linkage);
  if (!wishes.loads || !four_bar || four_bar->poses.empty()) return std::nullopt;
  return LinkageLoads{loads_as_used(*wishes.loads, four_bar->four_bar, four_bar->poses), four_bar->four_bar,
                      four_bar->poses};
}

Result<std::string> assembly(Machine made, const std::optional<LinkageLoads>& loads, int position) {
  if (loads)
    for (Part& part : spring_parts(made, *loads, position)) made.parts.push_back(std::move(part));
  return write_step(made, position);
}

Result<std::string> content_of(const Machine& made, std::string_view format, const AnyStoredLinkage& linkage,
                               const MachineWishes& wishes) {
  if (format == "stl" || format == "3mf" || format == "plates") return write_parts(made, format);
  const auto loads = loads_on(linkage, wishes);
  if (format == "step") return assembly(made, loads, wishes.position.value_or(0));
  return simulator_text(made, format, wishes.density.value_or(steel_density), loads ? &*loads : nullptr);
}

/// What has no meaning in a file of this format.
std::optional<Error> idle_wish(const AnyStoredLinkage& linkage, std::string_view format, const MachineWishes& wishes) {
  const auto idle = [&](const char* flag, const char* of) {
    return Error{
        "wish_of_another_format", flag, fmt::format("{} means something for {} only; leave it out", flag, of), {}};
  };
  const bool for_simulators = format == "mjcf" || format == "sdf" || format == "urdf";
  if (wishes.position && format != "step") return idle("--position", "STEP files");
  if (wishes.density && !for_simulators) return idle("--density", "simulators (mjcf, sdf and urdf)");
  if (wishes.sizes.radius != 0 && !std::holds_alternative<StoredSphericalFourBar>(linkage))
    return idle("--radius", "spherical linkages");
  return {};
}

std::string warning_of(const Machine& made) {
  std::string words = collision_text(made);
  if (words.empty() && made.layers.over == PlateLayers::Over::task)
    words = "the plates are free of collisions from the first position to the last, but not over the whole travel";
  const std::string& unit = made.linkage.length_unit;
  if (unit.empty() && made.linkage.spherical) return words;
  const std::string of_unit = unit_warning(unit, "lengths are taken for millimetres");
  return words + (words.empty() || of_unit.empty() ? "" : "; ") + of_unit;
}

}  // namespace

std::span<const std::string_view> machine_formats() { return formats; }

Result<MachineFile> exported_machine(const AnyStoredLinkage& linkage, std::string_view format,
                                     const MachineWishes& wishes) {
  if (auto idle = idle_wish(linkage, format, wishes)) return std::move(*idle);
  const auto made = machine(moving_linkage(linkage), wishes.sizes);
  if (!made) return made.errors();
  auto content = content_of(*made, format, linkage, wishes);
  if (!content) return content.errors();
  return MachineFile{std::move(content.value()), warning_of(*made)};
}

}  // namespace linkwright
