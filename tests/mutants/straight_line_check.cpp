// Judges one build of the cases of straight lines by what shares nothing with their formulas: the series of the motion
// of each linkage, the path driven through contacts at places, the jet of |z − centre|² at an instant. Prints the
// number of disagreements; exits with 1 when there are any. mutants.py builds it with wrong signs.

#include <cmath>
#include <cstdio>
#include <random>

#include "linkwright/infinitesimal/instant.hpp"
#include "linkwright/infinitesimal/stationary_curvature.hpp"
#include "linkwright/straight_line/mixed_contacts.hpp"
#include "straight_line/line_cases.hpp"
#include "support/circle_contact.hpp"
#include "support/random_task.hpp"
#include "support/short_contact.hpp"
#include "support/straight_line_tasks.hpp"

namespace linkwright {
namespace {

using testing::uniform;

std::optional<MotionSeries> motion_of(const TracingFourBar& linkage) {
  const auto loop = loop_series(linkage.bars);
  return loop && linkage.longest() < 20 * linkage.shortest() ? std::optional(coupler_motion(linkage.bars, *loop))
                                                             : std::nullopt;
}

// The point touches the line as often as is asked for at every contact, as the coupler lies there.
bool touches(const TracingFourBar& linkage, const StraightLineTask& task, std::span<const PlacedContact> contacts) {
  const auto poses = contact_poses(linkage, task.line, contacts);
  if (poses.size() != contacts.size()) return false;
  const Pose here = poses.front().pose;
  for (std::size_t j = 0; j < poses.size(); ++j) {
    const auto moved = [&](Point moving) { return displaced(moving, here, poses[j].pose); };
    const TracingFourBar there{{linkage.bars.input_fixed, moved(linkage.bars.input_moving), linkage.bars.output_fixed,
                                moved(linkage.bars.output_moving)},
                               moved(linkage.point)};
    const double size = linkage.longest(),
                 stretched = std::abs(there.bars.lengths().output - linkage.bars.lengths().output);
    if (stretched > 1e-6 * size) return false;
    const auto motion = motion_of(there);
    if (motion && contact_with_line(*motion, there.point, task.line.direction).points < contacts[j].multiplicity &&
        contacts[j].multiplicity < 4)
      return false;
  }
  return true;
}

bool keeps_what_is_given(const StraightLineTask& task, const TracingFourBar& linkage) {
  if (std::abs(task.line.to_line(linkage.point).imag()) > 1e-9 * linkage.longest()) return false;
  if (const auto* mixed = std::get_if<straight_cases::MixedContacts>(&task.given))
    return touches(linkage, task, mixed->contacts);
  const auto motion = motion_of(linkage);
  return !motion || !testing::falls_short(contact_with_line(*motion, linkage.point, task.line.direction),
                                          promised_contact(task.given), linkage.longest());
}

// Contacts at places straight from their source, for the library's own may be inlined there.
LineDesigns designs_of(const StraightLineTask& task, const LineAxisValue& first, const LineAxisValue& second) {
  const auto* mixed = std::get_if<straight_cases::MixedContacts>(&task.given);
  if (!mixed) return designs_at(task, first, second);
  const auto found =
      mixed_designs(task.line, mixed->input_pivot, mixed->contacts, mixed->coupler_angle, first.value, second.value, 1);
  return {found[0], found[1]};
}

// What an instant says of the motion that it is of: points without curvature, centres that stay to the third order.
bool instant_agrees(const TracingFourBar& linkage, std::mt19937_64& random) {
  const auto motion = motion_of(linkage);
  const auto instant = motion ? instant_of(*motion) : std::nullopt;
  const auto* turning = instant ? std::get_if<TurningInstant>(&*instant) : nullptr;
  if (!turning || turning->diameter < 0.1 * linkage.longest() || turning->diameter > 10 * linkage.longest())
    return true;
  for (int i = 0; i < 4; ++i) {
    const double ray = uniform(random, 0.2, 1.3);
    const Point inflecting = turning->to_fixed(turning->diameter * std::sin(ray) * direction(ray));
    const auto path = motion->path_of(inflecting);
    if (contact_with_line(*motion, inflecting, path.c[1] / std::abs(path.c[1])).points < 3) return false;
    const CurvaturePair pair = stationary_pair(*turning, ray);
    const Point moving = pair.moving.vector() / pair.moving.w, center = pair.center.vector() / pair.center.w;
    const double far = 30 * linkage.longest();
    if (!(std::abs(moving - turning->pole) < far && std::abs(center - turning->pole) < far)) continue;
    if (testing::contact_with_circle(*motion, moving, center) < 4) return false;
  }
  const auto ball = ball_point(*turning);
  if (!ball || std::abs(*ball - turning->pole) < 1e-2 * turning->diameter) return true;
  const auto path = motion->path_of(*ball);
  return contact_with_line(*motion, *ball, path.c[1] / std::abs(path.c[1])).points >= 4;
}

}  // namespace
}  // namespace linkwright

int main() {
  using namespace linkwright;
  std::mt19937_64 random(5);
  int looked = 0, disagreements = 0;
  for (int turn = 0; turn < 60; ++turn)
    for (std::size_t which = 0; which < testing::straight_line_tasks().size(); ++which) {
      const StraightLineTask task = testing::random_straight_line(random, which);
      if (std::holds_alternative<straight_cases::SymmetricLambdas>(task.given)) continue;
      const auto axes = axes_of(task);
      for (int cell = 0; cell < 40; ++cell) {
        const auto place = [&](const LineAxis& axis) {
          return line_axis_value(axis, axis.low + uniform(random, 0, 1) * (axis.high - axis.low));
        };
        const LineAxisValue first = place(axes[0]), second = place(axes[1]);
        for (const LineDesign& design : designs_of(task, first, second)) {
          if (design.kind != DesignKind::four_bar) continue;
          ++looked;
          disagreements += !keeps_what_is_given(task, design.linkage) || !instant_agrees(design.linkage, random);
        }
      }
    }
  std::printf("%d disagreements of %d\n", disagreements, looked);
  return disagreements == 0 && looked > 10'000 ? 0 : 1;
}
