#include "linkwright/files/link_chain_file.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "linkwright/core/angle.hpp"

namespace linkwright::link_chain_file_test {
namespace {

Result<LinkChainTask> read(const std::string& members) {
  return read_link_chain_task(R"({"linkwright": 1, )" + members + "}");
}

TEST(LinkChainFile, WhatIsMissingOfALinkIsZero) {
  const auto task = read(R"("links": [{"theta_deg": 90}, {"a": 2}], "form": "modified")");
  ASSERT_TRUE(task.ok());
  EXPECT_EQ(task->form, HartenbergDenavitForm::modified);
  EXPECT_EQ(task->links[0].theta, radians(90));
  EXPECT_EQ(task->links[1].a, 2);
  EXPECT_EQ(task->links[1].alpha, 0);
}

TEST(LinkChainFile, FramesArePassedAlong) {
  const auto task = read(R"("links": [{"theta_deg": 90, "a": 1}, {"theta_deg": 90, "a": 1}], "points": [[0, 0, 3]])");
  ASSERT_TRUE(task.ok());
  const auto report = link_chain_report(*task);
  ASSERT_TRUE(report.ok());
  EXPECT_LT(norm(report->frames.back().translation - Vector3{-1, 1, 0}), 1e-15);
  EXPECT_LT(norm(report->points.front() - Vector3{-1, 1, 3}), 1e-15);
  EXPECT_EQ(report->tip.kind, ScrewKind::half_turn);
  const auto written = nlohmann::json::parse(write_link_chain_report(*report));
  EXPECT_EQ(written["links"].size(), 2u);
  EXPECT_EQ(written["links"][1]["theta_deg"], 90);
}

TEST(LinkChainFile, ParametersOfADisplacement) {
  const auto task = read(R"("displacement": {"screw": {"axis": [0, 0, 1], "angle_deg": 30, "slide": 4}})");
  ASSERT_TRUE(task.ok());
  const auto report = link_chain_report(*task);
  ASSERT_TRUE(report.ok() && report->fit);
  const auto written = nlohmann::json::parse(write_link_chain_report(*report));
  EXPECT_NEAR(written["link"]["theta_deg"].get<double>(), 30, 1e-13);
  EXPECT_NEAR(written["link"]["d"].get<double>(), 4, 1e-15);
}

TEST(LinkChainFile, MistakesNameTheirPlace) {
  const std::pair<const char*, const char*> cases[] = {
      {R"("links": [])", "links"},
      {R"("links": [{}, {"alpha": 1}])", "links[1].alpha"},
      {R"("links": [{"d": "long"}])", "links[0].d"},
      {R"("links": [{}], "form": "paul")", "form"},
      {R"("form": "classic")", "links"},
  };
  for (const auto& [members, place] : cases) {
    const auto task = read(members);
    ASSERT_FALSE(task.ok()) << members;
    EXPECT_EQ(task.errors().front().place, place) << members;
  }
}

}  // namespace
}  // namespace linkwright::link_chain_file_test
