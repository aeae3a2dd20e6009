#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/core/progress.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/files/text_file.hpp"

namespace linkwright::cli {

/// Exit statuses.
enum class Status : int { done = 0, failure = 1, mistake = 2 };
inline constexpr int mistake = static_cast<int>(Status::mistake), failure = static_cast<int>(Status::failure);

/// A line for each mistake on standard error: "file: place: message".
void print_mistakes(std::string_view file, const std::vector<Error>& mistakes);

/// A line on standard error: "linkwright: message".
void print_failure(std::string_view message);

/// What a command prints for people, on standard output; false where it cannot be written (said on standard error).
[[nodiscard]] bool print_answer(std::string_view text);

/// Lets `writer` write to a file, whole or not at all, or to standard output for "-"; false where that fails (said on
/// standard error) or Ctrl-C stopped it.
[[nodiscard]] bool write_output(const std::filesystem::path& path, const std::function<void(const TextSink&)>& writer);

/// Ctrl-C and SIGTERM end the program within half a second, with nothing half written: at once, or as soon as the work
/// has stopped when it was asked to; what then takes longer, or a second signal, ends it at once.
class Interruption {
 public:
  enum class Answer { at_once, when_asked };
  explicit Interruption(Answer answer);
  [[nodiscard]] static bool happened();
  [[nodiscard]] static const std::atomic<bool>* flag();
  /// The work has stopped as asked and has something to show: what follows counts as not interrupted.
  static void settle();
  /// What became of the output where nobody else is asked, from here on; lives as long as the program.
  static void set_words(const char* words);
  /// What became of the output, in words.
  [[nodiscard]] static std::string_view words();
  /// 128 + the number of the signal that came, settled or not; 0 without one.
  [[nodiscard]] static int exit_status();
};

/// Percent done, on standard error, when that is a terminal; gone when the work is done.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  void show(double done);

 private:
  bool is_terminal_;
  int shown_percent_ = -1;
};

}  // namespace linkwright::cli
