#include "linkwright/core/count_text.hpp"

#include <cmath>
#include <fmt/format.h>

namespace linkwright {

std::string grouped_text(std::int64_t count) {
  std::string text = fmt::format("{}", count);
  const std::ptrdiff_t first_digit = count < 0 ? 1 : 0;
  for (auto place = static_cast<std::ptrdiff_t>(text.size()) - 3; place > first_digit; place -= 3) {
    text.insert(static_cast<std::size_t>(place), 1, ' ');
  }
  return text;
}

std::string limit_text(double limit) {
  constexpr double longest = 1e15;
  if (std::abs(limit) < longest && limit == std::round(limit)) return grouped_text(static_cast<std::int64_t>(limit));
  const std::string text = fmt::format("{:g}", limit);
  const std::size_t exponent = text.find("e+");
  return exponent == std::string::npos ? text : text.substr(0, exponent + 1) + text.substr(exponent + 2);
}

}  // namespace linkwright
