#include <fmt/format.h>

#include "attitude_flags.hpp"
#include "commands.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/text_file.hpp"
#include "report.hpp"

namespace linkwright::cli {
namespace {

/// Where the task comes from, and how its mistakes are told.
class Source {
 public:
  explicit Source(const AttitudeArguments& arguments) : arguments_(&arguments) {}

  [[nodiscard]] Result<std::string> text() const {
    if (arguments_->flags.empty()) return read_text_file(arguments_->input, max_file_bytes);
    return file_of_flags(arguments_->command, arguments_->flags);
  }
  void tell(const std::vector<Error>& mistakes) const {
    if (arguments_->flags.empty()) return print_mistakes(arguments_->input, mistakes);
    print_mistakes("linkwright attitude " + arguments_->command,
                   in_terms_of_flags(arguments_->command, arguments_->flags, mistakes));
  }

 private:
  const AttitudeArguments* arguments_;
};

bool write_file(const std::string& path, const std::string& text) {
  return path.empty() || write_output(path, [&](const TextSink& sink) { sink(text); });
}

/// Reads the task, makes the report, writes what was asked for, prints the rest.
template <class Task, class Report>
int answer(const AttitudeArguments& arguments, Result<Task> (*read)(std::string_view),
           const std::function<Result<Report>(const Task&)>& make, std::string (*write)(const Report&),
           std::string (*words)(const Report&), const std::function<std::string(const Report&)>& draw) {
  const Source source(arguments);
  const auto text = source.text();
  const auto task = text ? read(*text) : Result<Task>(text.errors());
  const auto report = task ? make(*task) : Result<Report>(task.errors());
  if (!report) {
    source.tell(report.errors());
    return mistake;
  }
  if (!arguments.picture.empty() && !write_file(arguments.picture, draw(*report))) return failure;
  if (!write_file(arguments.report, write(*report))) return failure;
  return arguments.report == "-" || print_answer(words(*report)) ? 0 : failure;
}

/// The way of the input that is missing or double, in words; nothing where there is one.
std::optional<Error> input_mistake(const AttitudeArguments& arguments) {
  const std::string_view first = attitude_flags(arguments.command).front().name;
  if (arguments.input.empty() && arguments.flags.empty()) {
    return Error{"no_input", "",
                 fmt::format("a file IN.json or flags like {} are needed; see linkwright attitude {} --help", first,
                             arguments.command)};
  }
  if (!arguments.input.empty() && !arguments.flags.empty()) {
    return Error{"two_inputs", arguments.flags.begin()->first, "give either the file IN.json or flags, not both"};
  }
  return std::nullopt;
}

}  // namespace

int attitude(const AttitudeArguments& arguments) {
  const Interruption interruption(Interruption::Answer::at_once);
  if (const auto error = input_mistake(arguments)) {
    print_mistakes("linkwright attitude " + arguments.command, {*error});
    return mistake;
  }
  if (arguments.command == "convert") {
    return answer<OrientationTask, OrientationReport>(
        arguments, read_orientation_task, [](const auto& task) { return Result(orientation_report(task)); },
        write_orientation_report, orientation_words, draw_orientation);
  }
  if (arguments.command == "screw") {
    return answer<DisplacementTask, DisplacementReport>(arguments, read_displacement_task, displacement_report,
                                                        write_displacement_report, displacement_words,
                                                        draw_displacement);
  }
  if (arguments.command == "twist") {
    return answer<TwistTask, TwistReport>(arguments, read_twist_task, twist_report, write_twist_report, twist_words,
                                          {});
  }
  if (arguments.command == "rates") {
    return answer<AngularMotionTask, AngularMotionReport>(arguments, read_angular_motion_task, angular_motion_report,
                                                          write_angular_motion_report, angular_motion_words, {});
  }
  return answer<LinkChainTask, LinkChainReport>(arguments, read_link_chain_task, link_chain_report,
                                                write_link_chain_report, link_chain_words, {});
}

}  // namespace linkwright::cli
