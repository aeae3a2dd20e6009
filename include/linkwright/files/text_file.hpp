#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "linkwright/core/result.hpp"

namespace linkwright {

/// Where a writer's text goes, piece by piece: a string, a file, standard output. Large results never exist as a whole.
using TextSink = std::function<void(std::string_view)>;

/// The whole of a file of at most `max_bytes`; "-" is standard input. Missing, unreadable and oversized files are
/// mistakes that say so; no more than `max_bytes` + 1 are ever read, whatever the path leads to.
[[nodiscard]] Result<std::string> read_text_file(const std::filesystem::path& path, std::size_t max_bytes);

/// An output file that appears whole or not at all: written to a temporary file beside it, which takes its name when
/// all is on the disk. What existed under the name stays untouched until then, and its permissions are kept.
class AtomicFile {
 public:
  /// Refuses a path that exists and is not a regular file. A symbolic link is followed.
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();  ///< without commit() nothing is left behind
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Adds text. After the first failure it does nothing; commit() tells.
  void write(std::string_view text);

  /// Flushes, closes and renames. What went wrong since the constructor, in a sentence with the system's reason.
  [[nodiscard]] std::optional<Error> commit();

  /// Where it is written until then; empty where there is none. Whoever ends the program removes it.
  [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }

 private:
  void fail(std::string_view what, int error_number);
  void open_temporary(int mode);
  void flush_buffer();
  void abandon();

  std::filesystem::path target_, temporary_;
  std::string buffer_;
  int descriptor_ = -1;
  std::optional<Error> failure_;
};

/// The whole text as a file, or why not.
[[nodiscard]] std::optional<Error> write_atomically(const std::filesystem::path& path, std::string_view text);

}  // namespace linkwright
