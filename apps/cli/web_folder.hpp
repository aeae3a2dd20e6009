#pragma once

#include <filesystem>
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

}  // namespace linkwright::cli
