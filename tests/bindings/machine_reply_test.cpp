// Linkages of all kinds as plates on pins, as the page draws and moves them.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>

#include "linkwright/core/angle.hpp"
#include "linkwright/machine/mesh.hpp"
#include "session.hpp"
#include "support/file_support.hpp"
#include "support/machine_cases.hpp"

namespace linkwright::wasm::machine_reply_test {
namespace {

using nlohmann::json;

/// Where the bodies get to.
struct Travelled {
  std::vector<double> travel;
  std::size_t bodies;

  [[nodiscard]] std::size_t width() const { return 1 + 7 * (bodies - 1); }
  [[nodiscard]] std::size_t rows() const { return travel.size() / width(); }
  [[nodiscard]] double angle_deg(std::size_t row) const { return travel[row * width()]; }
  /// `share`: of the way to the next row.
  [[nodiscard]] Displacement displacement(std::size_t row, std::size_t body, double share = 0) const {
    if (body == 0) return {};
    std::array<double, 7> at{};
    const double* from = &travel[row * width() + 1 + 7 * (body - 1)];
    const double* to = share > 0 ? from + width() : from;
    const double sense = from[0] * to[0] + from[1] * to[1] + from[2] * to[2] + from[3] * to[3] < 0 ? -1 : 1;
    for (std::size_t k = 0; k < 7; ++k) at[k] = (1 - share) * from[k] + share * (k < 4 ? sense : 1) * to[k];
    return {Rotation(UnitQuaternion::of(at[0], {at[1], at[2], at[3]}).value()), {at[4], at[5], at[6]}};
  }
  /// At any angle within.
  [[nodiscard]] Displacement at(double angle, std::size_t body) const {
    std::size_t row = 0;
    while (row + 2 < rows() && angle_deg(row + 1) <= angle) ++row;
    const double step = angle_deg(row + 1) - angle_deg(row);
    return displacement(row, body, step > 0 ? std::clamp((angle - angle_deg(row)) / step, 0.0, 1.0) : 0);
  }
};

struct Replied : Travelled {
  explicit Replied(const Machine& of) : made(of), reply(machine_reply(of, {})), plan(json::parse(reply.plan)) {
    travel = reply.travel;
    bodies = of.linkage.bodies.size();
  }
  [[nodiscard]] Vector3 vertex(std::size_t corner) const {
    const std::size_t at = 3 * std::size_t{reply.triangles[corner]};
    return {reply.vertices[at], reply.vertices[at + 1], reply.vertices[at + 2]};
  }

  const Machine& made;
  MachineReply reply;
  json plan;
};

/// Heights of a layer over the ground's lower face; about a centre radii.
std::pair<double, double> layer_of(const Machine& made, const Part& part) {
  const auto& linkage = made.linkage;
  const auto& sizes = made.sizes;
  const auto& layers = made.layers;
  const auto top = *std::max_element(layers.layer.begin(), layers.layer.end());
  const auto low = [&](int layer) {
    return linkage.spherical ? sizes.radius - sizes.thickness - (top - layer) * sizes.pitch() : layer * sizes.pitch();
  };
  int first = layers.layer[static_cast<std::size_t>(part.body)], last = first;
  if (const auto hinge = static_cast<std::size_t>(&part - made.parts.data()); hinge >= linkage.bodies.size())
    std::tie(first, last) =
        std::minmax({layers.layer[static_cast<std::size_t>(linkage.hinges[hinge - linkage.bodies.size()].bodies[0])],
                     layers.layer[static_cast<std::size_t>(linkage.hinges[hinge - linkage.bodies.size()].bodies[1])]});
  return {low(first), low(last) + sizes.thickness};
}

TEST(MachineReply, HasTheClosedSurfaceOfEachPartWithinItsLayers) {
  for (const Machine& made : testing::machines()) {
    const Replied replied(made);
    ASSERT_EQ(replied.plan["parts"].size(), made.parts.size());
    std::size_t corner = 0;
    for (std::size_t k = 0; k < made.parts.size(); ++k) {
      const json& told = replied.plan["parts"][k];
      EXPECT_EQ(told["name"], made.parts[k].name);
      EXPECT_EQ(told["body"], made.linkage.bodies[static_cast<std::size_t>(made.parts[k].body)]);
      const auto [low, high] = layer_of(made, made.parts[k]);
      std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
      for (std::size_t end = corner + 3 * told["triangles"].get<std::size_t>(); corner < end; ++corner) {
        const Vector3 at = replied.vertex(corner);
        // A pin's rim lies a little farther out than its middle.
        const double height = made.linkage.spherical ? norm(at) : at.z, rim = made.linkage.spherical ? 0.01 * high : 0;
        EXPECT_GE(height, low - 1e-6 * high) << told;
        EXPECT_LE(height, high + 1e-6 * high + rim) << told;
        const std::size_t next = corner % 3 == 2 ? corner - 2 : corner + 1;
        ++edges[{replied.reply.triangles[corner], replied.reply.triangles[next]}];
      }
      for (const auto& [edge, uses] : edges)
        EXPECT_TRUE(uses == 1 && edges.contains({edge.second, edge.first})) << made.linkage.title << ' ' << told;
    }
    EXPECT_EQ(corner, replied.reply.triangles.size());
  }
}

TEST(MachineReply, HasTheDisplacementsOfAllStatesOfTheTravel) {
  for (const Machine& made : testing::machines()) {
    const Replied replied(made);
    EXPECT_GE(replied.rows(), made.linkage.travel.size());
    for (std::size_t row = 1; row < replied.rows(); ++row)
      EXPECT_GE(replied.angle_deg(row), replied.angle_deg(row - 1));
    for (const MovingState& state : made.linkage.travel) {
      if (!state.position) continue;
      for (std::size_t body = 1; body < made.linkage.bodies.size(); ++body)
        for (const Hinge& hinge : made.linkage.hinges)
          EXPECT_LT(norm(replied.at(degrees(state.driver_turn), body).apply_to_point(hinge.point) -
                         state.bodies[body].apply_to_point(hinge.point)),
                    1e-9 * (1 + norm(hinge.point)));
    }
    EXPECT_EQ(replied.plan["guided"], made.linkage.bodies[static_cast<std::size_t>(made.linkage.guided)]);
  }
}

// At a half-turn the last digit would choose between q and −q, and differ from machine to machine.
TEST(MachineReply, HasTurnsWhoseSignRunsOn) {
  for (const Machine& made : testing::machines()) {
    const Replied replied(made);
    for (std::size_t body = 0; body + 1 < replied.bodies; ++body) {
      const auto turn = [&](std::size_t row) { return &replied.travel[row * replied.width() + 1 + 7 * body]; };
      double greatest_w = -1;
      for (std::size_t row = 0; row < replied.rows(); ++row) {
        greatest_w = std::max(greatest_w, turn(row)[0]);
        if (row == 0) continue;
        EXPECT_GT(std::inner_product(turn(row), turn(row) + 4, turn(row - 1), 0.0), 0.5);
      }
      EXPECT_NEAR(greatest_w, 1, 1e-9) << made.linkage.title;  // in position 1 nothing is turned
    }
  }
}

// The plan reckons with chords between two of its states, and keeps the gap to them: what is shown there keeps to it.
TEST(MachineReply, BetweenTwoStatesKeepsToTheChordWithinHalfOfTheGap) {
  for (const Machine& made : testing::machines()) {
    const Replied replied(made);
    const double scale = made.linkage.spherical ? made.sizes.radius : 1;
    double most = 0;
    for (std::size_t row = 0; row + 1 < replied.rows(); ++row)
      for (std::size_t body = 1; body < made.linkage.bodies.size(); ++body)
        for (const std::size_t hinge : made.linkage.hinges_of(static_cast<int>(body))) {
          const Vector3 at = scale * made.linkage.hinges[hinge].point;
          const auto there = [&](std::size_t of, double share) {
            return replied.displacement(of, body, share).apply_to_point(at);
          };
          most = std::max(most, norm(there(row, 0.5) - 0.5 * (there(row, 0) + there(row + 1, 0))));
        }
    EXPECT_LT(most, made.sizes.gap / 2) << made.linkage.title;
  }
}

/// What the page draws flat or on its ball and what it draws of plates stand alike, in every state of the drive.
void expect_to_stand_as_driven(PageSession& session, MapPoint place, const std::string& name) {
  const LinkageReply linkage = session.linkage(place);
  const MachineReply machine = session.machine(place, {});
  const json reply = json::parse(linkage.linkage), plan = json::parse(machine.plan);
  const auto width = reply["travel"]["width"].get<std::size_t>();
  const bool spherical = width == spherical_state_width;
  const Travelled travelled{machine.travel, plan["layers"].size()};
  // The input's moving pivot, the driver's hinge b of a six-bar; of axes either unit vector.
  const auto moving = [&](std::size_t row) {
    const double* state = &linkage.states[row * width];
    return spherical ? Vector3{state[13], state[14], state[15]} : Vector3{state[1], state[2], 0};
  };
  // A row of the drive in which the parts lie as they are told.
  std::size_t first = 0;
  while (first * width < linkage.states.size() &&
         std::abs(linkage.states[first * width] - plan["at_deg"].get<double>()) > 1e-6)
    ++first;
  ASSERT_LT(first * width, linkage.states.size()) << name;
  double most = 0, size = 1e-9;
  for (std::size_t row = 0; row < linkage.states.size() / width; ++row) {
    const double angle = linkage.states[row * width];
    most = std::max(most, norm(travelled.at(angle, 1).apply_to_point(moving(first)) - moving(row)));
    size = std::max(size, norm(moving(row) - moving(first)));
  }
  EXPECT_LT(most, 1e-4 * size) << name;
}

TEST(MachineReply, OfLinkagesThatAreOpenedStandsAsTheyAreDriven) {
  PageSession session;
  for (const AnyStoredLinkage& stored : testing::stored_linkages_of_examples()) {
    const std::string file = std::visit([](const auto& of_kind) { return write_linkage(of_kind); }, stored);
    const json task = {{"kind", "linkage"}, {"file", json::parse(file)}};
    ASSERT_TRUE(session.set_problem(json{{"linkwright", 1}, {"length_unit", "mm"}, {"task", task}}.dump()));
    expect_to_stand_as_driven(session, {0, 0}, file.substr(0, 100));
  }
}

TEST(MachineReply, OfEveryKindOfExampleIsAMachineOrAReason) {
  PageSession session;
  std::map<std::string, bool> made;  // by kind and mechanism of the task
  for (const auto& entry : std::filesystem::directory_iterator(LINKWRIGHT_EXAMPLES_DIR)) {
    if (entry.path().extension() != ".json") continue;
    const std::string text = testing::text_of(entry.path().string());
    const json task = json::parse(text, nullptr, true, true)["task"];
    const auto [kind, is_new] = made.try_emplace(task["kind"].get<std::string>() + ' ' + task.value("mechanism", ""));
    if (!is_new) continue;
    ASSERT_TRUE(session.set_problem(text)) << entry.path() << session.mistakes();
    const json best = json::parse(session.best(1))["linkages"];
    const MapPoint place = best.empty() ? MapPoint{} : MapPoint{best[0]["tau"][0], best[0]["tau"][1]};
    const json plan = json::parse(session.machine(place, {}).plan);
    EXPECT_TRUE(plan.contains("parts") || !plan["mistakes"].empty()) << entry.path();
    kind->second = plan.contains("parts");
    if (kind->second) expect_to_stand_as_driven(session, place, kind->first);
  }
  EXPECT_GE(made.size(), 6u);
  EXPECT_TRUE(made["motion four_bar"] && made["motion six_bar"] && made["motion spherical_four_bar"]);
}

}  // namespace
}  // namespace linkwright::wasm::machine_reply_test
