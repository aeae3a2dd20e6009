#include <cerrno>
#include <cstring>
#include <fmt/format.h>

#include "commands.hpp"
#include "workbench_server.hpp"

namespace linkwright::cli {
namespace {

constexpr int preferred_port = 4180;

std::optional<WebFolder> find_workbench() {
  std::string missing;
  for (const auto& place : places_of_the_workbench()) {
    if (auto folder = WebFolder::open(place)) return folder;
    missing += (missing.empty() ? "" : " or ") + place.string();
  }
  print_failure(
      fmt::format("the workbench is not built: there is no index.html in {}; run script/build, or name its folder "
                  "with --folder",
                  missing));
  return std::nullopt;
}

/// The port asked for, or the preferred one, or any.
std::optional<int> bind(WorkbenchServer& server, std::optional<int> wanted) {
  auto port = server.bind(wanted.value_or(preferred_port));
  if (!port && !wanted) port = server.bind(0);
  if (port) return port;
  const std::string reason = errno == EADDRINUSE ? "another program has it"
                             : errno != 0        ? std::strerror(errno)
                                                 : "it cannot be had";
  print_failure(wanted
                    ? fmt::format("port {}: {}; choose another, or leave --port out to get a free one", *wanted, reason)
                    : fmt::format("no port of 127.0.0.1 can be had: {}", reason));
  return std::nullopt;
}

}  // namespace

int studio(const StudioArguments& arguments) {
  auto folder = arguments.folder.empty() ? find_workbench() : WebFolder::open(arguments.folder);
  if (!folder && arguments.folder.empty()) return failure;
  if (!folder) {
    print_mistakes(arguments.folder,
                   {{"no_workbench", "--folder", "holds no index.html; the workbench is built by script/build"}});
    return mistake;
  }
  WorkbenchServer server(std::move(*folder));
  const auto port = bind(server, arguments.port);
  if (!port) return failure;
  if (!print_answer(fmt::format("The workbench is at http://127.0.0.1:{}/ (Ctrl-C stops)\n", *port))) return failure;
  if (server.serve()) return 0;
  print_failure("the workbench can no longer be served: its port was closed; start it again");
  return failure;
}

}  // namespace linkwright::cli
