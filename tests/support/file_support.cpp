#include "support/file_support.hpp"

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <unistd.h>

#include "linkwright/core/angle.hpp"

namespace linkwright::testing {

Folder::Folder() {
  std::string name = (std::filesystem::temp_directory_path() / "linkwright-XXXXXX").string();
  if (::mkdtemp(name.data()) != nullptr) path_ = name;
}

Folder::~Folder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

std::size_t Folder::file_count() const {
  return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator()));
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Problem example(const std::string& name, int region_samples) {
  auto read = read_problem_file(std::filesystem::path(LINKWRIGHT_EXAMPLES_DIR) / name);
  EXPECT_TRUE(read.ok());
  Problem small = read.value();
  small.options.region_samples = region_samples;
  return small;
}

namespace {

Solved solved(const Problem& problem) { return {problem, answer_of(problem)}; }

}  // namespace

const Solved& three_positions() {
  static const Solved latch = solved(example("latch.json", 160));
  return latch;
}

const Solved& five_positions() {
  static const Solved nose_gear = solved(example("nose_gear.json", 64));
  return nose_gear;
}

const Solved& function() {
  static const Solved sine = solved(example("sine_generator.json", 120));
  return sine;
}

const Solved& five_without_answer() {
  static const Solved none = solved(problem_of({{0, 0, 0}, {30, 10, 25}, {55, 40, 40}, {60, 75, 75}, {40, 100, 110}}));
  return none;
}

Problem problem_from(const std::string& text) {
  auto read = read_problem(text);
  EXPECT_TRUE(read.ok()) << (read.ok() ? "" : read.errors()[0].place + ": " + read.errors()[0].message);
  return read.ok() ? read.value() : Problem{};
}

const Problem& tailgate() {
  static const Problem problem = example("tailgate.json", 96);
  return problem;
}

const Problem& hood_hinge() {
  static const Problem problem = example("hood_hinge.json", 160);
  return problem;
}

const Answer& solved_hood_hinge() {
  static const Answer answer = answer_of(hood_hinge());
  return answer;
}

const Answer& solved_tailgate() {
  static const Answer answer = answer_of(tailgate());
  return answer;
}

Problem problem_of(const std::vector<std::array<double, 3>>& poses) {
  Problem problem;
  problem.title = "Test";
  problem.length_unit = "mm";
  problem.options.region_samples = 64;
  for (const auto& [x, y, theta_deg] : poses) motion(problem).poses.push_back({{{x, y}, radians(theta_deg)}, {}});
  return problem;
}

Answer answer_of(const Problem& problem) {
  auto solved = solve(problem);
  EXPECT_TRUE(solved.ok());
  return std::move(solved).value();
}

const FourBarAnswer& four_bars(const Answer& answer) {
  if (const auto* function = std::get_if<FunctionAnswer>(&answer)) return *function;
  return std::get<MotionAnswer>(answer);
}

}  // namespace linkwright::testing
