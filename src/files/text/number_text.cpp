#include "linkwright/files/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "linkwright/core/angle.hpp"

namespace linkwright {

std::string exact_text(double value) {
  if (value == 0) return std::signbit(value) ? "-0.0" : "0";
  return fmt::format("{}", value);
}

std::string rounded_text(double value, int decimals) {
  if (std::abs(value) >= 1e15) return fmt::format("{:.6g}", value);
  const std::string text = fmt::format("{:.{}f}", value, std::clamp(decimals, 0, 15));
  const bool is_zero = text.find_first_not_of("-0.") == std::string::npos;
  return is_zero && text.front() == '-' ? text.substr(1) : text;
}

std::string significant_text(double value, int digits) {
  const double size = std::abs(value);
  if (!(size >= 1e-5 && size < 1e15)) return fmt::format("{:.{}g}", value, digits);
  const int decimals = digits - 1 - static_cast<int>(std::floor(std::log10(size)));
  std::string text = rounded_text(value, std::max(decimals, 0));
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string significant_text(double value, int digits, double size) {
  constexpr double rounding = 1e-12;
  return significant_text(std::abs(value) <= rounding * size ? 0 : value, digits);
}

int length_decimals(double typical_length) {
  if (!(typical_length > 0) || !std::isfinite(typical_length)) return 2;
  return std::clamp(4 - static_cast<int>(std::floor(std::log10(typical_length))), 0, 15);
}

double degrees_for_files(double angle) {
  const double nearest = degrees(angle);
  if (nearest == 0 || !std::isfinite(nearest)) return nearest;
  constexpr int ulps = 4;  // radians() and degrees() round four times together
  double candidate = nearest;
  for (int i = 0; i < ulps; ++i) candidate = std::nextafter(candidate, -std::numeric_limits<double>::infinity());
  double best = nearest;
  auto best_size = std::numeric_limits<std::size_t>::max();
  for (int i = -ulps; i <= ulps; ++i) {
    const std::size_t size = exact_text(candidate).size();
    if (radians(candidate) == angle && size < best_size) {
      best = candidate;
      best_size = size;
    }
    candidate = std::nextafter(candidate, std::numeric_limits<double>::infinity());
  }
  return best;
}

}  // namespace linkwright
