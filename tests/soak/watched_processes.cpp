#include "watched_processes.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <ctime>
#include <exception>
#include <fmt/format.h>
#include <poll.h>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace linkwright::soak {
namespace {

using Clock = std::chrono::steady_clock;

struct Running {
  std::size_t number = 0;
  pid_t process = 0;
  int pipe = -1;
  Clock::time_point start;
  std::string said;
  bool is_silent = false;  ///< its end of the pipe is closed
  bool is_over_time = false;
};

void write_all(int pipe, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(pipe, text.data(), text.size());
    if (count < 0 && errno != EINTR) return;
    if (count > 0) text.remove_prefix(static_cast<std::size_t>(count));
  }
}

[[noreturn]] void work_and_leave(std::size_t number, int pipe, const std::function<std::string(std::size_t)>& work) {
  try {
    write_all(pipe, work(number));
    ::_exit(0);
  } catch (const std::exception& error) {
    std::fputs(fmt::format("task {}: {}\n", number, error.what()).c_str(), stderr);
    ::_exit(1);
  }
}

Running started(std::size_t number, const std::function<std::string(std::size_t)>& work) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) throw std::runtime_error("no pipe could be made");
  std::fflush(nullptr);
  const pid_t process = ::fork();
  if (process < 0) throw std::runtime_error("no process could be started");
  if (process == 0) {
    ::close(ends[0]);
    work_and_leave(number, ends[1], work);
  }
  ::close(ends[1]);
  return {number, process, ends[0], Clock::now(), {}, false, false};
}

double processor_seconds(pid_t process) {
  clockid_t clock{};
  timespec used{};
  if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &used) != 0) return 0;
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

void listen(Running& running) {
  std::array<char, 1 << 16> buffer{};
  const ssize_t count = ::read(running.pipe, buffer.data(), buffer.size());
  if (count > 0) running.said.append(buffer.data(), static_cast<std::size_t>(count));
  if (count == 0 || (count < 0 && errno != EINTR)) running.is_silent = true;
}

void end_if_over_time(Running& running, const ProcessLimits& limits) {
  const double waited = std::chrono::duration<double>(Clock::now() - running.start).count();
  if (running.is_over_time ||
      (waited < limits.clock_seconds && processor_seconds(running.process) < limits.processor_seconds))
    return;
  running.is_over_time = true;
  ::kill(running.process, SIGKILL);
}

Ended end_of(Running& running) {
  ::close(running.pipe);
  int status = 0;
  rusage used{};
  while (::wait4(running.process, &status, 0, &used) < 0 && errno == EINTR) {
  }
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  Ended ended{Ended::How::said, std::move(running.said), seconds(used.ru_utime) + seconds(used.ru_stime)};
  if (running.is_over_time) return {Ended::How::over_time, {}, ended.seconds};
  if (WIFSIGNALED(status))
    return {Ended::How::crashed, fmt::format("signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status))),
            ended.seconds};
  if (WEXITSTATUS(status) != 0)
    return {Ended::How::crashed, fmt::format("exit status {}", WEXITSTATUS(status)), ended.seconds};
  return ended;
}

void wait_a_moment(std::vector<Running>& running) {
  constexpr int milliseconds = 20;
  std::vector<pollfd> pipes;
  for (const Running& one : running) pipes.push_back({one.pipe, POLLIN, 0});
  if (::poll(pipes.data(), pipes.size(), milliseconds) <= 0) return;
  for (std::size_t i = 0; i < running.size(); ++i)
    if (pipes[i].revents != 0) listen(running[i]);
}

}  // namespace

void run_apart(const std::vector<std::size_t>& numbers, const ProcessLimits& limits,
               const std::function<std::string(std::size_t)>& work,
               const std::function<void(std::size_t, const Ended&)>& tell) {
  std::vector<Running> running;
  auto next = numbers.begin();
  while (next != numbers.end() || !running.empty()) {
    while (next != numbers.end() && static_cast<int>(running.size()) < limits.at_once)
      running.push_back(started(*next++, work));
    wait_a_moment(running);
    for (Running& one : running) {
      if (!one.is_silent) end_if_over_time(one, limits);
      if (one.is_silent) tell(one.number, end_of(one));
    }
    std::erase_if(running, [](const Running& one) { return one.is_silent; });
  }
}

}  // namespace linkwright::soak
