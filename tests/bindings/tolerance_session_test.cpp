// The session asked about linkages made with tolerances: what the page is told agrees with what solve() says.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <numeric>

#include "linkwright/analyses/tolerance_study.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "session.hpp"
#include "support/file_support.hpp"

namespace linkwright::wasm::tolerance_session_test {
namespace {

using nlohmann::json;

constexpr int samples = 40;

struct Case {
  const char* example;
  json tolerances;
};

json lengths(double half, const char* limit, double most) {
  return {{"length", half}, {"limit", {{limit, most}}}, {"samples", 2000}};
}

json with_tolerances(const std::string& example, const json& tolerances) {
  json problem = json::parse(write_problem(testing::example(example + ".json", samples)));
  problem["tolerances"] = tolerances;
  return problem;
}

struct Explored {
  explicit Explored(const json& problem, std::string_view property = measures::tolerance_error.key) {
    set(problem);
    request.samples = samples;
    explore(property);
  }
  void set(const json& problem) { EXPECT_TRUE(session.set_problem(problem.dump())) << session.mistakes(); }
  void explore(std::string_view property) {
    request.property = property;
    reply = session.explore(request);
  }
  json sample(int cells) { return json::parse(session.sample_yields(cells)); }
  [[nodiscard]] const std::vector<float>& values() const { return reply.map->values; }
  [[nodiscard]] std::vector<std::size_t> passing() const {
    std::vector<std::size_t> cells;
    const auto& fails = reply.map->fails;
    for (std::size_t cell = 0; cell < fails.size(); ++cell)
      if (fails[cell] == 0) cells.push_back(cell);
    return cells;
  }
  [[nodiscard]] MapPoint place(std::size_t cell) const {
    const std::size_t columns = reply.map->region.output_coordinates().size();
    return {reply.map->region.input_coordinates()[cell / columns],
            reply.map->region.output_coordinates()[cell % columns]};
  }
  PageSession session;
  MapRequest request;
  ExploreReply reply;
};

class EachKindOfTolerances : public ::testing::TestWithParam<Case> {};

TEST_P(EachKindOfTolerances, ACellIsWhatItsLinkageTells) {
  Explored explored(with_tolerances(GetParam().example, GetParam().tolerances));
  const auto cells = explored.passing();
  ASSERT_FALSE(cells.empty());
  for (std::size_t k = 0; k < cells.size(); k += 1 + cells.size() / 5) {
    const float shown = explored.values()[cells[k]];
    const auto [input, output] = explored.place(cells[k]);
    const json told = json::parse(explored.session.linkage({input, output}).tolerance);
    EXPECT_NEAR(static_cast<double>(shown) / told["error"].get<double>(), 1, 1e-4);
    EXPECT_EQ(told["samples"], 2000);
  }
}

TEST_P(EachKindOfTolerances, ALinkageIsTakenApart) {
  Explored explored(with_tolerances(GetParam().example, GetParam().tolerances));
  ASSERT_FALSE(explored.passing().empty());
  const auto [input, output] = explored.place(explored.passing().front());
  constexpr int bins = 11, drawn = 25;
  const ToleranceReply reply = explored.session.tolerance({input, output}, bins, drawn);
  const json told = json::parse(reply.report);
  const json& counts = told["histograms"]["counts"];
  const double assembled = 2000 * (1 - told["tolerance"]["not_assembled"].get<double>());
  for (const json& of_position : counts) {
    ASSERT_EQ(of_position.size(), static_cast<std::size_t>(bins));
    const auto each = of_position.get<std::vector<double>>();
    EXPECT_NEAR(std::accumulate(each.begin(), each.end(), 0.0), assembled, 1e-6);
  }
  const auto a_sample = told["positions"].get<std::size_t>();
  ASSERT_GT(reply.drawn.size(), 0u);
  EXPECT_EQ(reply.drawn.size() % a_sample, 0u);
  EXPECT_TRUE(std::all_of(reply.drawn.begin(), reply.drawn.end(), [](double x) { return std::isfinite(x); }));
}

TEST_P(EachKindOfTolerances, YieldsComeUntilAllAreThere) {
  Explored explored(with_tolerances(GetParam().example, GetParam().tolerances), measures::yield.key);
  const std::size_t wanted = explored.passing().size();
  json state = explored.sample(0);
  EXPECT_EQ(state, json({{"done", 0}, {"total", wanted}}));
  for (int turn = 0; turn < 10'000 && state["done"] < state["total"]; ++turn) state = explored.sample(37);
  EXPECT_EQ(state["done"], wanted);
  explored.explore(measures::yield.key);
  const auto problem = read_problem(with_tolerances(GetParam().example, GetParam().tolerances).dump());
  const auto answer = solve(*problem);
  const auto cells = explored.passing();
  for (std::size_t k = 0; k < cells.size(); k += 1 + cells.size() / 7) {
    const double exact = findings(*answer).added.find(measures::yield)->measure->at(explored.place(cells[k])).value();
    EXPECT_FLOAT_EQ(explored.values()[cells[k]], static_cast<float>(exact));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, EachKindOfTolerances,
    ::testing::Values(Case{"tailgate", lengths(0.5, "position", 1)},
                      Case{"sine_generator", lengths(0.3, "angle_deg", 0.3)},
                      Case{"wrist_orthosis",
                           {{"link_angle_deg", 0.3}, {"limit", {{"angle_deg", 0.5}}}, {"samples", 2000}}},
                      Case{"straight_luffing_crane", lengths(0.1, "deviation", 0.5)}));

TEST(SessionWithTolerances, OnlyTheirColumnIsNewWhereOnlyTheyChange) {
  Explored explored(with_tolerances("tailgate", lengths(0.5, "position", 1)));
  const std::vector<float> before = explored.values();
  explored.set(with_tolerances("tailgate", lengths(1, "position", 1)));
  explored.explore(measures::tolerance_error.key);
  for (const std::size_t cell : explored.passing()) EXPECT_NEAR(explored.values()[cell] / before[cell], 2, 1e-5);
}

TEST(SessionWithTolerances, AYieldIsRequired) {
  json problem = with_tolerances("tailgate", lengths(1, "position", 1.5));
  problem["requirements"]["min_yield"] = 0.8;
  Explored explored(problem, measures::yield.key);
  const std::size_t all = explored.passing().size();
  explored.sample(1'000'000);
  explored.explore(measures::yield.key);
  EXPECT_LT(explored.passing().size(), all);
  ASSERT_FALSE(explored.passing().empty());
  for (const std::size_t cell : explored.passing()) EXPECT_GE(explored.values()[cell], 0.8F);
}

TEST(SessionWithTolerances, TellsTheFrontOfItsMap) {
  Explored explored(with_tolerances("tailgate", lengths(0.5, "position", 1)));
  const json front = json::parse(explored.session.front("min_transmission_angle", "tolerance_error"))["front"];
  ASSERT_GT(front.size(), 2u);
  for (std::size_t i = 1; i < front.size(); ++i) {
    EXPECT_LT(front[i][2], front[i - 1][2]);
    EXPECT_LT(front[i][3], front[i - 1][3]);
  }
  EXPECT_TRUE(json::parse(explored.session.front("min_transmission_angle", "nothing"))["front"].empty());
}

// Straight lines tell of their best at once, but not by what is no measure of theirs.
TEST(SessionWithTolerances, TheBestIsFoundByThem) {
  json problem = with_tolerances("straight_luffing_crane", lengths(0.01, "deviation", 0.5));
  problem["options"]["objective"] = "tolerance_error";
  PageSession session;
  ASSERT_TRUE(session.set_problem(problem.dump()));
  EXPECT_EQ(json::parse(session.best(1))["linkages"].size(), 1u);
}

TEST(SessionWithTolerances, NothingIsLeftOfThoseTakenBack) {
  Explored explored(with_tolerances("tailgate", lengths(0.5, "position", 1)));
  explored.sample(50);
  json bare = with_tolerances("tailgate", {});
  bare.erase("tolerances");
  explored.set(bare);
  explored.explore(measures::tolerance_error.key);
  EXPECT_TRUE(explored.reply.map->region.values(measures::tolerance_error).empty());
  EXPECT_TRUE(explored.reply.map->region.values(measures::yield).empty());
  const auto [input, output] = explored.place(explored.passing().front());
  EXPECT_EQ(explored.session.linkage({input, output}).tolerance, "");
  EXPECT_EQ(explored.session.tolerance({input, output}, 10, 10).report, "");
  EXPECT_EQ(explored.sample(10), json({{"done", 0}, {"total", 0}}));
  EXPECT_TRUE(json::parse(explored.session.front("min_transmission_angle", "tolerance_error"))["front"].empty());
}

}  // namespace
}  // namespace linkwright::wasm::tolerance_session_test
