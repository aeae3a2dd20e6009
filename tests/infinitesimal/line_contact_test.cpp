#include "linkwright/infinitesimal/line_contact.hpp"

#include <gtest/gtest.h>

#include "support/straight_line_cases.hpp"

namespace linkwright::line_contact_test {
namespace {

LineContact contact_of(const FourBar& bars, Point point, Point direction) {
  return contact_with_line(coupler_motion(bars, *loop_series(bars)), point, direction);
}

TEST(LineContact, IsThatOfTheCases) {
  for (const auto& known : testing::straight_line_cases()) {
    SCOPED_TRACE(known.name);
    if (!loop_series(known.four_bar)) continue;  // at a change point
    const LineContact found = contact_of(known.four_bar, known.point, known.direction);
    EXPECT_EQ(found.points, known.contact_points);
    double largest = 0;
    for (const auto& [key, value] : known.json.at("e_of_s_coefficients").items())
      largest = std::max(largest, std::pow(std::abs(value.get<double>()), 1.0 / (std::stoi(key) - 1)));
    for (const auto& [key, value] : known.json.at("e_of_s_coefficients").items()) {
      const int k = std::stoi(key);
      EXPECT_NEAR(found.deviation[static_cast<std::size_t>(k)] / std::pow(largest, k - 1),
                  value.get<double>() / std::pow(largest, k - 1), 1e-9)
          << k;
    }
  }
}

TEST(LineContact, WattsPointDeviatesByTheFifthPower) {
  const FourBar watt{{-2, -0.5}, {0, -0.5}, {2, 0.5}, {0, 0.5}};
  const LineContact found = contact_of(watt, 0, {0, 1});
  EXPECT_EQ(found.points, 5);
  EXPECT_NEAR(found.deviation[5], 1.0 / 32, 1e-14);  // 1 / (8 a³ c)
}

TEST(LineContact, OtherLinesCrossThePathOnce) {
  const FourBar watt{{-2, -0.5}, {0, -0.5}, {2, 0.5}, {0, 0.5}};
  EXPECT_EQ(contact_of(watt, 0, {1, 0}).points, 1);
  EXPECT_EQ(contact_of(watt, 0, std::polar(1.0, 1.0)).points, 1);
}

TEST(LineContact, IsCountedNextToACusp) {
  const FourBar bars{
      {0, 0}, {3.7502345521529015, 9.052354397052609}, {-2.5, 4.5}, {1.1949251112630135, 9.154820081494467}};
  EXPECT_EQ(contact_of(bars, {6.628524572562647, 16}, {1, 0}).points, 4) << "the pole is 2e-7 away";
}

TEST(LineContact, APointAtRestHasNone) {
  const FourBar bars{{0, 0}, {1, 1}, {4, 0}, {3, 1}};  // the pole lies at (2, 2)
  EXPECT_EQ(contact_of(bars, {2, 2}, {1, 0}).points, 0);
}

}  // namespace
}  // namespace linkwright::line_contact_test
