#include "linkwright/straight_line/straight_line_task.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <string>

#include "linkwright/core/angle.hpp"
#include "linkwright/infinitesimal/line_contact.hpp"
#include "straight_line/line_cases.hpp"
#include "support/draws.hpp"
#include "support/short_contact.hpp"
#include "support/straight_line_cases.hpp"

namespace linkwright {
namespace {

using namespace straight_cases;

double number(const nlohmann::json& value) {
  return value.is_string() ? std::stod(value.get<std::string>()) : value.get<double>();
}
Point point_of(const nlohmann::json& pair) { return {number(pair[0]), number(pair[1])}; }

struct Place {
  StraightLineTask task;
  double first = 0, second = 0;
};

// A file of data/straight_line as a task, and the place that it is about.
std::optional<Place> place_of(const std::string& file, const nlohmann::json& in) {
  const auto angle = [&](const char* key) { return radians(number(in[key])); };
  const auto length = [&](const char* key) { return number(in[key]); };
  Place place;
  if (!in.contains("line_direction_deg")) return std::nullopt;
  place.task.line = LineAtAngle(point_of(in.contains("C") ? in["C"] : in["line_point"]), angle("line_direction_deg"));
  if (file.starts_with("c92")) {
    place.task.given = FourPointCubic{length("c"), angle("psiC_deg"), length("N")};
    place.first = angle("psiA_deg"), place.second = angle("psiB_deg");
  } else if (file.starts_with("p92")) {
    place.task.given = FourPointPivots{point_of(in["A0"]), point_of(in["B0"])};
    place.first = angle("thetaA_deg"), place.second = angle("thetaB_deg");
  } else if (file.starts_with("c93")) {
    place.task.given = BallPointOnSideLink{point_of(in["A0"])};
    place.first = length("hP"), place.second = length("hB0");
  } else if (file.starts_with("c94")) {
    place.task.given = IsoscelesTrapezoid{length("f")};
    place.first = length("h"), place.second = length("p");
  } else if (file.starts_with("c95")) {
    place.task.given = PoleAtGivenPivot{point_of(in["A0"]), point_of(in["B0"]), length("rB")};
  } else if (file.starts_with("c96")) {
    place.task.given = PoleAtFixedPivotBallPointOnFrame{length("c")};
    place.first = length("r0A"), place.second = length("rB");
  } else if (file.starts_with("c101")) {
    place.task.given = FivePoint{length("c"), angle("psiC_deg")};
    place.first = angle("psiA_deg"), place.second = angle("psiB_deg");
  } else if (file.starts_with("c102")) {
    place.task.given = FivePointInflectionPole{length("c")};
    place.first = angle("psiA_deg"), place.second = angle("psiB_deg");
  } else if (file.starts_with("c103")) {
    place.task.given = FivePointSideLinkOnFrame{length("c")};
    place.first = angle("psiC_deg"), place.second = angle("psiA_deg");
  } else if (file.starts_with("six")) {
    place.task.given = SixPoint{length("c")};
    place.first = angle("psiC_deg"), place.second = angle("psiA_deg");
  } else if (file.starts_with("watt")) {
    place.task.given = ParallelSideLinks{length("xA"), length("xB")};
    place.first = length("rhoA"), place.second = length("rhoB");
  } else {
    return std::nullopt;
  }
  return place;
}

LineDesigns found_at(const StraightLineTask& task, double first, double second) {
  const auto axes = axes_of(task);
  return designs_at(task, line_axis_value(axes[0], first), line_axis_value(axes[1], second));
}

// Largest distance of the five points; the grounded links may be named either way.
double distance(const TracingFourBar& a, const TracingFourBar& b) {
  const auto apart = [](const TracingFourBar& one, const TracingFourBar& other) {
    return std::max({std::abs(one.point - other.point), std::abs(one.bars.input_fixed - other.bars.input_fixed),
                     std::abs(one.bars.input_moving - other.bars.input_moving),
                     std::abs(one.bars.output_fixed - other.bars.output_fixed),
                     std::abs(one.bars.output_moving - other.bars.output_moving)});
  };
  return std::min(apart(a, b), apart(a, b.swapped()));
}

TEST(LineCases, AgreeWithThirtyDigits) {
  std::map<std::string, int> listed;
  for (const auto& file : testing::straight_line_files()) {
    const auto place = place_of(file.name, file.json["inputs"]);
    if (!place) continue;
    const LineDesigns found = found_at(place->task, place->first, place->second);
    const std::vector<Error> mistakes = mistakes_in(place->task);
    EXPECT_TRUE(mistakes.empty()) << file.name << " " << (mistakes.empty() ? "" : mistakes[0].message);
    for (const LineDesign& design : found) {
      EXPECT_TRUE(design.kind == DesignKind::none || !file.solutions.empty()) << file.name;
    }
    for (const testing::StraightLineCase& wanted : file.solutions) {
      double nearest = 1e9;
      const TracingFourBar exact{wanted.four_bar, wanted.point};
      for (const LineDesign& design : found)
        if (design.kind == DesignKind::four_bar) nearest = std::min(nearest, distance(design.linkage, exact));
      EXPECT_LT(nearest, 1e-9 * exact.longest()) << file.name;
      ++listed[file.name.substr(0, 3)];
    }
  }
  EXPECT_EQ(listed.size(), 9u);
}

std::vector<StraightLineTask> tasks_of_every_case(std::mt19937& draw) {
  std::uniform_real_distribution<double> number(-3, 3), length(0.2, 3), ray(0.1, 1.4);
  const LineAtAngle line({number(draw), number(draw)}, number(draw));
  const Point a{number(draw), number(draw)}, b{number(draw), number(draw)};
  const double c = number(draw) > 0 ? length(draw) : -length(draw);
  return {{line, FourPointPivots{a, b}},
          {line, FourPointCubic{c, ray(draw), number(draw)}},
          {line, FourPointCubic{c, -ray(draw), std::nullopt}},
          {line, BallPointOnSideLink{a}},
          {line, IsoscelesTrapezoid{length(draw)}},
          {line, PoleAtGivenPivot{a, b, number(draw)}},
          {line, PoleAtFixedPivot{c, number(draw)}},
          {line, PoleAtFixedPivotBallPointOnFrame{c}},
          {line, FivePoint{c, ray(draw)}},
          {line, FivePointInflectionPole{c}},
          {line, FivePointSideLinkOnFrame{c}},
          {line, SixPoint{c}},
          {line, ParallelSideLinks{number(draw), number(draw)}}};
}

// Every linkage of every case, by the referee: its point lies on the line and meets it as often as the case promises.
TEST(LineCases, KeepTheContactThatTheyPromise) {
  std::mt19937 draw(14);
  std::uniform_real_distribution<double> along(0, 1);
  std::map<std::string, std::array<int, 2>> counts;  // looked at, short of the promise
  for (int turn = 0; turn < 40; ++turn)
    for (const StraightLineTask& task : tasks_of_every_case(draw)) {
      const auto axes = axes_of(task);
      for (int cell = 0; cell < testing::draws(500); ++cell) {
        const auto place = [&](const LineAxis& axis) { return axis.low + along(draw) * (axis.high - axis.low); };
        const LineDesigns found = found_at(task, place(axes[0]), place(axes[1]));
        for (int layer = 0; layer < 3; ++layer) {
          const LineDesign& design = found[static_cast<std::size_t>(layer)];
          EXPECT_TRUE(layer < layers_of(task.given) || design.kind == DesignKind::none);
          if (design.kind != DesignKind::four_bar) continue;
          const TracingFourBar& linkage = design.linkage;
          EXPECT_LT(std::abs(task.line.to_line(linkage.point).imag()), 1e-9 * linkage.longest());
          // As requirements do by default: rounding shows in the contact with a high power of the ratio of the links.
          if (linkage.longest() > 20 * linkage.shortest()) continue;
          const auto loop = loop_series(linkage.bars);
          if (!loop) continue;
          const auto contact =
              contact_with_line(coupler_motion(linkage.bars, *loop), linkage.point, task.line.direction);
          auto& [seen, low] = counts[std::string(name(task.given))];
          ++seen;
          if (testing::falls_short(contact, promised_contact(task.given), linkage.longest())) ++low;
        }
      }
    }
  EXPECT_EQ(counts.size(), 11u);
  int all = 0;
  for (const auto& [of, count] : counts) {
    EXPECT_EQ(count[1], 0) << of << ": " << count[1] << " of " << count[0];
    EXPECT_GT(count[0], testing::draws(1000)) << of;
    all += count[0];
  }
  EXPECT_GE(all, testing::draws(100'000));
}

}  // namespace
}  // namespace linkwright
