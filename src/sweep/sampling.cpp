#include "linkwright/sweep/sampling.hpp"

#include <array>
#include <boost/random/sobol.hpp>
#include <cmath>

#include "linkwright/core/precondition.hpp"

namespace linkwright {
namespace {

constexpr double two_to_minus_53 = 0x1p-53;

constexpr std::array<std::uint64_t, max_coordinates> first_primes() {
  std::array<std::uint64_t, max_coordinates> primes{};
  std::size_t found = 0;
  for (std::uint64_t candidate = 2; found < primes.size(); ++candidate) {
    bool is_prime = true;
    for (std::size_t i = 0; i < found && is_prime; ++i) is_prime = candidate % primes[i] != 0;
    if (is_prime) primes[found++] = candidate;
  }
  return primes;
}
constexpr auto primes = first_primes();

constexpr std::uint64_t mixed(std::uint64_t bits) {
  bits += 0x9e3779b97f4a7c15;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
  return bits ^ (bits >> 31);
}

// The upper 53 bits: never rounded up to 1.
double unit_number(std::uint64_t bits) { return static_cast<double>(bits >> 11) * two_to_minus_53; }

// The engine leaves out the origin, its own number 0 being the point after it.
std::vector<double> sobol_point(std::uint64_t index, std::size_t dimensions) {
  std::vector<double> point(dimensions, 0.0);
  if (index == 0) return point;
  boost::random::sobol engine(dimensions);
  engine.seed(index - 1);
  for (double& coordinate : point) coordinate = unit_number(engine());
  return point;
}

}  // namespace

std::string_view name(Sampling sampling) {
  constexpr std::array<std::string_view, 5> names = {"grid", "list", "sobol", "halton", "random"};
  return names[static_cast<std::size_t>(sampling)];
}

double halton_coordinate(std::uint64_t index, std::size_t dimension) {
  const std::uint64_t base = primes[dimension];
  double inverse = 0, place = 1;
  for (; index > 0; index /= base) {
    place /= static_cast<double>(base);
    inverse += place * static_cast<double>(index % base);
  }
  return std::min(inverse, 1 - two_to_minus_53);
}

double random_coordinate(std::uint64_t seed, std::uint64_t index, std::size_t dimension) {
  return unit_number(mixed(mixed(mixed(seed) ^ index) ^ dimension));
}

PointSequence::PointSequence(Sampling method, std::size_t dimensions, std::uint64_t seed)
    : method_(method), dimensions_(dimensions), seed_(seed) {
  require(dimensions <= max_coordinates, "a sequence has as many coordinates as its tables");
}

void PointSequence::move_by_seed(std::vector<double>& point) const {
  if (seed_ == 0) return;
  for (std::size_t k = 0; k < point.size(); ++k) {
    point[k] += random_coordinate(seed_, 0, k);
    if (point[k] >= 1) point[k] -= 1;
  }
}

std::vector<double> PointSequence::point(std::uint64_t index) const {
  std::vector<double> point(dimensions_);
  if (dimensions_ == 0) return point;
  switch (method_) {
    case Sampling::sobol:
      point = sobol_point(index, dimensions_);
      move_by_seed(point);
      break;
    case Sampling::halton:
      for (std::size_t k = 0; k < dimensions_; ++k) point[k] = halton_coordinate(index, k);
      move_by_seed(point);
      break;
    default:
      for (std::size_t k = 0; k < dimensions_; ++k) point[k] = random_coordinate(seed_, index, k);
  }
  return point;
}

}  // namespace linkwright
