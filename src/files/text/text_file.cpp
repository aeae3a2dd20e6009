#include "linkwright/files/text_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <memory>

namespace linkwright {
namespace {

Error cannot_read(int error_number) {
  return {
      "unreadable_file",
      "",
      fmt::format("this file cannot be read: {}; check its name and that you may read it", std::strerror(error_number)),
      {{"reason", std::strerror(error_number)}}};
}

Error too_large(std::size_t max_bytes) {
  return {"file_too_large",
          "",
          fmt::format("this file is larger than {} MiB, the most that is read; a Linkwright file is far smaller",
                      max_bytes >> 20),
          {{"most", max_bytes >> 20}}};
}

Result<std::string> read_all(std::FILE* file, std::size_t max_bytes) {
  constexpr std::size_t piece = 1 << 16;
  std::string text;
  while (text.size() <= max_bytes) {
    const std::size_t size = text.size();
    text.resize(size + piece);
    errno = 0;
    const std::size_t count = std::fread(text.data() + size, 1, piece, file);
    text.resize(size + count);
    if (std::ferror(file)) return cannot_read(errno);
    if (count < piece) break;
  }
  if (text.size() > max_bytes) return too_large(max_bytes);
  return text;
}

}  // namespace

Result<std::string> read_text_file(const std::filesystem::path& path, std::size_t max_bytes) {
  if (path == "-") return read_all(stdin, max_bytes);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) return cannot_read(errno);
  return read_all(file.get(), max_bytes);
}

}  // namespace linkwright
