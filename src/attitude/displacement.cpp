#include "linkwright/attitude/displacement.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace linkwright {
namespace {

constexpr std::array<double, 4> point_row{0, 0, 0, 1};

bool is_point_row(const std::array<double, 4>& row, double largest_error) {
  return std::equal(row.begin(), row.end(), point_row.begin(),
                    [=](double a, double b) { return std::fabs(a - b) <= largest_error; });
}

}  // namespace

Result<Displacement> Displacement::from_matrix(const Matrix4x4& t, double largest_error) {
  for (const auto& row : t)
    if (!std::all_of(row.begin(), row.end(), [](double element) { return std::isfinite(element); }))
      return Error{"not_finite", "matrix", "an element is not a number or infinite: give sixteen finite numbers"};
  if (!is_point_row(t[3], largest_error))
    return Error{"last_row",
                 "matrix",
                 fmt::format("not a displacement: the last row is [{:.9g}, {:.9g}, {:.9g}, {:.9g}] instead of "
                             "[0, 0, 0, 1]; divide by the last element, or transpose a matrix of rows that are columns",
                             t[3][0], t[3][1], t[3][2], t[3][3]),
                 {{"a", t[3][0]}, {"b", t[3][1]}, {"c", t[3][2]}, {"d", t[3][3]}}};
  const Matrix3x3 c{{{{t[0][0], t[0][1], t[0][2]}, {t[1][0], t[1][1], t[1][2]}, {t[2][0], t[2][1], t[2][2]}}}};
  const Result<Rotation> rotation = Rotation::from_matrix(c, largest_error);
  if (!rotation) return rotation.errors();
  return Displacement{*rotation, {t[0][3], t[1][3], t[2][3]}};
}

Matrix4x4 Displacement::matrix() const {
  const Matrix3x3& c = rotation.matrix();
  const Vector3 d = translation;
  return {{{c(0, 0), c(0, 1), c(0, 2), d.x},
           {c(1, 0), c(1, 1), c(1, 2), d.y},
           {c(2, 0), c(2, 1), c(2, 2), d.z},
           point_row}};
}

}  // namespace linkwright
