#include "mistakes.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace linkwright {

void Mistakes::add(Error error) {
  const auto is_told = [&](const Error& known) { return known.place == error.place && known.message == error.message; };
  if (std::any_of(errors_.begin(), errors_.end(), is_told)) return;
  if (errors_.size() < max_listed) {
    errors_.push_back(std::move(error));
  } else {
    ++unlisted_;
  }
}

void Mistakes::add(std::string code, std::string place, std::string message, Values values) {
  add(Error{std::move(code), std::move(place), std::move(message), std::move(values)});
}

void Mistakes::add(const std::vector<Error>& errors) {
  for (const Error& error : errors) add(error);
}

void Mistakes::add_new(const std::vector<Error>& errors) {
  for (const Error& error : errors)
    if (std::none_of(errors_.begin(), errors_.end(),
                     [&](const Error& known) { return known.code == error.code && known.place == error.place; }))
      add(error);
}

std::vector<Error> Mistakes::take() {
  if (unlisted_ > 0) {
    errors_.push_back({"more_mistakes",
                       "",
                       fmt::format("{} more {} not listed", unlisted_, unlisted_ == 1 ? "mistake is" : "mistakes are"),
                       {{"count", unlisted_}}});
  }
  unlisted_ = 0;
  return std::move(errors_);
}

}  // namespace linkwright
