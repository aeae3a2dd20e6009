#include "io_support.hpp"

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

namespace {

Problem example(const std::string& name, int region_samples) {
  auto read = read_problem_file(std::filesystem::path(LINKWRIGHT_EXAMPLES_DIR) / name);
  EXPECT_TRUE(read.ok());
  Problem small = read.value();
  small.options.region_samples = region_samples;
  return small;
}

}  // namespace

const Problem& tailgate() {
  static const Problem problem = example("tailgate.json", 96);
  return problem;
}

const Problem& hood_hinge() {
  static const Problem problem = example("hood_hinge.json", 160);
  return problem;
}

const Solution& solved_hood_hinge() {
  static const Solution solution = solution_of(hood_hinge());
  return solution;
}

const Solution& solved_tailgate() {
  static const Solution solution = solution_of(tailgate());
  return solution;
}

Problem problem_of(const std::vector<std::array<double, 3>>& poses) {
  Problem problem;
  problem.title = "Test";
  problem.length_unit = "mm";
  problem.options.region_samples = 64;
  for (const auto& [x, y, theta_deg] : poses) motion(problem).poses.push_back({{{x, y}, radians(theta_deg)}, {}});
  return problem;
}

Solution solution_of(const Problem& problem) {
  auto solved = solve(problem.task, problem.requirements, problem.options);
  EXPECT_TRUE(solved.ok());
  return std::move(solved).value();
}

}  // namespace linkwright::testing
