#include "linkwright/straight_line/straight_path.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "support/straight_line_cases.hpp"

namespace linkwright::straight_path_test {
namespace {

TEST(StraightPath, IsThatOfTheCases) {
  for (const auto& known : testing::straight_line_cases()) {
    SCOPED_TRACE(known.name);
    if (!known.json.contains("usable")) continue;
    const auto& usable = known.json.at("usable");
    const auto path = StraightPath::of({known.four_bar, known.point}, known.direction);
    ASSERT_TRUE(path);
    const double size = known.four_bar.lengths().longest();
    const UsableLine line = path->usable(usable.at("delta"));
    EXPECT_NEAR(line.from, usable.at("s_minus"), 1e-7 * size);
    EXPECT_NEAR(line.to, usable.at("s_plus"), 1e-7 * size);
    EXPECT_EQ(name(line.begin), usable.at("end_minus") == "dev" ? "deviation" : usable.at("end_minus"));
    EXPECT_EQ(name(line.end), usable.at("end_plus") == "dev" ? "deviation" : usable.at("end_plus"));
    const auto& strip = known.json.at("usable_strip");
    const UsableLine widest = path->usable_strip(strip.at("two_delta").get<double>() / 2);
    EXPECT_NEAR(widest.length(), strip.at("length"), 5e-3 * widest.length());
    if (!known.json.contains("stroke") || known.json.at("stroke").is_null()) continue;
    const auto& stroke = known.json.at("stroke");
    if (!stroke.contains("S")) continue;
    const double half = stroke.at("S").get<double>() / 2;
    const auto report = path->stroke(-half, half);
    ASSERT_TRUE(report);
    EXPECT_NEAR(report->max_deviation, stroke.at("dev"), 1e-8 * size);
    EXPECT_NEAR(report->parallel_line_deviation, stroke.at("width").get<double>() / 2, 1e-8 * size);
    EXPECT_NEAR(report->best_line_deviation, stroke.at("best_line_width").get<double>() / 2, 1e-8 * size);
    EXPECT_NEAR(degrees(report->min_transmission_angle), stroke.at("min_transmission_deg"), 1e-6);
    ASSERT_EQ(report->drive.has_value(), !stroke.at("vel_nonuniformity").is_null());
    if (!report->drive) continue;
    const double a = std::abs(stroke.at("vel_min").get<double>()), b = std::abs(stroke.at("vel_max").get<double>());
    EXPECT_NEAR(std::abs(degrees(report->drive->sweep)), stroke.at("drive_range_deg"), 1e-6);
    EXPECT_NEAR(report->drive->slowest, std::min(a, b), 1e-6 * b);
    EXPECT_NEAR(report->drive->fastest, std::max(a, b), 1e-6 * b);
  }
}

}  // namespace
}  // namespace linkwright::straight_path_test
