#include "in_child.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace linkwright {
namespace {

/// Beyond it SIGXCPU ends this process.
void compute_at_most(std::chrono::seconds longest) {
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  rlimit limit{};
  if (::getrlimit(RLIMIT_CPU, &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_cur, static_cast<rlim_t>(longest.count()));
  ::setrlimit(RLIMIT_CPU, &limit);
}

[[noreturn]] void do_and_leave(std::chrono::seconds longest, const std::function<int()>& work, pid_t parent) {
  std::signal(SIGXCPU, SIG_DFL);
  compute_at_most(longest);
  std::signal(SIGINT, SIG_DFL);  // the parent tells
  std::signal(SIGTERM, SIG_DFL);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  int status = 1;
  try {
    status = work();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "linkwright: %s\n", error.what());
  }
  std::fflush(nullptr);
  ::_exit(status);
}

}  // namespace

bool ChildEnd::crashed() const {
  constexpr std::array crashes = {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGXCPU};
  return std::find(crashes.begin(), crashes.end(), signal) != crashes.end();
}

ChildEnd in_child(std::chrono::seconds longest, const std::function<int()>& work) {
  std::fflush(nullptr);
  const pid_t parent = ::getpid(), child = ::fork();
  if (child < 0) return {};
  if (child == 0) do_and_leave(longest, work, parent);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return {};
  if (WIFEXITED(status)) return {WEXITSTATUS(status), 0};
  return {std::nullopt, WTERMSIG(status)};
}

}  // namespace linkwright
