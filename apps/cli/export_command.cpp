#include <algorithm>
#include <fmt/format.h>

#include "commands.hpp"
#include "linkwright/drawing/linkage_export.hpp"
#include "linkwright/files/result_file.hpp"
#include "linkwright/files/text_file.hpp"
#include "linkwright/machine/machine_export.hpp"

namespace linkwright::cli {
namespace {

Result<std::vector<AnyStoredLinkage>> read_linkages(const std::string& path) {
  const auto text = read_text_file(path, max_result_bytes);
  return text ? read_any_result_linkages(*text) : Result<std::vector<AnyStoredLinkage>>(text.errors());
}

/// The linkage with this number, from 1, its title saying which one it is.
Result<AnyStoredLinkage> read_linkage(const std::string& path, int number) {
  auto linkages = read_linkages(path);
  if (!linkages) return linkages.errors();
  const auto count = static_cast<int>(linkages->size());
  if (number < 1 || number > count)
    return Error{"no_such_linkage", "--linkage",
                 count == 0 ? "this result holds no linkages; its \"reason\" says why"
                            : fmt::format("there is no linkage {}; this result holds 1 to {}", number, count)};
  AnyStoredLinkage linkage = std::move((*linkages)[static_cast<std::size_t>(number - 1)]);
  std::string& title = std::visit([](auto& stored) -> std::string& { return stored.title; }, linkage);
  title += fmt::format("{}linkage {}", title.empty() ? "" : ", ", number);
  return linkage;
}

bool is_of_a_machine(std::string_view format) {
  return std::ranges::find(machine_formats(), format) != machine_formats().end();
}

bool is_given(const MachineWishes& wishes) {
  const WantedSizes& s = wishes.sizes;
  return s.width != 0 || s.thickness != 0 || s.gap != 0 || s.pin != 0 || s.radius != 0 || s.clearance >= 0 ||
         wishes.position || wishes.density;
}

Result<MachineFile> exported_file(const AnyStoredLinkage& linkage, const ExportArguments& arguments) {
  if (is_of_a_machine(arguments.format)) return exported_machine(linkage, arguments.format, arguments.machine);
  if (is_given(arguments.machine))
    return Error{"wish_of_another_format", "--format",
                 fmt::format("sizes, position and density are those of {}; {} has none",
                             fmt::join(machine_formats(), ", "), arguments.format)};
  std::string text = exported(linkage, arguments.format);
  if (!text.empty()) return MachineFile{std::move(text), ""};
  return Error{
      "format_of_a_sphere", "--format",
      "the links of a spherical four-bar are arcs on a sphere, which no drawing in a plane shows at true size; "
      "export it as svg, step, stl, 3mf, csv or json"};
}

}  // namespace

int export_linkage(const ExportArguments& arguments) {
  const Interruption interruption(Interruption::Answer::at_once);
  const auto linkage = read_linkage(arguments.result, arguments.linkage);
  const auto file = linkage ? exported_file(*linkage, arguments) : Result<MachineFile>(linkage.errors());
  if (!file) {
    print_mistakes(arguments.result, file.errors());
    const std::string& code = file.errors().front().code;
    return code == "no_step_component" || code == "step_failed" ? failure : mistake;
  }
  if (!file->warning.empty()) print_failure("warning: " + file->warning);
  const bool written = write_output(arguments.output, [&](const TextSink& sink) { sink(file->content); });
  return written ? 0 : failure;
}

}  // namespace linkwright::cli
