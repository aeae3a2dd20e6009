#include "step_file.hpp"

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <fmt/format.h>
#include <vector>

#include "linkwright/files/number_text.hpp"
#include "machine/step_component.hpp"

namespace linkwright {
namespace {

constexpr const char* file_name = "linkwright_step.so";
constexpr double least_mm = 1e-3, largest_mm = 1e7;  // beside OpenCASCADE's own precision of 1e-7 mm

/// Of the program or module that this code is part of; empty where the system does not say.
std::filesystem::path own_folder() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&own_folder), &info) == 0 || info.dli_fname == nullptr) return {};
  std::error_code ignored;
  const std::filesystem::path file = std::filesystem::canonical(info.dli_fname, ignored);
  return (file.empty() ? std::filesystem::canonical("/proc/self/exe", ignored) : file).parent_path();
}

std::vector<std::filesystem::path> candidates() {
  std::vector<std::filesystem::path> files;
  if (const char* folder = std::getenv("LINKWRIGHT_COMPONENTS"); folder != nullptr && *folder != '\0')
    files.emplace_back(std::filesystem::path(folder) / file_name);
  const std::filesystem::path own = own_folder();
  if (!own.empty()) {
    files.push_back(own / file_name);
    files.push_back(own / ".." / LINKWRIGHT_COMPONENT_DIR / file_name);
  }
  return files;
}

Result<StepWriter*> loaded() {
  std::string why = "the component is not installed";
  for (const std::filesystem::path& file : candidates()) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) continue;
    // Never closed: what it links keeps its own threads and tables.
    void* component = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (component == nullptr) {
      why = dlerror();
      continue;
    }
    auto* version = reinterpret_cast<StepVersion*>(dlsym(component, "linkwright_step_version"));
    auto* writer = reinterpret_cast<StepWriter*>(dlsym(component, "linkwright_step_writer"));
    auto* layout = reinterpret_cast<StepLayout*>(dlsym(component, "linkwright_step_layout"));
    if (version != nullptr && layout != nullptr && writer != nullptr &&
        std::string_view(version()) == LINKWRIGHT_VERSION && layout() == machine_layout)
      return writer;
    why = fmt::format("{} belongs to another version", file.string());
  }
  return Error{
      "no_step_component",
      "--format",
      fmt::format("STEP files need a component that stands on OpenCASCADE: {}. Install the package linkwright-step; "
                  "in a checkout, libocct-data-exchange-dev, and build again",
                  why),
      {{"why", why}}};
}

}  // namespace

Result<std::string> write_step(const Machine& machine, int position) {
  const MovingLinkage& linkage = machine.linkage;
  if (position < 0 || position >= linkage.positions || linkage.at_position(position) == nullptr)
    return Error{
        "no_such_position",
        "--position",
        fmt::format("the linkage does not get to a position {}; its task has 1 to {}", position + 1, linkage.positions),
        {{"position", position + 1}, {"positions", linkage.positions}}};
  const double longest = linkage.millimetres() * (linkage.spherical ? machine.sizes.radius : linkage.longest_link());
  if (!(longest >= least_mm && longest <= largest_mm))
    return Error{
        "step_size",
        "",
        fmt::format("STEP files are for links from {} to {} mm; the longest has {} mm", significant_text(least_mm, 4),
                    significant_text(largest_mm, 4), significant_text(longest, 4)),
        {{"longest", longest}, {"least", least_mm}, {"largest", largest_mm}}};
  const auto writer = loaded();
  if (!writer) return writer.errors();
  std::string text;
  if (!(**writer)(machine, position, linkage.millimetres(), text))
    return Error{"step_failed", "", "OpenCASCADE could not make the solids: " + text, {{"why", text}}};
  return text;
}

}  // namespace linkwright
