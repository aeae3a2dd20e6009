#include "turned_arm.hpp"

#include "algebra/binary_form.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {

std::vector<Point> turned_arm(Point arm, double angle, std::span<const double> rates) {
  std::vector<Point> v = {direction(angle) * arm};
  for (std::size_t m = 0; m < rates.size(); ++m) {
    Point sum = 0;
    for (std::size_t k = 0; k <= m; ++k) sum += binomial[m][k] * rates[k] * v[m - k];
    v.push_back(Point{0, 1} * sum);
  }
  return v;
}

// w^(m+1) = i Σ C(m, k) θ^(k+1) w^(m−k), solved for the highest derivative of θ.
std::vector<double> turn_rates(const std::vector<Point>& arm) {
  std::vector<double> theta;
  for (std::size_t m = 0; m + 1 < arm.size(); ++m) {
    Point rest = arm[m + 1];
    for (std::size_t k = 0; k < m; ++k) rest -= Point{0, 1} * (binomial[m][k] * theta[k]) * arm[m - k];
    theta.push_back(std::norm(arm[0]) > 0 ? cross(arm[0], rest) / std::norm(arm[0]) : 0);
  }
  return theta;
}

}  // namespace linkwright
