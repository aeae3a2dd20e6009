#include "six_bar_loops.hpp"

#include <algorithm>
#include <cmath>

namespace linkwright {
namespace {

/// A point of the mechanism as a linear form in the turns of the bodies.
struct LinearForm {
  std::array<Point, SixBar::bodies> c{};
  std::array<bool, SixBar::bodies> present{};

  void add(int body, Point vector) {
    const auto i = static_cast<std::size_t>(body);
    c[i] += vector;
    present[i] = true;
  }
};

/// The point of `body` that lies at `point` in position 1, reached from the ground along the chain, or from the body
/// that an added link depends on.
LinearForm point_on(const SixBar& six_bar, int body, Point point) {
  constexpr std::array<SixBar::JointIndex, SixBar::bodies> from = {SixBar::a, SixBar::a,  SixBar::b,
                                                                   SixBar::d, SixBar::c4, SixBar::c5};
  LinearForm form;
  while (body != 0) {
    const SixBarJoint& joint = six_bar.joints[from[static_cast<std::size_t>(body)]];
    form.add(body, point - joint.point);
    body = joint.bodies[0];
    point = joint.point;
  }
  form.add(0, point);
  return form;
}

LinearForm loop_over(const SixBar& six_bar, SixBar::JointIndex closing) {
  const SixBarJoint& joint = six_bar.joints[closing];
  const LinearForm one = point_on(six_bar, joint.bodies[0], joint.point),
                   other = point_on(six_bar, joint.bodies[1], joint.point);
  LinearForm loop;
  for (std::size_t i = 0; i < loop.c.size(); ++i) {
    loop.c[i] = one.c[i] - other.c[i];
    // Bodies that both ways go along together, from the same hinge to the same hinge, drop out.
    const bool both = i > 0 && one.present[i] && other.present[i] && one.c[i] == other.c[i];
    loop.present[i] = !both && (one.present[i] || other.present[i]);
  }
  return loop;
}

/// The two bodies beside ground and driver; nothing where there are not two.
std::optional<std::array<std::size_t, 2>> two_unknown_bodies(const LinearForm& loop) {
  std::array<std::size_t, 2> found{};
  std::size_t count = 0;
  for (std::size_t i = 2; i < loop.present.size(); ++i) {
    if (!loop.present[i]) continue;
    if (count == found.size()) return std::nullopt;
    found[count++] = i;
  }
  return count == found.size() ? std::optional(found) : std::nullopt;
}

std::optional<SixBarLoops::Dyads> dyads_of(const std::array<LinearForm, 2>& loops) {
  for (std::size_t first = 0; first < 2; ++first) {
    const auto pair = two_unknown_bodies(loops[first]);
    if (!pair) continue;
    SixBarLoops::Dyads dyads;
    dyads.loop = {first, 1 - first};
    dyads.bodies[0] = *pair;
    std::size_t found = 0;
    for (std::size_t i = 2; i < static_cast<std::size_t>(SixBar::bodies); ++i)
      if (i != (*pair)[0] && i != (*pair)[1]) dyads.bodies[1][found++] = i;
    return dyads;
  }
  return std::nullopt;
}

Point term(const LoopValues& values, std::size_t loop, std::size_t body) {
  return loop == 0 ? values.u[body - 1] : values.v[body - 1];
}

double joint_cross(const SixBarLoops::Dyads& dyads, const LoopValues& values, std::size_t dyad) {
  const auto [x, y] = dyads.bodies[dyad];
  return cross(term(values, dyads.loop[dyad], x), term(values, dyads.loop[dyad], y));
}

double joint_sine(const SixBarLoops::Dyads& dyads, const LoopValues& values, std::size_t dyad) {
  const auto [x, y] = dyads.bodies[dyad];
  const double size = std::norm(term(values, dyads.loop[dyad], x)) * std::norm(term(values, dyads.loop[dyad], y));
  return size > 0 ? std::min(1.0, std::abs(joint_cross(dyads, values, dyad)) / std::sqrt(size)) : 0;
}

}  // namespace

SixBarLoops::SixBarLoops(const SixBar& six_bar) {
  const std::array<LinearForm, 2> forms = {loop_over(six_bar, SixBar::z4), loop_over(six_bar, SixBar::z5)};
  double longest = 0;
  for (const LinearForm& form : forms)
    for (const Point c : form.c) longest = std::max({longest, std::abs(c.real()), std::abs(c.imag())});
  for (std::size_t l = 0; l < 2; ++l)
    for (std::size_t i = 0; i < coefficient[l].size(); ++i)
      coefficient[l][i] = longest > 0 && forms[l].present[i] ? forms[l].c[i] / longest : Point{};
  dyads = dyads_of(forms);
}

LoopValues::LoopValues(const SixBarLoops& loops, const SixBarTurns& turns)
    : f(loops.coefficient[0][0]), g(loops.coefficient[1][0]) {
  for (std::size_t i = 0; i < 5; ++i) {
    u[i] = loops.coefficient[0][i + 1] * turns[i + 1];
    v[i] = loops.coefficient[1][i + 1] * turns[i + 1];
    f += u[i];
    g += v[i];
  }
}

double LoopValues::driver_minor() const {
  const auto mu = [this](std::size_t i, std::size_t k) { return cross(u[i], u[k]); };
  const auto mv = [this](std::size_t i, std::size_t k) { return cross(v[i], v[k]); };
  return mu(1, 2) * mv(3, 4) - mu(1, 3) * mv(2, 4) + mu(1, 4) * mv(2, 3) + mu(2, 3) * mv(1, 4) - mu(2, 4) * mv(1, 3) +
         mu(3, 4) * mv(1, 2);
}

SixBarTransmission signs_of(const SixBarLoops& loops, const LoopValues& values) {
  SixBarTransmission result;
  result.dyadic = loops.dyads.has_value();
  result.positive = values.driver_minor() > 0;
  for (std::size_t i = 0; i < 2; ++i)
    result.joint_positive[i] = loops.dyads ? joint_cross(*loops.dyads, values, i) > 0 : result.positive;
  return result;
}

std::array<double, 2> sines_of(const SixBarLoops& loops, const LoopValues& values) {
  if (loops.dyads) return {joint_sine(*loops.dyads, values, 0), joint_sine(*loops.dyads, values, 1)};
  double columns = 1;
  for (std::size_t i = 1; i < 5; ++i) columns *= std::norm(values.u[i]) + std::norm(values.v[i]);
  const double volume = std::abs(values.driver_minor());
  const double sine = columns > 0 ? std::min(1.0, std::sqrt(volume / std::sqrt(columns))) : 0;
  return {sine, sine};
}

}  // namespace linkwright
