#include "support/load_cases.hpp"

#include <fstream>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/problem_file.hpp"

namespace linkwright::testing {
namespace {

/// The loads of a problem of the plane that has this block.
Loads loads_of_problem(const nlohmann::json& block) {
  const nlohmann::json problem = {{"linkwright", 1},
                                  {"length_unit", "mm"},
                                  {"task",
                                   {{"kind", "motion"},
                                    {"mechanism", "four_bar"},
                                    {"poses",
                                     {{{"x", 0}, {"y", 0}, {"theta_deg", 0}},
                                      {{"x", -125}, {"y", 75}, {"theta_deg", -25}},
                                      {{"x", -220}, {"y", 220}, {"theta_deg", -52}},
                                      {{"x", -220}, {"y", 450}, {"theta_deg", -82}}}}}},
                                  {"loads", block}};
  const auto found = read_problem(problem.dump());
  if (!found) throw std::runtime_error(found.errors().front().place + ": " + found.errors().front().message);
  return found->options.loads.value();
}

}  // namespace

nlohmann::json load_file(const std::string& name) {
  return nlohmann::json::parse(std::ifstream(LINKWRIGHT_DATA_DIR "/loads/" + name + ".json"));
}

Loads loads_from(const nlohmann::json& block) {
  nlohmann::json loads = block;
  if (!loads.contains("handle") && !loads.contains("drive")) loads["drive"] = "input";
  return loads_of_problem(loads);
}

LoadCase load_case_from(const nlohmann::json& block) {
  nlohmann::json loads = {{"drive", "input"}, {"cases", {block}}};
  if (block.contains("extra"))
    for (const auto& name : block["extra"])
      loads["extra"].push_back({{"name", name}, {"on", "body"}, {"at", {0, 0}}, {"mass", 1}});
  return loads_of_problem(loads).cases.front();
}

LoadedCase loaded_case(const nlohmann::json& file) {
  LoadedCase found;
  const auto& pivots = file.at("pivots");
  found.bars = {point_from(pivots["input_fixed"]), point_from(pivots["input_moving"]),
                point_from(pivots["output_fixed"]), point_from(pivots["output_moving"])};
  const nlohmann::json here = nlohmann::json::array({nlohmann::json::array({0, 0, 0})});
  for (const auto& pose : file.contains("poses") ? file["poses"] : here)
    found.poses.push_back({{point_from(pose), radians(pose.at(2).get<double>())}, {}});
  nlohmann::json block = file.contains("loads") ? file["loads"] : nlohmann::json::object();
  if (file.contains("masses")) {
    block["body"] = {{"mass", 0}};
    block["links"] = file["masses"];
  }
  found.loads = loads_from(block);
  return found;
}

}  // namespace linkwright::testing
