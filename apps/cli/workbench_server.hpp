#pragma once

#include <memory>
#include <optional>
#include <string>

#include "web_folder.hpp"

namespace linkwright::cli {

/// Serves the workbench to this machine's own browsers, and to nobody else: on 127.0.0.1, and only where the address
/// names this machine, so that no foreign page can reach it by a name of its own.
class WorkbenchServer {
 public:
  /// From here on SIGINT and SIGTERM wait for serve().
  explicit WorkbenchServer(WebFolder folder);
  ~WorkbenchServer();
  WorkbenchServer(const WorkbenchServer&) = delete;
  WorkbenchServer& operator=(const WorkbenchServer&) = delete;

  /// Takes a port (0: any free one) and returns it; nothing where that fails, and errno says why.
  [[nodiscard]] std::optional<int> bind(int port);

  /// Serves until SIGINT or SIGTERM, after which a second one ends the program at once. False where serving itself
  /// failed.
  [[nodiscard]] bool serve();

 private:
  struct Http;  // keeps the large header of the HTTP library out of this one
  std::unique_ptr<Http> http_;
};

}  // namespace linkwright::cli
