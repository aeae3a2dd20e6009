// What a result file says of tolerances, from its own pivots by a second way: linkages made with errors of the standard
// library's generators, assembled by the triangle of coupler, output and diagonal.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/result_file.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "support/file_support.hpp"

namespace linkwright::tolerance_law_test {
namespace {

using nlohmann::json;

constexpr double half = 0.05, driver = 0.02;  // of all lengths; degrees
constexpr int samples = 20'000;

/// As a workshop sees it.
struct Made {
  double input = 0, coupler = 0, output = 0;
  Point input_fixed, output_fixed, arm;
  double side = 1;
};
struct Place {
  Point point;
  double coupler_angle = 0, output_angle = 0;
};

Point unit(double angle) { return {std::cos(angle), std::sin(angle)}; }
Point point_of(const json& value) { return {value[0].get<double>(), value[1].get<double>()}; }

Made made_of(Point a0, Point a, Point b, Point b0, Point point) {
  const Point coupler = b - a, output = b - b0;
  return {std::abs(a - a0),
          std::abs(coupler),
          std::abs(output),
          a0,
          b0,
          (point - a) / (coupler / std::abs(coupler)),
          coupler.real() * output.imag() - coupler.imag() * output.real() < 0 ? -1.0 : 1.0};
}

std::optional<Place> assembled(const Made& made, double input_angle) {
  const Point a = made.input_fixed + made.input * unit(input_angle), diagonal = made.output_fixed - a;
  const double d = std::abs(diagonal);
  const double cosine = (d * d + made.coupler * made.coupler - made.output * made.output) / (2 * d * made.coupler);
  if (std::abs(cosine) > 1) return std::nullopt;
  // The output lies to the other side of the diagonal's.
  for (const double side : {1.0, -1.0}) {
    const Point along = diagonal / d * unit(side * std::acos(cosine)), b = a + made.coupler * along;
    const Point output = b - made.output_fixed;
    if ((along.real() * output.imag() - along.imag() * output.real() < 0 ? -1.0 : 1.0) != made.side) continue;
    return Place{a + made.arm * along, std::arg(along), std::arg(output)};
  }
  return std::nullopt;
}

class Workshop {
 public:
  Made one(const Made& nominal) {
    Made made = nominal;
    for (double* length : {&made.input, &made.coupler, &made.output}) *length += length_(random_);
    for (Point* point : {&made.input_fixed, &made.output_fixed, &made.arm})
      *point += Point{length_(random_), length_(random_)};
    driver_ = radians(driver) / 3 * normal_(random_);
    return made;
  }
  [[nodiscard]] double driver_error() const { return driver_; }

 private:
  std::mt19937_64 random_{20261123};
  std::normal_distribution<double> normal_, length_{0, half / 3};
  double driver_ = 0;
};

/// Mean square of `square_error(j, there, nominal)` in each position.
template <class Square>
std::vector<double> mean_squares(const Made& nominal, const std::vector<double>& angles, const Square& square_error) {
  std::vector<double> squares(angles.size());
  Workshop workshop;
  for (int k = 0; k < samples; ++k) {
    const Made made = workshop.one(nominal);
    for (std::size_t j = 0; j < angles.size(); ++j) {
      const auto there = assembled(made, angles[j] + workshop.driver_error()), should = assembled(nominal, angles[j]);
      if (!there || !should) throw std::runtime_error("does not assemble");
      squares[j] += square_error(*there, *should) / samples;
    }
  }
  return squares;
}

double root_mean(const std::vector<double>& squares) {
  double sum = 0;
  for (const double square : squares) sum += square;
  return std::sqrt(sum / static_cast<double>(squares.size()));
}

/// The result as a file has it, and the task that it is of.
struct Told {
  explicit Told(const std::string& example, int region_samples = 80)
      : problem(testing::example(example, region_samples)) {
    problem.options.best = 3;
    problem.options.tolerances = Tolerances{.length = LengthTolerances::all(half), .driver = radians(driver)};
    const Answer answer = solve(problem).value();
    result = json::parse(write_result(problem, answer, false));
    EXPECT_FALSE(result["linkages"].empty());
  }
  Problem problem;
  json result;
};

Made four_bar(const json& linkage, Point point) {
  const json &input = linkage["input"], &output = linkage["output"];
  return made_of(point_of(input["center_point"]), point_of(input["circle_point"]), point_of(output["circle_point"]),
                 point_of(output["center_point"]), point);
}

constexpr double luck = 0.03;  // five deviations of both samples

void expect_error(const json& told, double error) {
  EXPECT_NEAR(told["error_sampled"].get<double>() / error, 1, luck);
  EXPECT_NEAR(told["error"].get<double>() / error, 1, 2 * luck);
}

TEST(ToleranceLaw, OfMotions) {
  const Told told("tailgate.json");
  const auto& poses = std::get<MotionTask>(told.problem.task).poses;
  const double turning = told.result["problem"]["tolerances"]["turning_length"];
  for (const json& linkage : told.result["linkages"]) {
    const Made nominal = four_bar(linkage, poses[0].pose.origin);
    const Point circle = point_of(linkage["input"]["circle_point"]);
    std::vector<double> angles;
    for (const auto& there : poses) {
      const Point moved =
          there.pose.origin + unit(there.pose.angle - poses[0].pose.angle) * (circle - poses[0].pose.origin);
      angles.push_back(std::arg(moved - nominal.input_fixed));
    }
    const auto squares = mean_squares(nominal, angles, [&](const Place& there, const Place& should) {
      const double turn = turning * std::remainder(there.coupler_angle - should.coupler_angle, 2 * pi);
      return std::norm(there.point - should.point) + turn * turn;
    });
    expect_error(linkage["tolerance"], root_mean(squares));
  }
}

TEST(ToleranceLaw, OfFunctions) {
  const Told told("flow_meter.json");
  for (const json& linkage : told.result["linkages"]) {
    const Made nominal = four_bar(linkage, {});
    const Point circle = point_of(linkage["input"]["circle_point"]);
    const json& first = linkage["poses"][0];  // of the coupler
    std::vector<double> angles;
    for (const json& there : linkage["poses"]) {
      const Point turn = unit(radians(there["theta_deg"].get<double>() - first["theta_deg"].get<double>()));
      const Point moved = Point{there["x"], there["y"]} + turn * (circle - Point{first["x"], first["y"]});
      angles.push_back(std::arg(moved - nominal.input_fixed));
    }
    const auto squares = mean_squares(nominal, angles, [](const Place& there, const Place& should) {
      const double turn = degrees(std::remainder(there.output_angle - should.output_angle, 2 * pi));
      return turn * turn;
    });
    expect_error(linkage["tolerance"], root_mean(squares));
  }
}

// At the places of the input at which the point is within its usable length.
TEST(ToleranceLaw, OfStraightLines) {
  const Told told("straight_luffing_crane.json");
  for (const json& linkage : told.result["linkages"]) {
    const json& pivots = linkage["pivots"];
    const Made nominal =
        made_of(point_of(pivots["input_fixed"]), point_of(pivots["input_moving"]), point_of(pivots["output_moving"]),
                point_of(pivots["output_fixed"]), point_of(pivots["point"]));
    const auto& line = std::get<StraightLineTask>(told.problem.task).line;
    const Point along = unit(line.angle), at = point_of(pivots["point"]);
    const double start = std::arg(point_of(pivots["input_moving"]) - nominal.input_fixed);
    std::vector<double> angles;
    for (const double sense : {1.0, -1.0})
      for (double turn = 0; turn < 1; turn += 0.004) {
        const auto there = assembled(nominal, start + sense * turn);
        const double s = there ? std::real(std::conj(along) * (there->point - at)) : INFINITY;
        if (s < linkage["usable"]["from_s"].get<double>() || s > linkage["usable"]["to_s"].get<double>()) break;
        angles.push_back(start + sense * turn);
      }
    ASSERT_GT(angles.size(), 20u);
    const auto squares = mean_squares(nominal, angles, [&](const Place& there, const Place& should) {
      const double off = std::imag(std::conj(along) * (there.point - should.point));
      return off * off;
    });
    const double largest = 3 * std::sqrt(*std::max_element(squares.begin(), squares.end()));
    expect_error(linkage["tolerance"], largest);
  }
}

}  // namespace
}  // namespace linkwright::tolerance_law_test
