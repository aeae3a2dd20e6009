#include "linkwright/straight_line/mixed_contacts.hpp"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/infinitesimal/line_contact.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "linkwright/mechanism/drive_through.hpp"
#include "linkwright/straight_line/straight_path.hpp"
#include "support/draws.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::mixed_contacts_test {
namespace {

using testing::draws;

constexpr std::array<std::array<int, 4>, 8> patterns = {
    {{1, 1, 1, 1}, {2, 1, 1, 0}, {1, 2, 1, 0}, {1, 1, 2, 0}, {2, 2, 0, 0}, {3, 1, 0, 0}, {1, 3, 0, 0}, {4, 0, 0, 0}}};

struct Task {
  DirectedLine line;
  Point input_pivot;
  std::vector<PlacedContact> contacts;
  double coupler_angle = 0, crank = 0, point_arm = 0;

  [[nodiscard]] std::array<LineDesign, 2> designs() const {
    return mixed_designs(line, input_pivot, contacts, coupler_angle, crank, point_arm, 1);
  }
};

class RandomTasks {
 public:
  explicit RandomTasks(std::uint64_t seed) : random_(seed) {}

  // Contacts at least 0.2 apart that the dyad reaches.
  Task of(const std::array<int, 4>& pattern, double coupler_angle, bool one_side = false) {
    Task task;
    task.line = {{random_.uniform(-1, 1), random_.uniform(-1, 1)}, direction(random_.uniform(-pi, pi))};
    task.input_pivot = task.line.to_fixed({random_.uniform(-1, 1), random_.uniform(-2, 2)});
    task.coupler_angle = coupler_angle;
    double s = random_.uniform(-1, 0);
    const int side = random_.below(2) ? 1 : -1;
    for (const int multiplicity : pattern)
      if (multiplicity > 0)
        task.contacts.push_back(
            {s += random_.uniform(0.2, 0.7), multiplicity, one_side || random_.below(2) ? side : -side});
    double nearest = 1e9, farthest = 0;
    for (const PlacedContact& contact : task.contacts) {
      const double distance = std::abs(task.line.to_fixed(contact.s) - task.input_pivot);
      nearest = std::min(nearest, distance);
      farthest = std::max(farthest, distance);
    }
    // |r − p| < nearest, r + p > farthest.
    const double sum = farthest * random_.uniform(1.02, 2), difference = nearest * random_.uniform(-0.98, 0.98);
    task.crank = 0.5 * (sum + difference);
    task.point_arm = 0.5 * (sum - difference);
    return task;
  }
  double angle() { return random_.uniform(-pi, pi); }
  double uniform(double from, double to) { return random_.uniform(from, to); }

 private:
  testing::RandomFourBars random_;
};

// The pin by the law of cosines.
Point pin_at(const Task& task, const PlacedContact& contact) {
  const Point way = task.line.to_fixed(contact.s) - task.input_pivot;
  const double distance = std::abs(way);
  const double cosine =
      (task.crank * task.crank + distance * distance - task.point_arm * task.point_arm) / (2 * task.crank * distance);
  return task.input_pivot + std::polar(task.crank, std::arg(way) + contact.side * std::acos(cosine));
}

// The linkage as it has to lie at a contact, its coupler being put there.
TracingFourBar at_contact(const Task& task, const TracingFourBar& linkage, const PlacedContact& contact) {
  const FourBar& bars = linkage.bars;
  const Point point = task.line.to_fixed(contact.s), pin = pin_at(task, contact);
  const Point turn = (point - pin) / (linkage.point - bars.input_moving);
  return {{bars.input_fixed, pin, bars.output_fixed, pin + turn * (bars.output_moving - bars.input_moving)}, point};
}

// The largest miss of what the contacts ask for, over the longest link; nothing where the path is singular there.
std::optional<double> worst_miss(const Task& task, const TracingFourBar& linkage) {
  const double size = linkage.longest();
  double worst = 0;
  for (const PlacedContact& contact : task.contacts) {
    const TracingFourBar there = at_contact(task, linkage, contact);
    worst = std::max(worst, std::abs(there.bars.lengths().output - linkage.bars.lengths().output) / size);
    if (contact.multiplicity == 1) continue;
    const auto loop = loop_series(there.bars);
    if (!loop) return std::nullopt;
    const MotionSeries motion = coupler_motion(there.bars, *loop);
    const LineContact path = contact_with_line(motion, there.point, task.line.direction);
    if (path.points == 0) return std::nullopt;
    double unit = 1e-9;  // 1 / the length over which the path bends
    for (std::size_t k = 2; k <= 6; ++k)
      unit = std::max(unit, std::pow(std::abs(path.deviation[k]), 1.0 / static_cast<double>(k - 1)));
    for (std::size_t k = 1; k < static_cast<std::size_t>(contact.multiplicity); ++k)
      worst = std::max(worst, std::abs(path.deviation[k]) / std::pow(unit, static_cast<double>(k - 1)));
  }
  return worst;
}

double difference(const TracingFourBar& a, const TracingFourBar& b) {
  return std::max({std::abs(a.bars.input_fixed - b.bars.input_fixed),
                   std::abs(a.bars.input_moving - b.bars.input_moving),
                   std::abs(a.bars.output_fixed - b.bars.output_fixed),
                   std::abs(a.bars.output_moving - b.bars.output_moving), std::abs(a.point - b.point)}) /
         a.longest();
}

TEST(MixedDesigns, AreThoseOfTheCases) {
  for (const char* name : {"lam_none", "lam_p_p_p_p", "lam_pp_pp", "lam_pp_pp2", "lam_ppp_p"}) {
    SCOPED_TRACE(name);
    const auto known =
        nlohmann::json::parse(std::ifstream(std::string(LINKWRIGHT_DATA_DIR "/straight_line/") + name + ".json"));
    const auto number = [](const nlohmann::json& text) { return std::stod(text.get<std::string>()); };
    const auto& in = known.at("inputs");
    Task task;
    task.line = {{number(in.at("line_point")[0]), number(in.at("line_point")[1])},
                 direction(radians(number(in.at("line_direction_deg"))))};
    task.input_pivot = {number(in.at("A0")[0]), number(in.at("A0")[1])};
    for (const auto& node : in.at("nodes")) task.contacts.push_back({number(node[0]), node[1], in.at("sigma")});
    task.coupler_angle = radians(number(in.at("delta_deg")));
    task.crank = number(in.at("r"));
    task.point_arm = number(in.at("p"));
    const auto found = task.designs();
    EXPECT_EQ(found[1].kind, DesignKind::none);
    if (known.at("solutions").empty()) {
      EXPECT_EQ(found[0].kind, DesignKind::none);
      continue;
    }
    const auto& solution = known.at("solutions")[0];
    const auto at = [&](const char* key) { return Point{solution.at(key)[0], solution.at(key)[1]}; };
    ASSERT_EQ(found[0].kind, DesignKind::four_bar);
    EXPECT_LT(difference(found[0].linkage, {{at("A0"), at("A"), at("B0"), at("B")}, at("C")}), 1e-9);
    const auto poses = contact_poses(found[0].linkage, task.line, task.contacts);
    EXPECT_EQ(!find_defects(found[0].linkage.bars, poses).defects.branch(),
              solution.at("span").at("nodes_on_one_arc").get<bool>());
  }
}

TEST(MixedDesigns, OfHoeckensContactsAreHoeckens) {
  const Task task{{{0, 4}, {1, 0}}, 0, {{2, 2, 1}, {4, 2, 1}}, 0, 1, 5};
  const auto found = task.designs();
  ASSERT_EQ(found[0].kind, DesignKind::four_bar);
  EXPECT_LT(std::abs(found[0].linkage.bars.output_fixed - Point(2, 0)), 1e-13);
  const LinkLengths lengths = found[0].linkage.bars.lengths();
  EXPECT_NEAR(lengths.coupler, 2.5, 1e-13);
  EXPECT_NEAR(lengths.output, 2.5, 1e-13);
  EXPECT_EQ(found[1].kind, DesignKind::none);
}

TEST(MixedDesigns, HaveTheirContacts) {
  RandomTasks random(1);
  for (const auto& pattern : patterns) {
    for (const bool is_straight : {true, false}) {
      int four_bars = 0, exact = 0;
      for (int i = 0; i < draws(1000); ++i) {
        const Task task = random.of(pattern, is_straight ? (i % 2 ? pi : 0) : random.angle());
        const auto found = task.designs();
        EXPECT_TRUE(!is_straight || found[1].kind == DesignKind::none);
        for (const LineDesign& design : found) {
          if (design.kind != DesignKind::four_bar) continue;
          const auto miss = worst_miss(task, design.linkage);
          if (!miss) continue;
          ++four_bars;
          exact += *miss < 1e-9;
          EXPECT_LT(*miss, 1e-5);
          const FourBar& bars = design.linkage.bars;
          const Point arm = (bars.output_moving - bars.input_moving) / (design.linkage.point - bars.input_moving);
          EXPECT_LT(std::abs((arm * direction(-task.coupler_angle)).imag()), 1e-9 * std::abs(arm));
          EXPECT_NEAR(bars.lengths().input, task.crank, 1e-12);
          EXPECT_NEAR(std::abs(design.linkage.point - bars.input_moving), task.point_arm, 1e-12);
          EXPECT_LT(std::abs(design.linkage.point - task.line.to_fixed(task.contacts[0].s)), 1e-12);
        }
      }
      EXPECT_GT(four_bars, draws(300));
      EXPECT_GT(exact, 0.99 * four_bars);
    }
  }
}

TEST(MixedDesigns, OfOneFourfoldContactHaveBallsPoint) {
  RandomTasks random(2);
  int four_bars = 0, short_of_four = 0;
  for (int i = 0; i < draws(1000); ++i) {
    const Task task = random.of({4, 0, 0, 0}, random.angle());
    for (const LineDesign& design : task.designs()) {
      if (design.kind != DesignKind::four_bar) continue;
      const FourBar& bars = design.linkage.bars;
      const auto loop = loop_series(bars);
      if (!loop) continue;
      ++four_bars;
      short_of_four +=
          contact_with_line(coupler_motion(bars, *loop), design.linkage.point, task.line.direction).points < 4;
    }
  }
  EXPECT_GT(four_bars, draws(300));
  EXPECT_LT(short_of_four, 0.01 * four_bars);  // to 1e-9; where conditions are all but dependent
}

TEST(MixedDesigns, OfAllButStraightCouplersHoldThoseOfStraightOnes) {
  RandomTasks random(3);
  int compared = 0;
  for (int i = 0; i < draws(2000); ++i) {
    Task task = random.of(patterns[static_cast<std::size_t>(i) % patterns.size()], 0);
    const LineDesign straight = task.designs()[0];
    if (straight.kind != DesignKind::four_bar || straight.linkage.longest() > 100) continue;
    for (const double angle : {1e-8, -1e-8, pi - 1e-8}) {
      task.coupler_angle = angle;
      const auto bent = task.designs();
      const auto off = [&](const LineDesign& design) {
        return design.kind == DesignKind::four_bar ? difference(straight.linkage, design.linkage) : 1.0;
      };
      EXPECT_LT(std::min(off(bent[0]), off(bent[1])), 1e-3);
      ++compared;
    }
  }
  EXPECT_GT(compared, draws(2000));
}

// On a walk over the crank's length the next linkage of a layer is nearer than that of the other one, but where they
// meet.
TEST(MixedDesigns, AreContinuousOverTheirTwoLengths) {
  RandomTasks random(4);
  int steps = 0, near = 0, swapped = 0;
  for (int i = 0; i < draws(400); ++i) {
    Task task = random.of(patterns[static_cast<std::size_t>(i) % patterns.size()], random.angle());
    const double crank = task.crank;
    auto before = task.designs();
    for (int step = 1; step <= 200; ++step) {
      task.crank = crank * (1 + 1e-3 * step);
      const auto now = task.designs();
      const auto is_four_bar = [](const LineDesign& design) {
        return design.kind == DesignKind::four_bar && design.linkage.longest() < 30;
      };
      if (std::all_of(now.begin(), now.end(), is_four_bar) && std::all_of(before.begin(), before.end(), is_four_bar)) {
        ++steps;
        const double same =
                         difference(before[0].linkage, now[0].linkage) + difference(before[1].linkage, now[1].linkage),
                     other =
                         difference(before[0].linkage, now[1].linkage) + difference(before[1].linkage, now[0].linkage);
        near += same < 0.05;
        swapped += other < 0.05 && 2 * other < same;
      }
      before = now;
    }
  }
  EXPECT_GT(steps, draws(10000));
  EXPECT_GT(near, 0.9 * steps);
  EXPECT_EQ(swapped, 0);
}

TEST(MixedDesigns, MoveWithTheTask) {
  RandomTasks random(5);
  int compared = 0, same = 0;
  for (int i = 0; i < draws(1000); ++i) {
    const Task task = random.of(patterns[static_cast<std::size_t>(i) % patterns.size()], random.angle());
    const Point turn = direction(random.angle()), way{random.uniform(-50, 50), random.uniform(-50, 50)};
    const double size = std::exp(random.uniform(-5, 5));
    const auto moved = [&](Point p) { return way + size * turn * p; };
    Task other = task;
    other.line = {moved(task.line.point), turn * task.line.direction};
    other.input_pivot = moved(task.input_pivot);
    for (PlacedContact& contact : other.contacts) contact.s *= size;
    other.crank *= size;
    other.point_arm *= size;
    const auto a = task.designs(), b = mixed_designs(other.line, other.input_pivot, other.contacts, other.coupler_angle,
                                                     other.crank, other.point_arm, size);
    for (std::size_t k = 0; k < 2; ++k) {
      if (a[k].kind != DesignKind::four_bar || b[k].kind != DesignKind::four_bar) continue;
      const TracingFourBar& l = a[k].linkage;
      const FourBar& bars = l.bars;
      ++compared;
      same +=
          difference(
              {{moved(bars.input_fixed), moved(bars.input_moving), moved(bars.output_fixed), moved(bars.output_moving)},
               moved(l.point)},
              b[k].linkage) < 1e-6;
    }
  }
  EXPECT_GT(compared, draws(800));
  EXPECT_GT(same, 0.99 * compared);
}

TEST(MixedDesigns, OfContactsThatMeetAreThoseOfTheMultipleContact) {
  RandomTasks random(6);
  int compared = 0, near = 0;
  for (int i = 0; i < draws(600); ++i) {
    const Task twofold = random.of({2, 1, 1, 0}, random.angle());
    const auto wanted = twofold.designs();
    for (const double apart : {1e-3, 2e-4, 0.99e-4, 1e-6, 1e-12}) {
      Task task = twofold;
      task.contacts[0].multiplicity = 1;
      task.contacts.insert(task.contacts.begin() + 1, task.contacts[0]);
      task.contacts[0].s -= 0.5 * apart;
      task.contacts[1].s += 0.5 * apart;
      const auto found = task.designs();
      for (std::size_t k = 0; k < 2; ++k) {
        if (wanted[k].kind != DesignKind::four_bar || wanted[k].linkage.longest() > 100) continue;
        ++compared;
        near += found[k].kind == DesignKind::four_bar &&
                difference(wanted[k].linkage, found[k].linkage) < 10 * apart + 1e-6;
        if (apart < tolerance::double_contact && found[k].kind == DesignKind::four_bar) {
          EXPECT_LT(std::abs(found[k].linkage.bars.output_fixed - wanted[k].linkage.bars.output_fixed),
                    1e-7 * wanted[k].linkage.longest());
        }
        // They have the contacts asked for all the same.
        if (found[k].kind != DesignKind::four_bar) continue;
        for (const PlacedContact& contact : task.contacts) {
          const TracingFourBar there = at_contact(task, found[k].linkage, contact);
          EXPECT_NEAR(there.bars.lengths().output, found[k].linkage.bars.lengths().output,
                      1e-6 * found[k].linkage.longest());
        }
      }
    }
  }
  EXPECT_GT(compared, draws(1500));
  EXPECT_GT(near, 0.95 * compared);
}

TEST(MixedDesigns, OfContactsThatMeetOnBothSidesKeepThem) {
  RandomTasks random(10);
  int four_bars = 0;
  for (int i = 0; i < draws(500); ++i) {
    Task task = random.of({2, 1, 1, 0}, random.angle());
    task.contacts[0].multiplicity = 1;
    task.contacts.insert(task.contacts.begin() + 1, task.contacts[0]);
    task.contacts[1].s += 1e-6;
    task.contacts[1].side = -task.contacts[0].side;
    for (const LineDesign& design : task.designs()) {
      if (design.kind != DesignKind::four_bar || design.linkage.longest() > 100) continue;
      ++four_bars;
      EXPECT_LT(*worst_miss(task, design.linkage), 1e-6);
    }
  }
  EXPECT_GT(four_bars, draws(200));
}

TEST(MixedDesigns, AreNoneWhereTheDyadIsStretchedOrFoldedOrOutOfReach) {
  Task task{{{0, 3}, {1, 0}}, 0, {{-1, 1, 1}, {0, 1, 1}, {1, 1, 1}, {2, 1, 1}}, 0.3, 1, 4};
  task.point_arm = 2;  // stretched at s = 0, out of reach elsewhere
  for (const LineDesign& design : task.designs()) EXPECT_EQ(design.kind, DesignKind::none);
  task = {{{0, 3}, {1, 0}}, 0, {{-1, 1, 1}, {1, 3, 1}}, 0, 1.5, 1.5 + std::sqrt(10)};  // folded at both
  EXPECT_EQ(task.designs()[0].kind, DesignKind::none);
  for (const double short_of_folded : {1e-3, 1e-15}) {
    const Task hoecken{{{0, 4}, {1, 0}}, 0, {{0, 1, 1}, {2, 2, 1}, {4, 1, 1}}, 0, 1, 5 - short_of_folded};
    EXPECT_EQ(hoecken.designs()[0].kind == DesignKind::four_bar, short_of_folded > 1e-14);
  }
  EXPECT_TRUE(contact_poses({{0, {1.5, 0}, 1, {2, 2}}, {3 + std::sqrt(10.0), 0}}, task.line, task.contacts).empty());
}

// Where the output's centre passes infinity, from one side to the other; but where a link vanishes beside the others
// before it is that far, as the arm of an output pivot does that comes to the point, which slides on the line anyway.
TEST(MixedDesigns, NameASlider) {
  RandomTasks random(9);
  int passages = 0, sliders = 0, vanishing = 0;
  for (int i = 0; i < draws(10000); ++i) {
    Task task = random.of(patterns[static_cast<std::size_t>(i) % patterns.size()], i % 2 ? 0 : random.angle());
    const std::size_t k = i % 2 ? 0 : 1;
    const auto inverse = [&](double crank) {
      task.crank = crank;
      const LineDesign design = task.designs()[k];
      return design.kind == DesignKind::four_bar ? 1.0 / (design.linkage.bars.output_fixed - task.input_pivot)
                                                 : Point{};
    };
    double low = task.crank, high = 1.01 * low;
    const Point before = inverse(low), after = inverse(high);
    if (std::max(std::abs(before), std::abs(after)) > 0.1 || dot(before, after) >= 0) continue;
    ++passages;
    for (int turn = 0; turn < 60 && task.designs()[k].kind != DesignKind::slider; ++turn) {
      const double middle = 0.5 * (low + high);
      (dot(inverse(middle), before) > 0 ? low : high) = middle;
    }
    if (task.designs()[k].kind == DesignKind::slider) {
      ++sliders;
      continue;
    }
    task.crank = low;
    const TracingFourBar beside = task.designs()[k].linkage;
    const double shortest =
        std::min({beside.bars.lengths().shortest(), std::abs(beside.point - beside.bars.input_moving),
                  std::abs(beside.point - beside.bars.output_moving)});
    vanishing += shortest < 2 * tolerance::vanishing_link * beside.longest();
  }
  if (testing::draws_are_many) {
    EXPECT_GT(sliders, 2);
  }
  EXPECT_EQ(sliders + vanishing, passages);
}

TEST(ContactPoses, AreThoseOfTheCoupler) {
  RandomTasks random(11);
  int multiple = 0;
  for (int i = 0; i < draws(500); ++i) {
    const Task task = random.of(patterns[static_cast<std::size_t>(i) % patterns.size()], random.angle());
    for (const LineDesign& design : task.designs()) {
      if (design.kind != DesignKind::four_bar) continue;
      const auto poses = contact_poses(design.linkage, task.line, task.contacts);
      ASSERT_EQ(poses.size(), task.contacts.size());
      for (std::size_t j = 0; j < poses.size(); ++j) {
        const PlacedContact& contact = task.contacts[j];
        const auto way = [&](double step) {
          PlacedContact beside = contact;
          beside.s += step;
          return task.line.to_fixed(beside.s) - pin_at(task, beside);
        };
        EXPECT_LT(std::abs(poses[j].pose.origin - task.line.to_fixed(contact.s)), 1e-13);
        EXPECT_LT(std::abs(way(0) / task.point_arm - direction(poses[j].pose.angle)), 1e-9);
        ASSERT_EQ(poses[j].derivatives.size(), contact.multiplicity > 1 ? 1u : 0u);
        if (contact.multiplicity == 1) continue;
        ++multiple;
        EXPECT_EQ(poses[j].derivatives[0].origin, task.line.direction);
        const double step = 1e-6, slope = std::arg(way(step) / way(-step)) / (2 * step);
        EXPECT_TRUE(!std::isfinite(slope) ||
                    std::abs(poses[j].derivatives[0].angle - slope) < 1e-4 * (1 + std::abs(slope)));
      }
    }
  }
  EXPECT_GT(multiple, draws(200));
}

TEST(ContactPoses, AreJudgedAsTheDriveThroughThemIs) {
  RandomTasks random(7);
  int judged = 0, clean = 0, branch = 0, order = 0, circuit = 0;
  for (int i = 0; i < draws(1500); ++i) {
    const Task task =
        random.of(patterns[static_cast<std::size_t>(i) % patterns.size()], i % 2 ? 0 : random.angle(), i % 4 != 0);
    for (const LineDesign& design : task.designs()) {
      if (design.kind != DesignKind::four_bar || design.linkage.longest() > 20) continue;
      const auto poses = contact_poses(design.linkage, task.line, task.contacts);
      ASSERT_EQ(poses.size(), task.contacts.size());
      const Defects found = find_defects(design.linkage.bars, poses).defects;
      DriveThroughOptions options;
      options.respect_direction = true;
      const auto driven = drive_through(design.linkage.bars, poses, options);
      if (!driven.completed) continue;
      ++judged;
      EXPECT_EQ(found, driven.defects);
      clean += found.none();
      branch += found.branch();
      circuit += found.circuit();
      order += found.order();
    }
  }
  EXPECT_GT(judged, draws(800));
  for (const int count : {clean, branch, circuit, order}) EXPECT_GT(count, judged / 100);
}

// Where the point runs on from the first contact to the last without turning back, the input not turning back either,
// and lies at each as it should, there is no defect.
TEST(ContactPoses, HaveNoDefectWhereThePathRunsThroughThem) {
  RandomTasks random(8);
  int straight_on = 0;
  for (int i = 0; i < draws(2000); ++i) {
    const Task task = random.of(patterns[static_cast<std::size_t>(i) % 7], i % 2 ? 0 : random.angle(), true);
    for (const LineDesign& design : task.designs()) {
      if (design.kind != DesignKind::four_bar) continue;
      const double travel = task.contacts.back().s - task.contacts.front().s;
      PathLimits limits;
      limits.from = -1e-3, limits.to = 1.001 * travel;
      const auto path = StraightPath::of(design.linkage, task.line.direction, limits);
      if (!path || path->to() < travel) continue;
      const auto stroke = path->stroke(0, travel);
      if (!stroke || !stroke->drive) continue;
      bool lies_there = true;
      for (const PlacedContact& contact : task.contacts) {
        PathLimits to_contact = limits;
        to_contact.to = contact.s - task.contacts.front().s;
        if (to_contact.to <= 0) continue;
        const auto way = StraightPath::of(design.linkage, task.line.direction, to_contact)->states(2).back();
        lies_there = lies_there && difference(at_contact(task, design.linkage, contact), way.linkage) < 1e-6;
      }
      if (!lies_there) continue;
      ++straight_on;
      EXPECT_TRUE(
          find_defects(design.linkage.bars, contact_poses(design.linkage, task.line, task.contacts)).defects.none());
    }
  }
  EXPECT_GT(straight_on, draws(100));
}

}  // namespace
}  // namespace linkwright::mixed_contacts_test
