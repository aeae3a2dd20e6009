#include "console.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <unistd.h>

#include "linkwright/io/atomic_file.hpp"

namespace linkwright::cli {
namespace {

std::atomic<bool> interrupted{false};
std::atomic<int> interrupting_signal{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

extern "C" void on_interruption(int signal_number) {
  interrupting_signal = signal_number;
  interrupted = true;
  std::signal(signal_number, SIG_DFL);
}

/// Text to standard output; what failed stays failed.
class StandardOutput {
 public:
  void write(std::string_view text) {
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
  writer([&file](std::string_view text) {
    if (!Interruption::happened()) file.write(text);
  });
  if (Interruption::happened()) return false;
  const auto failure = file.commit();
  if (failure) print_mistakes(path.string(), {*failure});
  return !failure;
}

Interruption::Interruption() {
  std::signal(SIGINT, on_interruption);
  std::signal(SIGTERM, on_interruption);
}

bool Interruption::happened() { return interrupted; }
const std::atomic<bool>* Interruption::flag() { return &interrupted; }
void Interruption::settle() { interrupted = false; }
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
