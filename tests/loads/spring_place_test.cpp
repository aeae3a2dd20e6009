#include "linkwright/loads/spring_place.hpp"

#include <atomic>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "core/uniform.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/loads/load_report.hpp"
#include "loads/place_search.hpp"
#include "support/load_cases.hpp"

namespace linkwright::spring_place_test {
namespace {

using testing::load_file;
using testing::loaded_case;
using testing::LoadedCase;

/// The tailgate without its struts, and two struts that are looked for.
struct Asked {
  LoadedCase of = loaded_case(load_file("tailgate_gas"));
  SpringWanted wanted;

  Asked() {
    of.loads.springs.clear();
    of.loads.extra.clear();
    of.loads.cases = {{.name = "room", .counts_for = {ReadOut::hand_force}},
                      {.name = "cold", .temperature = -30, .counts_for = {ReadOut::hold_open}}};
    wanted.name = "strut";
    wanted.count = 2;
    wanted.friction = 25;
    wanted.ground = {{50, -45}, {250, 275}};
    wanted.body = {{20, 178}, {100, 418}};
    wanted.demands.min_hold_open = 13;
    wanted.demands.max_f1 = 1200;
    wanted.min_stroke = 60;
    wanted.end_length = 65;
  }
  FoundOrNot<SpringPlace> placed(const SpringSearchOptions& options = {}, const Progress& progress = {}) const {
    return place_spring(of.loads, of.bars, of.poses, wanted, options, progress);
  }
  LoadReport report(const Spring& spring) const {
    Loads loads = of.loads;
    loads.springs.push_back(spring);
    return load_report(loads, of.bars, of.poses).value();
  }
};

/// The model of stations, and what it refers to.
struct Model {
  explicit Model(const Asked& of)
      : travel(LoadTravel::of(of.of.bars, of.of.poses).value()),
        hand(of.of.loads, travel, of.of.poses.front().pose),
        model(PlaceModel::of(hand, of.of.poses.front().pose, of.of.loads, of.wanted, 12).found.value()),
        arrays(model),
        room(of.wanted) {}
  LoadTravel travel;
  HandStudy hand;
  PlaceModel model;
  PlaceModel::Room arrays;
  StudRoom room;
};

/// Random boxes of all sizes, and random places in each: how many, and how close the closest came to its bound.
struct Tried {
  int places = 0, below = 0, boxes_without = 0;
  double closest = 1e9;
};
Tried try_boxes(const Asked& of, int boxes, int places_each, std::uint64_t seed) {
  Model model(of);
  std::mt19937_64 random(seed);
  Tried tried;
  for (int box = 0; box < boxes; ++box) {
    StudCoordinates middle, half;
    const double size = 0.5 * std::pow(10, uniform(random, -3, 0));
    for (std::size_t k = 0; k < 4; ++k) {
      half[k] = model.room.size[k] * size * uniform(random, 0, 1);
      middle[k] = model.room.low[k] + uniform(random, half[k], model.room.size[k] - half[k]);
    }
    const double bound = model.model.bound(middle, half, model.arrays).force;
    tried.boxes_without += !std::isfinite(bound);
    // The lowest place that is found in it by going downhill, and places anywhere and in its corners.
    StudRoom inside = model.room;
    for (std::size_t k = 0; k < 4; ++k) {
      inside.low[k] = middle[k] - half[k];
      inside.size[k] = 2 * half[k];
    }
    const StudPlace start{middle, model.model.value(middle, model.arrays)};
    const double lowest = polished(model.model, inside, start, 120).value.force;
    tried.below += std::isfinite(lowest) && !(lowest >= bound - 1e-9 * (1 + std::abs(lowest)));
    for (int place = 0; place < places_each; ++place) {
      StudCoordinates studs;
      for (std::size_t k = 0; k < 4; ++k) {
        const double share = uniform(random, -1, 1);
        studs[k] = middle[k] + half[k] * (place % 3 == 0 ? std::copysign(1.0, share) : share);
      }
      const double force = model.model.value(studs, model.arrays).force;
      ++tried.places;
      if (!std::isfinite(force)) continue;  // nothing can be built: above every bound
      tried.below += !(force >= bound - 1e-9 * (1 + std::abs(force)));
      tried.closest = std::min(tried.closest, force - bound);
    }
  }
  return tried;
}

void expect_bounded(const Tried& tried) {
  EXPECT_EQ(tried.below, 0);
  EXPECT_LT(tried.closest, 0.05);  // a bound that is a little too high would be seen
}

TEST(Bounds, HoldInAllOfTheirBoxes) {
  Asked of;
  const Tried tried = try_boxes(of, 5000, 40, 1);
  EXPECT_EQ(tried.places, 200'000);
  expect_bounded(tried);
  EXPECT_GT(tried.boxes_without, 20);
}

TEST(Bounds, HoldWithManyCasesAndDemands) {
  Asked of;
  of.of.loads.cases = {{.name = "room"},
                       {.name = "hot, downhill", .temperature = 70, .slope = -0.1},
                       {.name = "fast", .temperature = -20, .spring_percent = 90, .gas_exponent = 1.3},
                       {.name = "cold", .temperature = -30, .counts_for = {ReadOut::hold_open}}};
  of.of.loads.handle->direction = Handle::Direction::vertical;
  of.wanted.demands.max_close_force = 160;
  of.wanted.demands.self_close_below = radians(4);
  of.wanted.demands.min_hold_open = 2;
  of.wanted.min_lever = 0.05;
  of.wanted.f2_over_f1 = 1.6;
  of.wanted.end_margin = 5;  // as far as forces are measured: a spring of no travel would have no law
  expect_bounded(try_boxes(of, 2500, 40, 2));
  of.of.loads.handle->direction = Handle::Direction::tangential;
  of.wanted.end_length.reset();
  of.wanted.min_stroke = 0;
  of.wanted.ground = {{-100, 0}, {260, 580}};  // studs may meet
  of.wanted.body = {{-60, 0}, {140, 400}};
  expect_bounded(try_boxes(of, 2500, 40, 3));
}

TEST(Bounds, HoldForPartsToo) {
  Asked of;
  of.wanted.extended_length = 325;
  of.wanted.stroke = 128;
  expect_bounded(try_boxes(of, 2500, 40, 4));
}

double told(const LoadReport& report, ReadOut read_out) { return report.worst_of(read_out).value().value; }

bool is_in(const StudBox& box, Point stud) {
  return stud.real() >= box.low.real() && stud.real() <= box.high.real() && stud.imag() >= box.low.imag() &&
         stud.imag() <= box.high.imag();
}

TEST(Place, IsTheReportsAndIsProven) {
  const Asked of;
  const auto answer = of.placed();
  ASSERT_TRUE(answer.found) << answer.why_not->message;
  const SpringPlace& found = *answer.found;
  EXPECT_TRUE(found.proven);
  EXPECT_NEAR(found.at_stations, 56.1256, 1e-3);
  EXPECT_LE(*found.lower_bound, found.at_stations);
  EXPECT_GE(*found.lower_bound, 0.95 * found.at_stations);
  EXPECT_NEAR(found.max_hand_force, found.at_stations, 0.02);
  const LoadReport report = of.report(found.spring);
  EXPECT_NEAR(told(report, ReadOut::hand_force), found.max_hand_force, 1e-9);
  EXPECT_GE(told(report, ReadOut::hold_open), 13 - 1e-6);
  EXPECT_FALSE(report.cases.front().springs.front().bottoms_at);
  EXPECT_TRUE(is_in(of.wanted.ground, found.spring.from.at));
  EXPECT_TRUE(is_in(of.wanted.body, found.spring.to.at));
  const auto& gas = std::get<GasSpring>(found.spring.law);
  EXPECT_LE(gas.f1, 1200 + 1e-6);
  EXPECT_GE(gas.stroke, 60 - 1e-6);
  EXPECT_GE(gas.extended_length, 2 * gas.stroke + 65 - 1e-6);
  EXPECT_NE(proof_words(found).find("proven to 5.0 %"), std::string::npos) << proof_words(found);
}

// Another way: springs anywhere in the boxes, as strong as is best there, by the continuous travel.
TEST(Place, IsBelowNoneThatIsChosenAtRandom) {
  const Asked of;
  const SpringPlace found = of.placed().found.value();
  Model model(of);
  std::mt19937_64 random(11);
  int tried = 0;
  for (int i = 0; i < 4000 && tried < 60; ++i) {
    StudCoordinates studs;
    for (std::size_t k = 0; k < 4; ++k) studs[k] = model.room.low[k] + uniform(random, 0, model.room.size[k]);
    const PlaceModel::Value value = model.model.value(studs, model.arrays);
    if (!std::isfinite(value.force)) continue;
    const auto charge =
        best_charge(of.of.loads, of.of.bars, of.of.poses, model.model.spring(studs, value), of.wanted.demands);
    if (!charge.found) continue;
    EXPECT_NEAR(charge.found->max_hand_force, value.force, 1 + 0.02 * value.force);
    EXPECT_GE(charge.found->max_hand_force, value.force - 1e-6);
    EXPECT_GE(charge.found->max_hand_force, *found.lower_bound);
    ++tried;
  }
  EXPECT_EQ(tried, 60);
}

TEST(Place, StandsWhereStudsAreGiven) {
  Asked of;
  of.wanted.end_length = 20;
  of.wanted.ground = {{150, 115}, {150, 115}};
  of.wanted.body = {{60, 298}, {60, 298}};
  const SpringPlace found = of.placed().found.value();
  EXPECT_TRUE(found.proven);
  EXPECT_NEAR(*found.lower_bound, found.at_stations, 1e-4);
  EXPECT_EQ(found.spring.from.at, (Point{150, 115}));
  EXPECT_EQ(found.places, 1U);
  const auto charge = best_charge(of.of.loads, of.of.bars, of.of.poses, found.spring, of.wanted.demands).found.value();
  EXPECT_NEAR(charge.best, std::get<GasSpring>(found.spring.law).f1, 1e-3);
}

TEST(Place, TakesTheFrictionOfPinsIn) {
  Asked of;
  const SpringPlace smooth = of.placed().found.value();
  of.of.loads.pins = PinFriction{6, 0.15};
  const SpringPlace found = of.placed().found.value();
  EXPECT_GT(found.max_hand_force, smooth.max_hand_force);
  EXPECT_NEAR(*found.lower_bound, *smooth.lower_bound, 1e-9);
  const LoadReport report = of.report(found.spring);
  EXPECT_NEAR(told(report, ReadOut::hand_force), found.max_hand_force, 1e-9);
  EXPECT_GE(told(report, ReadOut::hold_open), 13 - 1e-5);
  // Not worse than the place that was best without pins, where that still meets the demands.
  const auto there = best_charge(of.of.loads, of.of.bars, of.of.poses, smooth.spring, of.wanted.demands);
  if (there.found) {
    EXPECT_LE(found.max_hand_force, told(of.report(there.found->spring), ReadOut::hand_force) + 1e-9);
  } else {
    EXPECT_EQ(there.why_not->code, "demands_conflict");
  }
}

TEST(Place, SaysWhyThereIsNone) {
  Asked of;
  of.wanted.min_stroke = 400;
  auto answer = of.placed();
  ASSERT_FALSE(answer.found);
  EXPECT_EQ(answer.why_not->code, "nothing_fits");
  EXPECT_EQ(std::get<double>(answer.why_not->values.front().value), 1);
  of = Asked();
  of.wanted.demands.max_f1 = 60;  // too weak to hold it open
  EXPECT_EQ(of.placed().why_not->code, "nothing_fits");
  of = Asked();
  of.of.loads.handle.reset();
  EXPECT_EQ(of.placed().why_not->code, "no_handle");
}

TEST(Place, StopsWhenItIsCancelled) {
  const Asked of;
  std::atomic<bool> cancelled = true;
  const auto none = of.placed({}, {{}, &cancelled});
  ASSERT_FALSE(none.found);
  EXPECT_EQ(none.why_not->code, "cancelled");
  cancelled = false;
  SpringSearchOptions options;
  options.proof = 0.001;
  int told_states = 0;
  options.told = [&](const SpringSearchState& state) {
    EXPECT_LE(state.lower_bound, state.best);
    cancelled = ++told_states == 2;
  };
  const auto some = of.placed(options, {{}, &cancelled});
  ASSERT_TRUE(some.found);
  EXPECT_FALSE(some.found->proven);
  EXPECT_EQ(told_states, 2);
  EXPECT_NE(proof_words(*some.found).find("not proven"), std::string::npos);
}

TEST(Place, EndsAtTheMostBoxes) {
  const Asked of;
  SpringSearchOptions options;
  options.proof = 0.01;
  options.most_boxes = 1000;
  const SpringPlace found = of.placed(options).found.value();
  EXPECT_FALSE(found.proven);
  EXPECT_LT(found.boxes, 2000U);
}

TEST(Place, TellsMistakesByTheirPlaces) {
  Asked of;
  of.wanted.ground.low = {300, 300};
  of.wanted.demands.max_f1.reset();
  of.wanted.f2_over_f1 = 0.9;
  of.wanted.end_margin = 3;
  of.wanted.friction = std::nan("");
  std::string places;
  for (const Error& error : mistakes_in(of.wanted, of.of.loads)) places += error.place + " ";
  EXPECT_EQ(places, "ground.x ground.y spring.F2_over_F1 spring.friction max_F1 end_margin ");
}

TEST(Place, AsksForLengthsThatNoUnitTells) {
  Asked of;
  of.of.loads.metres.reset();
  of.wanted.measured_at.reset();
  of.wanted.end_margin.reset();
  std::string places;
  for (const Error& error : mistakes_in(of.wanted, of.of.loads)) places += error.place + " ";
  EXPECT_EQ(places, "spring.measured_at end_margin ");
}

// F2 = F1 lets nothing bend, and in such a wide box the studs may meet: what is no number there must limit nothing.
TEST(Bounds, HoldForEvenSpringsWhoseStudsMayMeet) {
  Asked of;
  of.wanted.f2_over_f1 = 1;
  of.wanted.ground = {{-100, 100}, {300, 500}};
  of.wanted.body = {{0, 100}, {200, 420}};
  of.wanted.demands.max_close_force = 400;
  const Tried tried = try_boxes(of, 500, 20, 3);
  EXPECT_EQ(tried.below, 0);
}

TEST(StudMap, IsTheForceOfEachPlace) {
  Asked of;
  of.wanted.end_length = 20;
  of.wanted.body = {{60, 298}, {60, 298}};
  const StudMap map = stud_map(of.of.loads, of.of.bars, of.of.poses, of.wanted, Stud::ground, 9, 7).found.value();
  ASSERT_EQ(map.force.size(), 63U);
  EXPECT_TRUE(std::any_of(map.force.begin(), map.force.end(), [](double force) { return std::isnan(force); }));
  of.wanted.ground.low = of.wanted.ground.high = {50 + 200 * 4.5 / 9, -45 + 320 * 3.5 / 7};
  EXPECT_NEAR(map.force[3 * 9 + 4], of.placed().found->at_stations, 1e-9);
}

TEST(Parts, KeepToTheForcesThatAreWanted) {
  Asked of;
  of.wanted.demands.max_f1 = 420;
  const std::vector<CatalogueSpring> parts = {
      {.name = "strong", .extended_length = 325, .stroke = 128, .f1 = {450, 500}, .friction = 25},
      {.name = "any", .extended_length = 325, .stroke = 128, .f1_from = 300, .f1_to = 800, .friction = 25}};
  const RankedParts ranked = rank_parts(of.of.loads, of.of.bars, of.of.poses, of.wanted, parts);
  for (const PlacedPart& placed : ranked.fit) {
    EXPECT_EQ(placed.part, 1U);
    EXPECT_LE(std::get<GasSpring>(placed.spring.law).f1, 420 + 1e-9);
  }
  ASSERT_FALSE(ranked.missed.empty());
  EXPECT_EQ(ranked.missed.front().part, 0U);
  EXPECT_EQ(ranked.missed.front().why.code, "F1_not_asked_for");
  EXPECT_DOUBLE_EQ(ranked.missed.front().by, 30);
}

TEST(Parts, AreRankedByTheHandsForce) {
  Asked of;
  of.wanted.demands.max_f1.reset();
  const std::vector<CatalogueSpring> parts = {
      {.name = "weak", .extended_length = 325, .stroke = 128, .f1 = {50, 80}, .friction = 25},
      {.name = "good", .rod_diameter = 8, .extended_length = 325, .stroke = 128, .f1 = {350, 400, 450}, .friction = 25},
      {.name = "long", .extended_length = 2000, .stroke = 128, .f1 = {400}, .friction = 25},
      {.name = "any", .extended_length = 285, .stroke = 100, .f1_from = 300, .f1_to = 800, .friction = 20}};
  const RankedParts ranked = rank_parts(of.of.loads, of.of.bars, of.of.poses, of.wanted, parts);
  ASSERT_EQ(ranked.fit.size(), 2U);
  EXPECT_LE(ranked.fit[0].max_hand_force, ranked.fit[1].max_hand_force);
  for (const PlacedPart& placed : ranked.fit) {
    const auto& gas = std::get<GasSpring>(placed.spring.law);
    const LoadReport report = of.report(placed.spring);
    EXPECT_NEAR(told(report, ReadOut::hand_force), placed.max_hand_force, 1e-9);
    EXPECT_GE(told(report, ReadOut::hold_open), 13 - 1e-6);
    EXPECT_FALSE(report.cases.front().springs.front().bottoms_at);
    EXPECT_EQ(gas.extended_length, parts[placed.part].extended_length);
    if (placed.part == 1) {
      EXPECT_NEAR(gas.f1 / 50, std::round(gas.f1 / 50), 1e-9);
    }
    EXPECT_LE(placed.low, gas.f1 + 1e-6);
    EXPECT_GE(placed.high, gas.f1 - 1e-6);
  }
  ASSERT_EQ(ranked.missed.size(), 2U);
  EXPECT_EQ(ranked.missed[0].part, 0U);
  EXPECT_EQ(ranked.missed[0].why.code, "no_such_F1");
  EXPECT_EQ(ranked.missed[1].part, 2U);
  EXPECT_EQ(ranked.missed[1].why.code, "nothing_fits");
}

}  // namespace
}  // namespace linkwright::spring_place_test
