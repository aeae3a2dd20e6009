#include "command_line.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <fmt/format.h>
#include <new>
#include <string>
#include <vector>

#include "console.hpp"
#include "linkwright/files/nearest_name.hpp"

namespace linkwright::cli {
namespace {

/// Of a command and those below it: an empty text is neither a number nor the name of a file.
void refuse_empty_texts(CLI::App& command) {
  const CLI::Validator not_empty(
      [](const std::string& text) { return text.empty() ? "a value is needed here, not an empty text" : ""; }, "");
  for (CLI::Option* option : command.get_options([](const CLI::Option* o) { return o->get_items_expected_max() > 0; }))
    option->check(not_empty);
  for (CLI::App* below : command.get_subcommands([](const CLI::App*) { return true; })) refuse_empty_texts(*below);
}

/// Where a word stands in the place of a command: which one may be meant.
std::optional<std::string> unknown_command(const CLI::App& app) {
  const CLI::App* group = &app;
  while (!group->get_subcommands().empty()) group = group->get_subcommands().front();
  std::vector<std::string> names;
  for (const CLI::App* command : group->get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  const auto rest = app.remaining(true);
  if (names.empty() || rest.empty() || rest.front().starts_with('-')) return std::nullopt;
  const std::vector<std::string_view> known(names.begin(), names.end());
  const std::string_view near = nearest_name(rest.front(), known);
  return fmt::format(
      "there is no command {}; {}", in_quotes(rest.front()),
      near.empty() ? fmt::format("there are {}", fmt::join(known, ", ")) : fmt::format("did you mean {}?", near));
}

/// One line that says what is wrong with the command line.
std::string usage_mistake(const CLI::App& app, const CLI::ParseError& error) {
  std::string command = app.get_name();
  for (auto chosen = app.get_subcommands(); !chosen.empty(); chosen = chosen.front()->get_subcommands()) {
    command += " " + chosen.front()->get_name();
  }
  std::string message = unknown_command(app).value_or(error.what());
  while (!message.empty() && (message.back() == '\n' || message.back() == '.')) message.pop_back();
  for (char& c : message) c = c == '\n' ? ' ' : c;
  return fmt::format("{}; see {} --help", message, command);
}

}  // namespace

std::optional<int> parse(CLI::App& app, int argc, char** argv) {
  refuse_empty_texts(app);
  try {
    app.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::Success& success) {  // --help, --version
    app.exit(success);
    return std::fflush(stdout) == 0 ? 0 : failure;
  } catch (const CLI::ParseError& error) {
    print_failure(usage_mistake(app, error));
    return mistake;
  }
}

int guarded(const std::function<int()>& run) {
  try {
    return run();
  } catch (const std::bad_alloc&) {
    print_failure("there is not enough memory for this; use fewer samples (--samples)");
  } catch (const std::exception& error) {
    print_failure(error.what());
  }
  return failure;
}

}  // namespace linkwright::cli
