#include "support/curve_case.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/coupler_curve.hpp"

namespace linkwright::testing {

namespace {

nlohmann::json json_named(const std::string& name) {
  return nlohmann::json::parse(std::ifstream(std::string(LINKWRIGHT_DATA_DIR "/approximate/") + name + ".json"));
}

}  // namespace

CurveCase curve_case(const std::string& name) {
  const auto json = json_named(name);
  CurveCase c;
  c.target.closed = json.at("closed");
  c.best = json.at("best_sum_of_squares");
  for (const auto& point : json.at("points")) c.target.points.emplace_back(point.at(0), point.at(1));
  return c;
}

PoseTarget pose_case(const std::string& name) {
  const auto json = json_named(name);
  PoseTarget target;
  target.turning_length = json.at("turning_length");
  target.exact = json.at("exact").get<std::vector<std::size_t>>();
  for (const auto& pose : json.at("poses"))
    target.poses.push_back({{pose.at(0), pose.at(1)}, radians(pose.at(2).get<double>())});
  return target;
}

TracingFourBar drawn_linkage(RandomFourBars& draw, std::initializer_list<LinkageType> types) {
  constexpr double margin = 0.03, shortest = 0.25;  // of the perimeter; of the lengths, which are below 2
  const auto suits = [&](const LinkLengths& lengths) {
    if (change_point_margin(lengths) < margin || lengths.shortest() < shortest) return false;
    return types.size() == 0 || std::find(types.begin(), types.end(), linkage_type(lengths)) != types.end();
  };
  LinkLengths lengths = draw.lengths();
  while (!suits(lengths)) lengths = draw.lengths();
  const FourBar bars = draw.four_bar(lengths);
  const Point along{draw.uniform(-0.5, 1.5), draw.uniform(-1, 1)};
  return {bars, bars.input_moving + along * (bars.output_moving - bars.input_moving)};
}

TracingFourBar drawn_linkage(std::uint64_t seed, bool crank) {
  RandomFourBars draw(seed);
  return crank ? drawn_linkage(draw, {LinkageType::crank_rocker}) : drawn_linkage(draw);
}

CurveTarget traced_target(const TracingFourBar& linkage, bool closed, int count, double sweep) {
  CurveTarget target;
  target.closed = closed;
  const auto states = closed ? motion_cycle(linkage.bars, linkage.point, count + 1)
                             : motion_sweep(linkage.bars, linkage.point, sweep, count);
  for (const MotionState& state : states) target.points.push_back(state.coupler_point);
  if (closed) target.points.pop_back();
  return target;
}

}  // namespace linkwright::testing
