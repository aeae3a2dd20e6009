#include "linkwright/mechanism/pose_visits.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "linkwright/core/angle.hpp"
#include "range_around.hpp"
#include "triangle.hpp"

namespace linkwright {
namespace {

/// The joint that tells the circuits apart: the one that is not at the shortest link. A linkage without Grashof's
/// property has one circuit only.
bool circuit_sign_of(const FourBar& bars, LinkageType type) {
  const Point frame = bars.output_fixed - bars.input_fixed, arm = bars.input_moving - bars.input_fixed;
  switch (type) {
    case LinkageType::crank_rocker:
    case LinkageType::double_crank:
      return assembly_of(bars) == Assembly::positive;
    case LinkageType::rocker_crank:
      return !std::signbit(cross(bars.output_moving - bars.input_fixed, arm));
    case LinkageType::double_rocker:
      return !std::signbit(cross(frame, arm));
    default:
      return true;
  }
}

FourBar four_bar_at(const FourBar& first, const Pose& from, const Pose& to) {
  return {first.input_fixed, displaced(first.input_moving, from, to), first.output_fixed,
          displaced(first.output_moving, from, to)};
}

int inversions(const std::vector<int>& order) {
  int count = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) count += order[i] > order[j];
  return count;
}

/// The travel in one sense: input turns at the poses, and the poses on the branch in the order of their turns.
struct Traversal {
  std::vector<double> turn;
  std::vector<int> order;
};

Traversal traversal_of(const PoseVisits& visits, const std::vector<double>& input_angles, double sense) {
  Traversal traversal;
  const double middle = (visits.travel.from + visits.travel.to) / 2;
  for (std::size_t j = 0; j < input_angles.size(); ++j) {
    const double plain = sense * (input_angles[j] - input_angles[0]);
    if (visits.full_turn) {
      traversal.turn.push_back(j == 0 ? 0 : wrap_positive(plain));
    } else {
      // The travel lies about its middle by less than half a turn either way.
      const double in_range = middle + wrap_signed(input_angles[j] - middle);
      const double first = middle + wrap_signed(input_angles[0] - middle);
      traversal.turn.push_back(sense * (std::clamp(in_range, visits.travel.from, visits.travel.to) -
                                        std::clamp(first, visits.travel.from, visits.travel.to)));
    }
    if (visits.on_branch[j]) traversal.order.push_back(static_cast<int>(j));
  }
  const auto passed_at = [&](int pose) { return std::pair(traversal.turn[static_cast<std::size_t>(pose)], pose); };
  std::sort(traversal.order.begin(), traversal.order.end(), [&](int i, int j) { return passed_at(i) < passed_at(j); });
  return traversal;
}

double last_turn(const Traversal& traversal) {
  return traversal.order.empty() ? 0 : traversal.turn[static_cast<std::size_t>(traversal.order.back())];
}

/// How many poses with derivatives the input would pass against their direction, turning in a sense.
int passed_against(const PoseVisits& visits, std::span<const PrescribedPose> poses, double sense) {
  int count = 0;
  for (std::size_t j = 0; j < poses.size(); ++j) {
    if (poses[j].derivatives.empty()) continue;
    const FourBar& bars = visits.four_bars[j];
    const PoseDerivative& d = poses[j].derivatives.front();
    const Point velocity = d.origin + Point{0, d.angle} * (bars.input_moving - poses[j].pose.origin);
    count += sense * cross(bars.input_moving - bars.input_fixed, velocity) < 0;
  }
  return count;
}

void choose_sense(PoseVisits& visits, const std::vector<double>& input_angles, std::span<const PrescribedPose> poses) {
  const Traversal ccw = traversal_of(visits, input_angles, 1), cw = traversal_of(visits, input_angles, -1);
  const auto faults = [&](const Traversal& traversal, double sense) {
    return std::pair(inversions(traversal.order), passed_against(visits, poses, sense));
  };
  visits.counter_clockwise = faults(ccw, 1) <= faults(cw, -1);
  const Traversal& traversal = visits.counter_clockwise ? ccw : cw;
  visits.turn = traversal.turn;
  visits.order = traversal.order;
  if (visits.full_turn) {
    const double before = (two_pi - last_turn(traversal)) / 2;
    visits.travel = {-before, two_pi - before};
  } else {
    const double middle = (visits.travel.from + visits.travel.to) / 2;
    const double first =
        std::clamp(middle + wrap_signed(input_angles[0] - middle), visits.travel.from, visits.travel.to);
    const double low = visits.travel.from - first, high = visits.travel.to - first;
    visits.travel = visits.counter_clockwise ? AngleRange{low, high} : AngleRange{-high, -low};
  }
}

}  // namespace

int PoseVisits::first_on_another_circuit() const {
  for (std::size_t j = 1; j < circuit_sign.size(); ++j)
    if (circuit_sign[j] != circuit_sign[j - 1]) return static_cast<int>(j);
  return 0;
}

int PoseVisits::first_on_another_branch() const {
  for (std::size_t j = 1; j < assembly.size(); ++j)
    if (assembly[j] != assembly[j - 1] || circuit_sign[j] != circuit_sign[j - 1]) return static_cast<int>(j);
  return 0;
}

PoseVisits pose_visits(const FourBar& four_bar, std::span<const PrescribedPose> poses) {
  PoseVisits visits;
  const LinkLengths lengths = four_bar.lengths();
  const std::vector<AngleRange> ranges = are_links(lengths) ? input_ranges(lengths) : std::vector<AngleRange>{};
  if (ranges.empty() || poses.empty()) return visits;
  const LinkageType type = linkage_type(lengths);
  std::vector<double> input_angles;
  for (const PrescribedPose& pose : poses) {
    const FourBar here = four_bar_at(four_bar, poses.front().pose, pose.pose);
    visits.four_bars.push_back(here);
    visits.assembly.push_back(assembly_of(here));
    visits.circuit_sign.push_back(circuit_sign_of(here, type));
    visits.on_circuit.push_back(visits.circuit_sign.back() == visits.circuit_sign.front());
    visits.on_branch.push_back(visits.on_circuit.back() && visits.assembly.back() == visits.assembly.front());
    input_angles.push_back(configuration_of(here).input_angle);
  }
  visits.travel = range_around(ranges, input_angles.front());
  visits.full_turn = visits.travel.is_full_turn();
  choose_sense(visits, input_angles, poses);
  return visits;
}

namespace {

int number_of(int pose, std::span<const int> numbers) {
  return numbers.empty() ? pose + 1 : numbers[static_cast<std::size_t>(pose)];
}

Notice gap_notice(const char* code, const char* sentence, int pose, std::span<const int> numbers) {
  const int from = number_of(pose - 1, numbers), to = number_of(pose, numbers);
  return {code, fmt::format(fmt::runtime(sentence), from, to), {{"from", double(from)}, {"to", double(to)}}};
}

Notice order_notice(const std::vector<int>& order, std::span<const int> numbers) {
  std::vector<int> called;
  for (const int pose : order) called.push_back(number_of(pose, numbers));
  const std::string met = fmt::format("{}", fmt::join(called, "-"));
  return {
      "order_defect", fmt::format("Order defect: this linkage reaches the positions as {}.", met), {{"order", met}}};
}

}  // namespace

std::optional<Notice> defect_notice(Defects defects, const PoseVisits& visits, std::span<const int> numbers) {
  if (defects.none()) return std::nullopt;
  if (const int pose = visits.first_on_another_circuit(); defects.circuit() && pose > 0)
    return gap_notice("circuit_defect",
                      "Circuit defect: positions {} and {} lie on different circuits; reassembly needed.", pose,
                      numbers);
  if (const int pose = visits.first_on_another_branch(); defects.branch() && pose > 0)
    return gap_notice("branch_defect", "Branch defect: it passes a dead point between positions {} and {}.", pose,
                      numbers);
  if (defects.order() && std::is_sorted(visits.order.begin(), visits.order.end()))
    return Notice{"direction_defect", "Order defect: it passes a position against its direction of travel.", {}};
  if (defects.order()) return order_notice(visits.order, numbers);
  return Notice{"change_point_defect",
                "Branch defect: it passes a change point between the positions, and may go on "
                "either way there.",
                {}};
}

}  // namespace linkwright
