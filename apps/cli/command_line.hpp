#pragma once

#include <functional>
#include <optional>

namespace CLI {
class App;
}

namespace linkwright::cli {

/// Reads the command line. The exit status where that is all: help was asked for, or one line says what is wrong.
[[nodiscard]] std::optional<int> parse(CLI::App& app, int argc, char** argv);

/// What `run` returns, or the failure that it threw, told on standard error.
[[nodiscard]] int guarded(const std::function<int()>& run);

}  // namespace linkwright::cli
