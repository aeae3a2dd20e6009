#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "commands.hpp"
#include "linkwright/analyses/load_study.hpp"
#include "linkwright/drawing/linkage_export.hpp"
#include "linkwright/files/length_unit.hpp"
#include "linkwright/files/position_error.hpp"
#include "linkwright/files/result_file.hpp"
#include "linkwright/files/text_file.hpp"
#include "linkwright/machine/machine_export.hpp"

namespace linkwright::cli {
namespace {

/// Of a result, where files of the format tell them.
std::optional<Loads> told_loads(std::string_view format, std::string_view text) {
  constexpr std::array<std::string_view, 4> telling = {"dxf", "mjcf", "step", "svg"};
  return std::ranges::find(telling, format) != telling.end() ? loads_of_result(text) : std::nullopt;
}

/// The linkage with this number, from 1; of a result its title says which one it is.
Result<AnyStoredLinkage> read_linkage(std::string_view text, int number) {
  auto file = read_linkages_of_file(text);
  if (!file) return file.errors();
  const auto count = static_cast<int>(file->linkages.size());
  if (number < 1 || number > count)
    return Error{"no_such_linkage", "--linkage",
                 !file->is_result ? fmt::format("there is no linkage {}; this file holds one", number)
                 : count == 0     ? "this result holds no linkages; its \"reason\" says why"
                                  : fmt::format("there is no linkage {}; this result holds 1 to {}", number, count)};
  AnyStoredLinkage linkage = std::move(file->linkages[static_cast<std::size_t>(number - 1)]);
  if (!file->is_result) return linkage;
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

/// A drawing without a unit says nothing of one; a unit that DXF does not know is said.
std::string warning_of_drawing(const AnyStoredLinkage& linkage, std::string_view format) {
  const std::string& unit =
      std::visit([](const auto& stored) -> const std::string& { return stored.length_unit; }, linkage);
  return format != "dxf" || unit.empty() ? "" : unit_warning(unit, "the drawing has none");
}

Result<MachineFile> exported_file(const AnyStoredLinkage& linkage, const ExportArguments& arguments,
                                  std::string_view text_of_file) {
  const auto loads = told_loads(arguments.format, text_of_file);
  if (is_of_a_machine(arguments.format)) {
    MachineWishes wishes = arguments.machine;
    wishes.loads = loads;
    return exported_machine(linkage, arguments.format, wishes);
  }
  if (is_given(arguments.machine))
    return Error{"wish_of_another_format", "--format",
                 fmt::format("sizes, position and density are those of {}; {} has none",
                             fmt::join(machine_formats(), ", "), arguments.format)};
  std::string text = exported(linkage, arguments.format, loads);
  if (!text.empty()) return MachineFile{std::move(text), warning_of_drawing(linkage, arguments.format)};
  return Error{
      "format_of_a_sphere", "--format",
      "the links of a spherical four-bar are arcs on a sphere, which no drawing in a plane shows at true size; "
      "export it as svg, step, stl, 3mf, csv or json"};
}

}  // namespace

int export_linkage(const ExportArguments& arguments) {
  const Interruption interruption(Interruption::Answer::at_once);
  const auto text = read_text_file(arguments.result, max_result_bytes);
  const auto linkage = text ? read_linkage(*text, arguments.linkage) : Result<AnyStoredLinkage>(text.errors());
  const auto file = linkage ? exported_file(*linkage, arguments, *text) : Result<MachineFile>(linkage.errors());
  if (!file) {
    print_mistakes(arguments.result, file.errors());
    const std::string& code = file.errors().front().code;
    return code == "no_step_component" || code == "step_failed" ? failure : mistake;
  }
  for (const std::string& warning : {file->warning, position_error_words(*linkage)})
    if (!warning.empty()) print_failure("warning: " + warning);
  const bool written = write_output(arguments.output, [&](const TextSink& sink) { sink(file->content); });
  return written ? 0 : failure;
}

}  // namespace linkwright::cli
