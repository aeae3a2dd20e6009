#include "console.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <sys/time.h>
#include <unistd.h>

#include "linkwright/files/text_file.hpp"

namespace linkwright::cli {
namespace {

// What the handlers of signals read and write.
std::atomic<bool> interrupted{false}, stops_when_asked{false}, has_written{false}, has_temporary{false};
std::atomic<int> interrupting_signal{0};
std::atomic<const char*> own_words{nullptr};
std::array<char, 4096> temporary_file{};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

/// How long work may take to stop when it is asked to, microseconds.
constexpr int patience = 400'000;

std::string_view stopped_words() {
  if (const char* words = own_words) return words;
  return has_written ? "stopped before all was written" : "stopped; nothing was written";
}

/// Nothing but system calls.
[[noreturn]] void leave_at_once(int signal_number) {
  if (has_temporary) ::unlink(temporary_file.data());
  for (const std::string_view words : {std::string_view("linkwright: "), stopped_words(), std::string_view("\n")})
    if (::write(STDERR_FILENO, words.data(), words.size()) < 0) break;
  ::_exit(128 + signal_number);
}

/// Rings once after so many microseconds; 0: not at all.
void set_alarm(int microseconds) {
  itimerval alarm{};
  alarm.it_value.tv_usec = microseconds;
  ::setitimer(ITIMER_REAL, &alarm, nullptr);
}

extern "C" void on_interruption(int signal_number) {
  if (!stops_when_asked || interrupting_signal != 0) leave_at_once(signal_number);
  interrupting_signal = signal_number;
  interrupted = true;
  set_alarm(patience);
}

extern "C" void on_alarm(int /*signal_number*/) { leave_at_once(interrupting_signal); }

/// Remembers a temporary file as long as it lives, for leave_at_once().
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& path) {
    const std::string name = path.string();
    if (name.empty() || name.size() >= temporary_file.size()) return;
    std::copy(name.c_str(), name.c_str() + name.size() + 1, temporary_file.begin());
    has_temporary = true;
  }
  ~TemporaryFile() { has_temporary = false; }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
};

/// Text to standard output; what failed stays failed.
class StandardOutput {
 public:
  void write(std::string_view text) {
    if (!text.empty()) has_written = true;
    if (failed_with_ == 0 && std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) failed_with_ = errno;
  }
  [[nodiscard]] bool finish() {
    if (failed_with_ == 0 && std::fflush(stdout) != 0) failed_with_ = errno;
    if (failed_with_ == 0) return true;
    print_failure(fmt::format("standard output cannot be written: {}", std::strerror(failed_with_)));
    return false;
  }

 private:
  int failed_with_ = 0;
};

}  // namespace

void print_mistakes(std::string_view file, const std::vector<Error>& mistakes) {
  for (const Error& mistake : mistakes) {
    const std::string line = mistake.place.empty() ? fmt::format("{}: {}\n", file, mistake.message)
                                                   : fmt::format("{}: {}: {}\n", file, mistake.place, mistake.message);
    std::fputs(line.c_str(), stderr);
  }
}

void print_failure(std::string_view message) { std::fputs(fmt::format("linkwright: {}\n", message).c_str(), stderr); }

bool print_answer(std::string_view text) {
  StandardOutput output;
  output.write(text);
  return output.finish();
}

bool write_output(const std::filesystem::path& path, const std::function<void(const TextSink&)>& writer) {
  if (path == "-") {
    StandardOutput output;
    writer([&output](std::string_view text) { output.write(text); });
    return output.finish();
  }
  AtomicFile file(path);
  const TemporaryFile temporary(file.temporary());
  writer([&file](std::string_view text) {
    if (!Interruption::happened()) file.write(text);
  });
  if (Interruption::happened()) return false;
  const auto failure = file.commit();
  if (failure) print_mistakes(path.string(), {*failure});
  if (!failure) has_written = true;
  return !failure;
}

Interruption::Interruption(Answer answer) {
  stops_when_asked = answer == Answer::when_asked;
  std::signal(SIGALRM, on_alarm);
  std::signal(SIGINT, on_interruption);
  std::signal(SIGTERM, on_interruption);
}

bool Interruption::happened() { return interrupted; }
const std::atomic<bool>* Interruption::flag() { return &interrupted; }
void Interruption::settle() {
  set_alarm(0);
  interrupted = false;
}
void Interruption::set_words(const char* words) { own_words = words; }
std::string_view Interruption::words() { return stopped_words(); }
int Interruption::exit_status() { return interrupting_signal == 0 ? 0 : 128 + interrupting_signal; }

ProgressLine::ProgressLine() : is_terminal_(::isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (shown_percent_ >= 0) std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(double done) {
  const int percent = static_cast<int>(100 * done);
  if (!is_terminal_ || percent == shown_percent_) return;
  shown_percent_ = percent;
  std::fputs(fmt::format("\rsolving … {} %\033[K", percent).c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace linkwright::cli
