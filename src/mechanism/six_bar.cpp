#include "linkwright/mechanism/six_bar.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace linkwright {
namespace {

constexpr std::array<std::string_view, 4> topology_names = {"watt_1", "stephenson_1", "stephenson_2", "stephenson_3"};
constexpr std::array<std::string_view, SixBar::joint_count> joint_names = {"a", "b", "d", "c4", "z4", "c5", "z5"};

bool is_body(char c) { return c >= '0' && c < '0' + SixBar::bodies; }

std::optional<std::size_t> hinge_between(const SixBar& six_bar, int x, int y) {
  for (std::size_t j = 0; j < SixBar::joint_count; ++j)
    if (six_bar.joints[j].bodies == std::array{x, y} || six_bar.joints[j].bodies == std::array{y, x}) return j;
  return std::nullopt;
}

bool joined(const SixBar& six_bar, int x, int y) { return hinge_between(six_bar, x, y).has_value(); }

/// The hinge between each two bodies; none: SixBar::joint_count.
using HingeTable = std::array<std::array<std::size_t, SixBar::bodies>, SixBar::bodies>;
HingeTable hinge_table(const SixBar& six_bar) {
  HingeTable table;
  for (auto& row : table) row.fill(SixBar::joint_count);
  for (std::size_t j = SixBar::joint_count; j-- > 0;) {
    const auto x = static_cast<std::size_t>(six_bar.joints[j].bodies[0]),
               y = static_cast<std::size_t>(six_bar.joints[j].bodies[1]);
    table[x][y] = table[y][x] = j;
  }
  return table;
}

bool has_order(const SixBar& six_bar, int body, std::size_t order) { return six_bar.joints_of(body).size() == order; }

}  // namespace

std::string_view name(SixBarTopology topology) { return topology_names[static_cast<std::size_t>(topology)]; }

std::string text(BodyPair pair) { return fmt::format("{}-{}", pair.a, pair.b); }

std::optional<BodyPair> body_pair_from(std::string_view text) {
  if (text.size() != 3 || text[1] != '-' || !is_body(text[0]) || !is_body(text[2])) return std::nullopt;
  return BodyPair{text[0] - '0', text[2] - '0'};
}

SixBar SixBar::of(std::array<Point, 3> chain, std::array<BodyPair, 2> added, std::array<Point, 2> link_4,
                  std::array<Point, 2> link_5) {
  return {{{{{0, 1}, chain[0]},
            {{1, 2}, chain[1]},
            {{2, 3}, chain[2]},
            {{added[0].a, 4}, link_4[0]},
            {{4, added[0].b}, link_4[1]},
            {{added[1].a, 5}, link_5[0]},
            {{5, added[1].b}, link_5[1]}}}};
}

std::array<BodyPair, 2> SixBar::added() const {
  return {BodyPair{joints[c4].bodies[0], joints[z4].bodies[1]}, BodyPair{joints[c5].bodies[0], joints[z5].bodies[1]}};
}

std::vector<std::size_t> SixBar::joints_of(int body) const {
  std::vector<std::size_t> found;
  for (std::size_t j = 0; j < joint_count; ++j)
    if (joints[j].bodies[0] == body || joints[j].bodies[1] == body) found.push_back(j);
  return found;
}

std::vector<SixBarLength> SixBar::lengths() const {
  std::vector<SixBarLength> found;
  for (int body = 0; body < bodies; ++body) {
    const std::vector<std::size_t> own = joints_of(body);
    for (std::size_t i = 0; i < own.size(); ++i)
      for (std::size_t k = i + 1; k < own.size(); ++k)
        found.push_back({body, {own[i], own[k]}, std::abs(joints[own[k]].point - joints[own[i]].point)});
  }
  return found;
}

std::optional<std::array<std::size_t, 4>> SixBar::four_bar_loop() const {
  const HingeTable hinge = hinge_table(*this);
  constexpr std::size_t count = bodies;
  const auto joined = [&](std::size_t x, std::size_t y) { return x != y && hinge[x][y] < joint_count; };
  for (std::size_t frame = 0; frame < count; ++frame)
    for (std::size_t input = 0; input < count; ++input)
      for (std::size_t coupler = 0; joined(frame, input) && coupler < count; ++coupler)
        for (std::size_t output = 0; joined(input, coupler) && coupler != frame && output < count; ++output)
          if (output != input && joined(coupler, output) && joined(output, frame))
            return std::array{hinge[frame][input], hinge[input][coupler], hinge[coupler][output], hinge[frame][output]};
  return std::nullopt;
}

// Two ternary bodies and four binary ones: in Watt's chain the ternaries are joined, in Stephenson's they are not, and
// two binaries tie them each by itself, the other two in a chain.
std::optional<SixBarTopology> SixBar::topology() const {
  std::vector<int> ternaries;
  for (int body = 0; body < bodies; ++body) {
    if (has_order(*this, body, 3))
      ternaries.push_back(body);
    else if (!has_order(*this, body, 2))
      return std::nullopt;
  }
  if (ternaries.size() != 2) return std::nullopt;
  const bool ground_is_ternary = has_order(*this, 0, 3);
  if (joined(*this, ternaries[0], ternaries[1]))
    return ground_is_ternary ? std::nullopt : std::optional(SixBarTopology::watt_1);
  if (ground_is_ternary) return SixBarTopology::stephenson_3;
  const bool between = joined(*this, 0, ternaries[0]) && joined(*this, 0, ternaries[1]);
  return between ? SixBarTopology::stephenson_1 : SixBarTopology::stephenson_2;
}

std::string_view joint_name(std::size_t joint) { return joint_names.at(joint); }

std::string name(const SixBarLength& length) {
  return fmt::format("{}:{}-{}", length.body, joint_name(length.joints[0]), joint_name(length.joints[1]));
}

}  // namespace linkwright
