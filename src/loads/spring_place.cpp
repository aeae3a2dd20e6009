#include "linkwright/loads/spring_place.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <vector>

#include "linkwright/loads/load_report.hpp"
#include "loads/place_model.hpp"
#include "loads/place_search.hpp"

namespace linkwright {
namespace {

constexpr std::size_t most_polished = 40;

/// What of a wanted spring cannot be searched for.
class WantedMistakes {
 public:
  WantedMistakes(const SpringWanted& wanted, const Loads& loads)
      : wanted_(wanted), metres_(metres_of(loads)), knows_unit_(loads.metres.has_value()) {}

  std::vector<Error> all() {
    box("ground", wanted_.ground);
    box("body", wanted_.body);
    if (wanted_.count < 1) add("not_positive", "spring.count", "there must be one spring at least");
    if (!(wanted_.f2_over_f1 >= 1 && wanted_.f2_over_f1 <= most_ratio))
      add("bad_ratio", "spring.F2_over_F1", "F2 is from 1 to 10 times F1");
    not_negative("spring.friction", wanted_.friction);
    not_negative("min_stroke", wanted_.min_stroke);
    not_negative("min_lever", wanted_.min_lever);
    not_negative("end_length", wanted_.end_length.value_or(0));
    if (!wanted_.demands.max_f1 || !(*wanted_.demands.max_f1 > 0 && std::isfinite(*wanted_.demands.max_f1)))
      add("needs_max_F1", "max_F1",
          "the search needs the largest F1 of such a spring: without it, it runs into short springs of any force");
    if (!knows_unit_ && !wanted_.measured_at)
      add("needs_measured_at", "spring.measured_at",
          "5 mm from the ends are not known without a length unit: say where F1 and F2 are measured");
    if (!knows_unit_ && !wanted_.end_margin && !wanted_.extended_length)
      add("needs_end_margin", "end_margin",
          "a margin of 10 mm is not known without a length unit: say how much is left at the ends");
    const double measured_at = wanted_.measured_at.value_or(0.005 / metres_);
    not_negative("spring.measured_at", measured_at);
    if (wanted_.extended_length || wanted_.stroke)
      part(measured_at);
    else if (wanted_.end_margin.value_or(0.010 / metres_) < measured_at)
      add("small_margin", "end_margin",
          "the margin at the ends is at least \"measured_at\", where F1 and F2 are known");
    return std::move(found_);
  }

 private:
  static constexpr double most_ratio = 10;

  void box(const std::string& name, const StudBox& box) {
    if (!is_finite(box.low) || !is_finite(box.high)) return add("not_finite", name, "the sides of the box are numbers");
    if (box.low.real() > box.high.real()) add("low_above_high", name + ".x", "the first number is the smaller one");
    if (box.low.imag() > box.high.imag()) add("low_above_high", name + ".y", "the first number is the smaller one");
  }
  void part(double measured_at) {
    if (!wanted_.extended_length || !wanted_.stroke)
      return add("half_a_part", "stroke", "a part has both an extended length and a stroke");
    if (!(*wanted_.stroke > 2 * measured_at && *wanted_.stroke < *wanted_.extended_length))
      return add("bad_stroke", "stroke",
                 "a stroke is longer than twice \"measured_at\" and shorter than the extended length");
    const double k = wanted_.f2_over_f1;
    if (k > 1 && *wanted_.stroke - measured_at >= k / (k - 1) * (*wanted_.stroke - 2 * measured_at))
      add("no_volume", "spring.F2_over_F1", "by such a growth of the force there is no room for the gas at the end");
  }
  void not_negative(const char* at, double value) {
    if (!(value >= 0 && std::isfinite(value))) add("negative", at, "a number from 0 on");
  }
  void add(const char* code, std::string place, std::string message) {
    found_.push_back({code, std::move(place), std::move(message), {}});
  }

  const SpringWanted& wanted_;
  double metres_;
  bool knows_unit_;
  std::vector<Error> found_;
};

/// A linkage, its loads and a spring that is looked for.
struct PlaceStudy {
  std::optional<LoadTravel> travel;
  std::optional<HandStudy> hand;
  std::optional<PlaceModel> model;
  std::optional<Notice> why_not;
};

/// `into` stays where it is: the hand refers to its travel.
void study_place(PlaceStudy& into, const Loads& loads, const FourBar& bars, std::span<const PrescribedPose> poses,
                 const SpringWanted& wanted, int between) {
  const auto mistakes = mistakes_in(wanted, loads);
  require(mistakes.empty(), "mistakes_in() a wanted spring are told before it is searched for");
  if ((into.why_not = hand_missing(loads))) return;
  into.travel = LoadTravel::of(bars, poses);
  if (!into.travel) {
    into.why_not = no_travel();
    return;
  }
  into.hand.emplace(loads, *into.travel, poses.front().pose);
  auto model = PlaceModel::of(*into.hand, poses.front().pose, loads, wanted, between);
  into.model = std::move(model.found);
  into.why_not = model.why_not;
}

/// Places to be told apart.
bool is_elsewhere(const StudPlace& a, const StudPlace& b, const StudRoom& room) {
  for (std::size_t k = 0; k < a.studs.size(); ++k)
    if (std::abs(a.studs[k] - b.studs[k]) > 1e-3 * room.size[k]) return true;
  return false;
}

/// Polished, the best ones first, without those that came to one place.
std::vector<StudPlace> polished_all(const PlaceModel& model, const StudRoom& room, const std::vector<StudPlace>& starts,
                                    std::size_t most_looks, const Progress& progress) {
  std::vector<StudPlace> ends;
  for (const StudPlace& start : starts) {
    if (progress.is_cancelled() && !ends.empty()) break;
    ends.push_back(polished(model, room, start, most_looks));
  }
  std::stable_sort(ends.begin(), ends.end(),
                   [](const StudPlace& a, const StudPlace& b) { return a.value.force < b.value.force; });
  std::vector<StudPlace> apart;
  for (const StudPlace& end : ends)
    if (std::all_of(apart.begin(), apart.end(), [&](const StudPlace& other) { return is_elsewhere(end, other, room); }))
      apart.push_back(end);
  return apart;
}

/// All that one spring is judged by.
struct Judging {
  const Loads& loads;
  const FourBar& bars;
  std::span<const PrescribedPose> poses;
  const SpringWanted& wanted;
  const StudRoom& room;

  [[nodiscard]] FoundOrNot<SpringCharge> charge(const PlaceModel& model, const StudPlace& at) const {
    return best_charge(loads, bars, poses, model.spring(at.studs, at.value), wanted.demands);
  }
};

/// From a spring downhill by all friction: its stud coordinates one by one, by steps that halve where none helps.
SpringCharge settled(const Judging& by, const PlaceModel& model, SpringCharge best, int most_looks) {
  constexpr double first_step = 0.05, last_step = 5e-4;  // of the boxes
  PlaceModel::Room arrays(model);
  const Spring& is = best.spring;
  StudCoordinates at = {is.from.at.real(), is.from.at.imag(), is.to.at.real(), is.to.at.imag()};
  int looks = 0;
  const auto moves = [&](std::size_t k, double by_length) {
    StudCoordinates there = at;
    there[k] = std::clamp(there[k] + by_length, by.room.low[k], by.room.low[k] + by.room.size[k]);
    if (there[k] == at[k]) return false;
    ++looks;
    const StudPlace place{there, model.value(there, arrays)};
    if (!std::isfinite(place.value.force)) return false;
    const auto found = by.charge(model, place);
    if (!found.found || !(found.found->max_hand_force < best.max_hand_force)) return false;
    best = *found.found;
    at = there;
    return true;
  };
  for (double step = first_step; step > last_step && looks < most_looks; step /= 2) {
    bool helps = true;
    while (helps && looks < most_looks) {
      helps = false;
      for (std::size_t k = 0; k < at.size(); ++k)
        helps = moves(k, step * by.room.size[k]) || moves(k, -step * by.room.size[k]) || helps;
    }
  }
  return best;
}

/// The best of some places by all friction and the continuous travel. With pins, which may leave none of them that
/// meets the demands, the grid is looked at again with their friction.
FoundOrNot<SpringCharge> judged(const Judging& by, const HandStudy& hand, const PlaceModel& model,
                                const std::vector<StudPlace>& places, int pin_looks) {
  constexpr std::size_t most_judged = 4, starts = 16;
  constexpr int along = 8;
  FoundOrNot<SpringCharge> best;
  const auto offer = [&](FoundOrNot<SpringCharge> answer) {
    if (answer.found && std::isfinite(answer.found->max_hand_force) &&
        (!best.found || answer.found->max_hand_force < best.found->max_hand_force))
      best = {answer.found, {}};
    else if (!answer.found && !best.found)
      best.why_not = answer.why_not;
  };
  const auto offer_first = [&](const PlaceModel& of, const std::vector<StudPlace>& found) {
    for (std::size_t k = 0; k < std::min(most_judged, found.size()); ++k)
      if (std::isfinite(found[k].value.force)) offer(by.charge(of, found[k]));
  };
  offer_first(model, places);
  if (!by.loads.pins) return best;
  const PlaceModel rubbing = model.with_pins(hand, by.poses.front().pose, by.loads);
  PlaceModel::Room arrays(rubbing);
  std::vector<StudPlace> from = look_at_grid(rubbing, by.room, along, starts, {}).best;
  for (std::size_t k = 0; k < std::min(starts, places.size()); ++k)
    if (const auto value = rubbing.value(places[k].studs, arrays); std::isfinite(value.force))
      from.push_back({places[k].studs, value});
  offer_first(rubbing, polished_all(rubbing, by.room, from, 3000, {}));
  if (best.found) best.found = settled(by, rubbing, *best.found, pin_looks);
  return best;
}

Notice nothing_fits(bool proven) {
  return {"nothing_fits",
          proven ? "No spring with its studs in the boxes can be built and meets the demands."
                 : "No place in the boxes was found at which a spring can be built that meets the demands.",
          {{"proven", proven}}};
}
Notice cancelled_before() { return {"cancelled", "The search was stopped before it had found a place.", {}}; }

}  // namespace

std::vector<Error> mistakes_in(const SpringWanted& wanted, const Loads& loads) {
  return WantedMistakes(wanted, loads).all();
}

FoundOrNot<SpringPlace> place_spring(const Loads& loads, const FourBar& bars, std::span<const PrescribedPose> poses,
                                     const SpringWanted& wanted, const SpringSearchOptions& options,
                                     const Progress& progress) {
  PlaceStudy study;
  study_place(study, loads, bars, poses, wanted, options.between);
  if (study.why_not) return {{}, study.why_not};
  const StudRoom room(wanted);
  GridLook look = look_at_grid(*study.model, room, options.grid, most_polished, progress);
  progress(0.1);
  std::vector<StudPlace> places = polished_all(*study.model, room, look.best, 3000, progress);
  if (places.empty()) places.push_back({});
  progress(0.2);
  BoundedSearch search{places.front(), 0, false, 0};
  if (options.proof < 1) search = prove(*study.model, room, places.front(), options, progress, look.places);
  if (!std::isfinite(search.best.value.force))
    return {{}, progress.is_cancelled() ? cancelled_before() : nothing_fits(search.ended)};
  if (search.best.value.force < places.front().value.force) places.insert(places.begin(), search.best);
  const auto best = judged({loads, bars, poses, wanted, room}, *study.hand, *study.model, places, options.pin_looks);
  if (!best.found) return {{}, best.why_not};
  SpringPlace found{best.found->spring, best.found->max_hand_force, search.best.value.force};
  if (search.boxes > 0 && search.lower_bound > 0) found.lower_bound = std::min(search.lower_bound, found.at_stations);
  found.proven = search.ended;
  found.places = look.places;
  found.boxes = search.boxes;
  progress(1);
  return {found, {}};
}

std::string proof_words(const SpringPlace& place) {
  if (!place.lower_bound) return fmt::format("Best of {} places, not proven.", place.places);
  const double share = 100 * (1 - *place.lower_bound / place.at_stations);
  if (place.proven)
    return fmt::format("No place in the boxes is below {:.2f} N: proven to {:.1f} % ({} boxes).", *place.lower_bound,
                       share, place.boxes);
  return fmt::format("Best of {} places, not proven: none is below {:.2f} N ({} boxes).", place.places,
                     *place.lower_bound, place.boxes);
}

FoundOrNot<StudMap> stud_map(const Loads& loads, const FourBar& bars, std::span<const PrescribedPose> poses,
                             const SpringWanted& wanted, Stud over, int columns, int rows, int between,
                             const Progress& progress) {
  require(columns > 0 && rows > 0, "a map of a stud has columns and rows");
  PlaceStudy study;
  study_place(study, loads, bars, poses, wanted, between);
  if (study.why_not) return {{}, study.why_not};
  StudMap map{columns, rows,
              std::vector<double>(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows),
                                  std::numeric_limits<double>::quiet_NaN())};
  const StudRoom room(wanted);
  PlaceModel::Room arrays(*study.model);
  const std::size_t x = over == Stud::ground ? 0 : 2;
  for (int row = 0; row < rows && !progress.is_cancelled(); ++row) {
    for (int column = 0; column < columns; ++column) {
      StudCoordinates shares = {0.5, 0.5, 0.5, 0.5};
      shares[x] = (column + 0.5) / columns;
      shares[x + 1] = (row + 0.5) / rows;
      const double force = study.model->value(room.at(shares), arrays).force;
      if (std::isfinite(force))
        map.force[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(column)] = force;
    }
    progress((row + 1.0) / rows);
  }
  return {std::move(map), {}};
}

namespace {

SpringWanted as_wanted(const SpringWanted& wanted, const CatalogueSpring& part) {
  SpringWanted of = wanted;
  of.name = part.name;
  of.f2_over_f1 = part.f2_over_f1;
  of.friction = part.friction;
  of.measured_at = part.measured_at;
  of.extended_length = part.extended_length;
  of.stroke = part.stroke;
  return of;
}

/// One part, at the best place of any of its forces.
class PartSearch {
 public:
  PartSearch(const Loads& loads, const FourBar& bars, std::span<const PrescribedPose> poses, const SpringWanted& wanted,
             const CatalogueSpring& part, const Progress& progress)
      : loads_(loads), bars_(bars), poses_(poses), wanted_(wanted), part_(part), progress_(progress) {}

  /// Nothing: it does not do, and missed() says why.
  std::optional<PlacedPart> best() {
    std::vector<Placing> placings;
    for (const auto& [low, high] : sold()) {
      if (progress_.is_cancelled()) break;
      if (low <= most() && high >= least()) add(placings, std::max(low, least()), std::min(high, most()));
    }
    std::stable_sort(placings.begin(), placings.end(),
                     [](const Placing& a, const Placing& b) { return a.force() < b.force(); });
    for (const Placing& placing : placings) {
      if (progress_.is_cancelled()) break;
      if (auto placed = charged(placing)) return placed;
    }
    return std::nullopt;
  }

  /// The force that it would have to have.
  [[nodiscard]] MissedPart missed() {
    if (const double by = beyond(least(), most()); by > 0)
      return {0,
              {"F1_not_asked_for",
               fmt::format("None of its F1 is within what is asked for: the nearest is {:.0f} N off.", by),
               {{"by", by}}},
              by};
    constexpr double much = 3, usual = 1000;
    double strongest = 0;
    for (const auto& [low, high] : sold()) strongest = std::max(strongest, high);
    std::vector<Placing> placings;
    add(placings, 0, std::max(much * strongest, wanted_.demands.max_f1.value_or(usual)));
    const auto fitted = placings.empty() ? std::nullopt : charged(placings.front());
    if (!fitted) return {0, last_.value_or(nothing_fits(false)), std::numeric_limits<double>::infinity()};
    const double by = beyond(fitted->low, fitted->high);
    return {0,
            {"no_such_F1",
             fmt::format("It would have to have an F1 from {:.0f} to {:.0f} N, {:.0f} N from those that there are.",
                         fitted->low, fitted->high, by),
             {{"at_least", fitted->low}, {"at_most", fitted->high}, {"by", by}}},
            by};
  }

 private:
  [[nodiscard]] double least() const { return wanted_.demands.min_f1.value_or(0); }
  [[nodiscard]] double most() const { return wanted_.demands.max_f1.value_or(std::numeric_limits<double>::infinity()); }
  /// The F1 that it is to be had with, from and to.
  [[nodiscard]] std::vector<std::array<double, 2>> sold() const {
    std::vector<std::array<double, 2>> all;
    for (const double f1 : part_.f1) all.push_back({f1, f1});
    if (part_.f1_from && part_.f1_to) all.push_back({*part_.f1_from, *part_.f1_to});
    return all;
  }
  /// From the nearest of them to a range of forces; 0: one is within.
  [[nodiscard]] double beyond(double from, double to) const {
    double by = std::numeric_limits<double>::infinity();
    for (const auto& [low, high] : sold()) by = std::min(by, std::max({from - high, low - to, 0.0}));
    return by;
  }

  /// The best places for a range of forces, friction of pins left out.
  struct Placing {
    SpringWanted of;
    std::vector<StudPlace> places;
    [[nodiscard]] double force() const { return places.front().value.force; }
  };

  void add(std::vector<Placing>& placings, double low, double high) {
    constexpr int along = 8;
    constexpr std::size_t starts = 8;
    Placing placing{as_wanted(wanted_, part_), {}};
    placing.of.demands.min_f1 = low;
    placing.of.demands.max_f1 = high;
    const auto mistakes = mistakes_in(placing.of, loads_);
    if (!mistakes.empty()) {
      last_ = Notice{mistakes.front().code, mistakes.front().place + ": " + mistakes.front().message, {}};
      return;
    }
    PlaceStudy study;
    study_place(study, loads_, bars_, poses_, placing.of, between);
    last_ = study.why_not;
    if (last_) return;
    const StudRoom room(placing.of);
    const GridLook look = look_at_grid(*study.model, room, along, starts, progress_);
    placing.places = polished_all(*study.model, room, look.best, 1500, progress_);
    if (placing.places.empty())
      last_ = nothing_fits(false);
    else
      placings.push_back(std::move(placing));
  }

  [[nodiscard]] std::optional<PlacedPart> charged(const Placing& placing) {
    PlaceStudy study;
    study_place(study, loads_, bars_, poses_, placing.of, between);
    if (study.why_not) return last_ = study.why_not, std::nullopt;
    const StudRoom room(placing.of);
    const auto best =
        judged({loads_, bars_, poses_, placing.of, room}, *study.hand, *study.model, placing.places, no_looks);
    if (!best.found) return last_ = best.why_not, std::nullopt;
    return placed(placing.of, *best.found);
  }

  /// With the forces that would do at that place.
  [[nodiscard]] PlacedPart placed(SpringWanted of, const SpringCharge& best) const {
    PlacedPart found{0, best.spring, best.low, best.high, best.max_hand_force};
    of.demands.min_f1 = wanted_.demands.min_f1;
    of.demands.max_f1 = wanted_.demands.max_f1;
    if (const auto all = best_charge(loads_, bars_, poses_, best.spring, of.demands); all.found) {
      found.low = all.found->low;
      found.high = all.found->high;
    }
    return found;
  }

  static constexpr int between = 12, no_looks = 0;
  const Loads& loads_;
  const FourBar& bars_;
  std::span<const PrescribedPose> poses_;
  const SpringWanted& wanted_;
  const CatalogueSpring& part_;
  const Progress& progress_;
  std::optional<Notice> last_;  ///< why there is none
};

}  // namespace

RankedParts rank_parts(const Loads& loads, const FourBar& bars, std::span<const PrescribedPose> poses,
                       const SpringWanted& wanted, std::span<const CatalogueSpring> parts, const Progress& progress) {
  RankedParts ranked;
  for (std::size_t k = 0; k < parts.size() && !progress.is_cancelled(); ++k) {
    PartSearch search(loads, bars, poses, wanted, parts[k], progress);
    if (auto placed = search.best()) {
      placed->part = k;
      ranked.fit.push_back(*placed);
    } else if (!progress.is_cancelled()) {
      ranked.missed.push_back(search.missed());
      ranked.missed.back().part = k;
    }
    progress((static_cast<double>(k) + 1) / static_cast<double>(parts.size()));
  }
  std::stable_sort(ranked.fit.begin(), ranked.fit.end(),
                   [](const PlacedPart& a, const PlacedPart& b) { return a.max_hand_force < b.max_hand_force; });
  std::stable_sort(ranked.missed.begin(), ranked.missed.end(),
                   [](const MissedPart& a, const MissedPart& b) { return a.by < b.by; });
  return ranked;
}

}  // namespace linkwright
