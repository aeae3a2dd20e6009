#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace linkwright::cli {

struct WebFile {
  std::filesystem::path path;
  std::string_view media_type;
  bool never_changes = false;  ///< its name holds a hash of its content
};

/// The folder of the built workbench, seen as pages. Nothing outside of it can be named: not by "..", and not by a
/// symbolic link inside.
class WebFolder {
 public:
  /// Nothing where the folder holds no index.html.
  [[nodiscard]] static std::optional<WebFolder> open(const std::filesystem::path& folder);

  /// The file behind the path of an address, already decoded; nothing where there is none.
  [[nodiscard]] std::optional<WebFile> find(std::string_view url_path) const;

 private:
  explicit WebFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}
  std::filesystem::path folder_;  ///< canonical
};

/// Where the built workbench may lie, best first: beside the installed program, or in the tree that built it.
[[nodiscard]] std::vector<std::filesystem::path> places_of_the_workbench();

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
