#include "linkwright/planar/six_bar_family.hpp"

#include <cmath>

#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

constexpr std::size_t positions = 4;

/// Where b lies when d is at `d`: the meet of two circles, on the side of the line from a to d that `assembly_mode`
/// says.
std::optional<Point> middle_hinge_at(const ThreeLinkChain& chain, Point d, int assembly_mode) {
  const double first = chain.first_length(), second = chain.second_length(), reach = std::abs(d - chain.a);
  if (!(reach > 0)) return std::nullopt;
  const double along = (reach * reach + (first - second) * (first + second)) / (2 * reach);
  const double square = (first - along) * (first + along);
  if (!(square >= 0)) return std::nullopt;
  return chain.a + (d - chain.a) / reach * Point{along, assembly_mode * std::sqrt(square)};
}

Point unit(Point v) { return v / std::abs(v); }

/// The link that joins both bodies already, through one body between them.
std::optional<std::array<Point, 2>> present_link(const SixBar& six_bar, std::size_t joints, BodyPair between) {
  for (std::size_t i = 0; i < joints; ++i)
    for (std::size_t k = 0; k < joints; ++k)
      for (const std::size_t side : {0u, 1u})
        for (const std::size_t other : {0u, 1u}) {
          const SixBarJoint &one = six_bar.joints[i], &two = six_bar.joints[k];
          if (i != k && one.bodies[side] == between.a && two.bodies[other] == between.b &&
              one.bodies[1 - side] == two.bodies[1 - other])
            return std::array{one.point, two.point};
        }
  return std::nullopt;
}

}  // namespace

std::optional<std::array<BodyPositions, 4>> chain_positions(const std::vector<PrescribedPose>& poses,
                                                            const ThreeLinkChain& chain) {
  require(poses.size() == positions, "a six-bar's task has four poses");
  std::array<BodyPositions, 4> bodies;
  for (std::size_t j = 0; j < positions; ++j) {
    const Pose &first = poses[0].pose, &pose = poses[j].pose;
    const Point d = displaced(chain.d, first, pose);
    const int assembly_mode =
        chain.assembly_mode[j] != 0 ? chain.assembly_mode[j] : chain.assembly_mode_in_position_1();
    const auto b = j == 0 ? std::optional(chain.b) : middle_hinge_at(chain, d, assembly_mode);
    if (!b) return std::nullopt;
    bodies[0].at[j] = {chain.a, 1};
    bodies[1].at[j] = {*b, j == 0 ? 1 : unit((*b - chain.a) / (chain.b - chain.a))};
    bodies[2].at[j] = {d, j == 0 ? 1 : unit((d - *b) / (chain.d - chain.b))};
    bodies[3].at[j] = {d, direction(pose.angle - first.angle)};
  }
  return bodies;
}

BodyPositions positions_of_link(const std::array<Point, 2>& hinges, const BodyPositions& x, const BodyPositions& k) {
  BodyPositions link;
  const Point back = std::conj(unit(hinges[1] - hinges[0]));
  for (std::size_t j = 0; j < positions; ++j) {
    const Point c = x.moved(hinges[0], j), turned = (k.moved(hinges[1], j) - c) * back;
    link.at[j] = {c, turned / std::sqrt(std::norm(turned))};
  }
  link.at[0].turn = 1;
  return link;
}

SixBarOutput output_of(const SixBarMember& member, const Pose& reference) {
  return {member.six_bar, {member.turns.begin(), member.turns.end()}, reference, 0};
}

SixBarMember six_bar_member(const ThreeLinkChain& chain, std::array<BodyPair, 2> added,
                            const std::array<BodyPositions, 4>& bodies, const std::array<Point, 2>& hinges_4,
                            const BodyPositions& link_4, const std::array<Point, 2>& hinges_5) {
  SixBarMember result{SixBar::of({chain.a, chain.b, chain.d}, added, hinges_4, hinges_5), {}, {}};
  const auto body = [&](int i) -> const BodyPositions& {
    return i == 4 ? link_4 : bodies[static_cast<std::size_t>(i)];
  };
  const BodyPositions link_5 = positions_of_link(hinges_5, body(added[1].a), body(added[1].b));
  for (std::size_t j = 0; j < positions; ++j) {
    SixBarTurns& turns = result.turns[j];
    turns[0] = 1;
    for (std::size_t i = 1; i < bodies.size(); ++i) turns[i] = bodies[i].at[j].turn;
    turns[4] = link_4.at[j].turn;
    turns[5] = link_5.at[j].turn;
  }
  return result;
}

std::vector<PrescribedPose> relative_poses(const BodyPositions& x, const BodyPositions& k) {
  std::vector<PrescribedPose> poses;
  for (std::size_t j = 0; j < positions; ++j)
    poses.push_back({{x.back(k.at[j].reference, j), std::arg(std::conj(x.at[j].turn) * k.at[j].turn)}, {}});
  return poses;
}

std::optional<std::array<Point, 2>> AddedLinks::hinges(double tau, double size) const {
  if (curve->coordinate_length() == 0) return std::nullopt;
  const Dyad dyad = curve->dyad(tau);
  const auto center = finite_point(dyad.center), circle = finite_point(dyad.circle);
  if (!center || !circle) return std::nullopt;
  const std::array<Point, 2> found = {conditions.frame.to_user(*center), conditions.frame.to_user(*circle)};
  const double least = tolerance::same_linkage * size;
  if (!(std::abs(found[1] - found[0]) > least)) return std::nullopt;
  if (present && std::abs(found[0] - (*present)[0]) <= least && std::abs(found[1] - (*present)[1]) <= least)
    return std::nullopt;
  return found;
}

SixBarFamily::SixBarFamily(const ThreeLinkChain& chain, std::array<BodyPair, 2> added,
                           std::array<BodyPositions, 4> bodies)
    : chain_(chain), added_(added), bodies_(bodies) {
  const auto body = [&](int i) -> const BodyPositions& { return bodies_[static_cast<std::size_t>(i)]; };
  const SixBar bare = SixBar::of({chain.a, chain.b, chain.d}, added, {}, {});
  constexpr std::size_t chain_joints = 3;
  first_ = links(added[0], body(added[0].a), body(added[0].b));
  first_.present = present_link(bare, chain_joints, added[0]);
  if (second_depends_on_first()) return;
  auto second = links(added[1], body(added[1].a), body(added[1].b));
  second.present = present_link(bare, chain_joints, added[1]);
  independent_second_ = std::make_shared<AddedLinks>(std::move(second));
}

AddedLinks SixBarFamily::links(BodyPair between, const BodyPositions& x, const BodyPositions& k) const {
  AddedLinks result;
  result.between = between;
  result.conditions = pose_conditions(relative_poses(x, k));
  result.curve = std::make_shared<BurmesterCurve>(result.conditions);
  return result;
}

const BodyPositions& SixBarFamily::positions_of(int body, const BodyPositions& link_4) const {
  return body == 4 ? link_4 : bodies_[static_cast<std::size_t>(body)];
}

std::optional<SixBarFamily::WithFirst> SixBarFamily::with_first(double tau) const {
  const auto hinges = first_.hinges(tau, chain_.size());
  if (!hinges) return std::nullopt;
  WithFirst result{tau, *hinges, {}, independent_second_};
  result.positions = positions_of_link(*hinges, positions_of(added_[0].a, {}), positions_of(added_[0].b, {}));
  const SixBar so_far = SixBar::of({chain_.a, chain_.b, chain_.d}, added_, *hinges, {});
  constexpr std::size_t joints_with_link_4 = 5;
  const auto present = present_link(so_far, joints_with_link_4, added_[1]);
  if (second_depends_on_first()) {
    auto second =
        links(added_[1], positions_of(added_[1].a, result.positions), positions_of(added_[1].b, result.positions));
    second.present = present;
    result.second = std::make_shared<AddedLinks>(std::move(second));
  } else if (present && !independent_second_->present) {
    // Both links between the same bodies: one curve, but link 4 is taken.
    auto second = *independent_second_;
    second.present = present;
    result.second = std::make_shared<AddedLinks>(std::move(second));
  }
  return result;
}

double SixBarFamily::second_axis_length() const {
  return independent_second_ ? independent_second_->curve->coordinate_length() : 1;
}

double SixBarFamily::second_tau(const WithFirst& first, double coordinate) const {
  return independent_second_ ? coordinate : coordinate * first.second->curve->coordinate_length();
}

double SixBarFamily::second_coordinate(const WithFirst& first, double tau) const {
  return independent_second_ ? tau : tau / first.second->curve->coordinate_length();
}

std::optional<SixBarMember> SixBarFamily::member(const WithFirst& first, double tau) const {
  const auto hinges = first.second->hinges(tau, chain_.size());
  if (!hinges) return std::nullopt;
  return member(first, tau, *hinges);
}

SixBarFamily::SecondHinges SixBarFamily::independent_hinges(std::span<const double> coordinates) const {
  SecondHinges hinges;
  if (independent_second_)
    for (const double tau : coordinates) hinges.push_back(independent_second_->hinges(tau, chain_.size()));
  return hinges;
}

std::optional<SixBarMember> SixBarFamily::member(const WithFirst& first, std::span<const double> coordinates,
                                                 const SecondHinges& hinges, std::size_t i) const {
  const double tau = second_tau(first, coordinates[i]);
  if (first.second != independent_second_ || hinges.empty()) return member(first, tau);
  return hinges[i] ? std::optional(member(first, tau, *hinges[i])) : std::nullopt;
}

SixBarMember SixBarFamily::member(const WithFirst& first, double tau, std::array<Point, 2> hinges) const {
  SixBarMember result = six_bar_member(chain_, added_, bodies_, first.hinges, first.positions, hinges);
  result.coordinates = {first.coordinate, tau};
  return result;
}

}  // namespace linkwright
