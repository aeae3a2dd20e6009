#include "approximate/pose_least_squares.hpp"

#include <gtest/gtest.h>

#include "support/random_four_bar.hpp"

namespace linkwright::pose_least_squares_test {
namespace {

constexpr double turning_length = 0.8;

BodyLinkage changed(BodyLinkage l, std::size_t number, double by) {
  const Point x{by, 0}, y{0, by};
  switch (number) {
    case 0:
    case 1:
      l.a0 += number == 0 ? x : y;
      break;
    case 2:
    case 3:
      l.b0 += number == 2 ? x : y;
      break;
    case 4:
      l.a += by;
      break;
    case 5:
      l.b += by;
      break;
    case 6:
    case 7:
      l.za += number == 6 ? x : y;
      break;
    default:
      l.zb += number == 8 ? x : y;
  }
  return l;
}

struct Drawn {
  BodyLinkage linkage;
  BodyPose state, pose;
};

// A linkage where it is nearest to a pose close by.
Drawn drawn(testing::RandomFourBars& draw) {
  const BodyPose there{{draw.uniform(-1, 1), draw.uniform(-1, 1)}, direction(draw.uniform(-3, 3))};
  Drawn d{body_linkage(draw.four_bar(draw.lengths()), there), there, {}};
  const auto small = [&] { return draw.uniform(-1e-3, 1e-3); };
  d.pose = moved(there, {{small(), small()}, small()}, turning_length);
  d.state = nearest_state(d.linkage, d.state, d.pose, turning_length);
  return d;
}

bool is_plain(const Drawn& d) { return BodyHold(d.linkage, d.state, turning_length).second_length > 0.3; }

TEST(PoseLeastSquares, RowsAreTheDerivativeOfTheDistanceToTheMotion) {
  testing::RandomFourBars draw(21);
  int tried = 0;
  while (tried < 100) {
    const Drawn d = drawn(draw);
    if (!is_plain(d)) continue;
    ++tried;
    const auto square_of = [&](const BodyLinkage& linkage) {
      return square(move_between(d.pose, nearest_state(linkage, d.state, d.pose, turning_length), turning_length));
    };
    const auto rows = displacement_rows(d.linkage, d.state, d.pose, turning_length);
    EXPECT_NEAR(rows[0].residual * rows[0].residual + rows[1].residual * rows[1].residual, square_of(d.linkage), 1e-12);
    for (std::size_t i = 0; i < body_dimensions; ++i) {
      constexpr double h = 1e-6;
      const double by = (square_of(changed(d.linkage, i, h)) - square_of(changed(d.linkage, i, -h))) / (2 * h);
      EXPECT_NEAR(2 * (rows[0].residual * rows[0].row[i] + rows[1].residual * rows[1].row[i]), by, 2e-5);
    }
  }
}

TEST(PoseLeastSquares, SineRowIsTheDerivativeOfTheTransmissionAngleSine) {
  testing::RandomFourBars draw(22);
  int tried = 0;
  while (tried < 100) {
    Drawn d = drawn(draw);
    if (!is_plain(d)) continue;
    ++tried;
    d.pose = d.state;  // where curves of states bend, the nearest state moves along them by second-order terms
    const auto sine_of = [&](const BodyLinkage& linkage) {
      return transmission_sine(linkage, nearest_state(linkage, d.state, d.pose, turning_length));
    };
    const BodyRow row = transmission_sine_row(d.linkage, d.state, d.pose, turning_length);
    EXPECT_NEAR(row.residual, sine_of(d.linkage), 1e-12);
    for (std::size_t i = 0; i < body_dimensions; ++i) {
      constexpr double h = 1e-6;
      const double by = (sine_of(changed(d.linkage, i, h)) - sine_of(changed(d.linkage, i, -h))) / (2 * h);
      EXPECT_NEAR(row.row[i], by, 1e-5 * (1 + std::abs(by)));
    }
  }
}

}  // namespace
}  // namespace linkwright::pose_least_squares_test
