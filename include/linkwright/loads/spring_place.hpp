#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "linkwright/core/progress.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/loads/loads.hpp"
#include "linkwright/loads/spring_charge.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"

// Where a gas spring between the ground and the body helps the hand most: its two studs in two boxes, its length and
// its force. Forces in newtons, lengths in the user's unit, angles in radians. docs/theory/loads.md.
namespace linkwright {

/// Room for a stud, its sides along the axes; without size the stud is given.
struct StudBox {
  Point low{}, high{};

  friend bool operator==(const StudBox&, const StudBox&) = default;
};

/// The spring that is looked for.
struct SpringWanted {
  std::string name;
  int count = 1;                      ///< side by side
  double f2_over_f1 = 1.33;           ///< ≥ 1, of the forces without friction: what the volume of the spring fixes
  double friction = 0;                ///< half the difference of compressing and extending
  std::optional<double> measured_at;  ///< from both ends; nothing: 5 mm
  StudBox ground, body;               ///< of the studs: fixed frame, moving frame
  SpringDemands demands;              ///< max_f1 must be there: without it the search runs into short strong springs
  double min_stroke = 0;
  std::optional<double> end_margin;  ///< beyond the lengths used, at both ends, ≥ measured_at; nothing: 10 mm
  std::optional<double> end_length;  ///< the extended length is at least two strokes and this
  double min_lever = 0;              ///< of |dl/ds|, s the handle's way, over at least half of the stations
  /// Of a part that is there as it is; nothing: as the lengths used want it, with the margin at both ends.
  std::optional<double> extended_length, stroke;

  friend bool operator==(const SpringWanted&, const SpringWanted&) = default;
};

/// All of the caller's mistakes; places as in files of boxes: `ground.x`, `spring.friction`, …
[[nodiscard]] std::vector<Error> mistakes_in(const SpringWanted& wanted, const Loads& loads);

/// How far a search is.
struct SpringSearchState {
  double best = 0;         ///< largest hand force of the best place so far, friction of pins left out
  double lower_bound = 0;  ///< nothing in the boxes is below
  std::size_t places = 0, boxes = 0;
};

struct SpringSearchOptions {
  int between = 12;     ///< ≥ 1 steps from position to position: the stations at which forces are looked at
  int grid = 12;        ///< ≥ 1 places along each side of a box, at first
  double proof = 0.05;  ///< share of the force by which nothing is better when the search ends; ≥ 1: no proof
  int pin_looks = 80;   ///< at springs near the best one, by all friction; of pins, which the proof leaves out
  std::size_t most_boxes = 4'000'000;                  ///< at which the proof is given up
  std::function<void(const SpringSearchState&)> told;  ///< now and then
};

/// A spring that was placed.
struct SpringPlace {
  Spring spring;
  double max_hand_force = 0;  ///< by load_report(): all friction, the continuous travel; the worst of the cases
  double at_stations = 0;     ///< of the stations, friction of pins left out: what `lower_bound` is to be compared with
  /// No spring with studs in the boxes that meets the demands has a largest hand force below. It holds with the
  /// friction of pins and between the stations too, as both can only add to the largest force.
  std::optional<double> lower_bound;
  bool proven = false;  ///< the lower bound is within the share asked for of `at_stations`
  std::size_t places = 0, boxes = 0;
};

/// `loads`: all others; springs that are there stay. Cancelled, or at the most boxes: what was found, not proven.
/// Reasons of best_charge(); nothing_fits: no place in the boxes was found at which a spring could be built that meets
/// the demands, with "proven" 1 if there is none; cancelled: before there was any.
[[nodiscard]] FoundOrNot<SpringPlace> place_spring(const Loads& loads, const FourBar& bars,
                                                   std::span<const PrescribedPose> poses, const SpringWanted& wanted,
                                                   const SpringSearchOptions& options = {},
                                                   const Progress& progress = {});

/// The sentence of proof: what was found, and what is known of all other places.
[[nodiscard]] std::string proof_words(const SpringPlace& place);

/// Least largest hand force over the box of one stud, the other in the middle of its box, by rows from low y to high y:
/// of the stations, friction of pins left out. NaN where nothing can be built that meets the demands, and where it was
/// cancelled before.
struct StudMap {
  int columns = 0, rows = 0;
  std::vector<double> force;
};
enum class Stud : unsigned char { ground, body };
[[nodiscard]] FoundOrNot<StudMap> stud_map(const Loads& loads, const FourBar& bars,
                                           std::span<const PrescribedPose> poses, const SpringWanted& wanted, Stud over,
                                           int columns, int rows, int between = 12, const Progress& progress = {});

/// A part of a catalogue.
struct CatalogueSpring {
  std::string name;
  double rod_diameter = 0;  ///< mm; 0: not known
  double extended_length = 0, stroke = 0;
  std::vector<double> f1;                  ///< those that it is sold with
  std::optional<double> f1_from, f1_to;    ///< in place of them: any of these
  double f2_over_f1 = 1.33, friction = 0;  ///< as in SpringWanted
  std::optional<double> measured_at;

  friend bool operator==(const CatalogueSpring&, const CatalogueSpring&) = default;
};

/// A part in its best place in the boxes.
struct PlacedPart {
  std::size_t part = 0;  ///< of the catalogue
  Spring spring;
  double low = 0, high = 0;  ///< F1 that would meet the demands there
  double max_hand_force = 0;
};
/// A part that does not do, and why.
struct MissedPart {
  std::size_t part = 0;
  Notice why;
  double by = 0;  ///< N of F1 that are missing; infinite where it fits nowhere
};
struct RankedParts {
  std::vector<PlacedPart> fit;     ///< the least hand force first
  std::vector<MissedPart> missed;  ///< the nearest first
};
/// Every part in the boxes of `wanted`, whose spring counts for its name, its count and its demands only. Grid and
/// polish, no proof. Cancelled: of the parts that were reached.
[[nodiscard]] RankedParts rank_parts(const Loads& loads, const FourBar& bars, std::span<const PrescribedPose> poses,
                                     const SpringWanted& wanted, std::span<const CatalogueSpring> parts,
                                     const Progress& progress = {});

}  // namespace linkwright
