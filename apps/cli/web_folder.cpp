#include "web_folder.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace linkwright::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::pair<std::string_view, std::string_view>, 12> media_types{{
    {".css", "text/css; charset=utf-8"},
    {".html", "text/html; charset=utf-8"},
    {".ico", "image/x-icon"},
    {".js", "text/javascript; charset=utf-8"},
    {".json", "application/json"},
    {".mjs", "text/javascript; charset=utf-8"},
    {".png", "image/png"},
    {".svg", "image/svg+xml"},
    {".txt", "text/plain; charset=utf-8"},
    {".wasm", "application/wasm"},
    {".webmanifest", "application/manifest+json"},
    {".woff2", "font/woff2"},
}};

std::string_view media_type_of(const fs::path& path) {
  const std::string extension = path.extension().string();
  const auto* const known =
      std::find_if(media_types.begin(), media_types.end(), [&](const auto& type) { return type.first == extension; });
  return known == media_types.end() ? "application/octet-stream" : known->second;
}

bool lies_within(const fs::path& folder, const fs::path& path) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

/// What a name inside of a folder may not be, by itself or as a part of a path.
bool is_plain(std::string_view url_path) {
  if (url_path.find('\0') != std::string_view::npos) return false;
  const fs::path path(url_path);
  return std::none_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".." || part == "."; });
}

}  // namespace

std::optional<WebFolder> WebFolder::open(const fs::path& folder) {
  std::error_code error;
  const fs::path whole = fs::canonical(folder, error);
  if (error || !fs::is_regular_file(whole / "index.html", error)) return std::nullopt;
  return WebFolder(whole);
}

std::optional<WebFile> WebFolder::find(std::string_view url_path) const {
  if (url_path.empty() || url_path.front() != '/' || !is_plain(url_path)) return std::nullopt;
  const fs::path name = url_path == "/" ? fs::path("index.html") : fs::path(url_path).relative_path();
  std::error_code error;
  const fs::path path = fs::canonical(folder_ / name, error);
  if (error || !lies_within(folder_, path) || !fs::is_regular_file(path, error)) return std::nullopt;
  return WebFile{path, media_type_of(path), *name.begin() == "assets"};
}

std::vector<fs::path> places_of_the_workbench() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return {};
  const fs::path bin = program.parent_path();
  std::vector<fs::path> places{(bin / LINKWRIGHT_WEB_FROM_BIN).lexically_normal()};
  const bool in_a_build_tree = fs::exists(bin.parent_path() / "CMakeCache.txt", error);
  if (in_a_build_tree) places.push_back((bin / "../../web").lexically_normal());
  return places;
}

}  // namespace linkwright::cli
