#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/loads/spring_place.hpp"
#include "loads/hand_study.hpp"
#include "loads/line_envelope.hpp"
#include "loads/place_pins.hpp"
#include "loads/small_program.hpp"

namespace linkwright {

/// Of a place of a spring: x and y of the stud on the ground, then of that on the body.
using StudCoordinates = std::array<double, 4>;

/// The least largest hand force of a spring by its studs, at the stations of a travel, and lower bounds of it over
/// boxes of studs. The bounds leave out the friction of pins, which only adds; values do so until with_pins(). All that
/// does not depend on the studs is worked out once.
///
/// Between studs p = d + e^{iθ} s on the body and q on the ground, l = |p − q| and its rate by the twist is
/// l′ = ⟨n, v_p⟩ with n = (p − q)/l. The body is rigid, so that l l′ = ⟨p − q, v(p)⟩ = ⟨p − q, v(q)⟩, v(q) the velocity
/// of the point of the body that lies on q: bilinear in p and q.
class PlaceModel {
 public:
  static constexpr double nowhere = std::numeric_limits<double>::infinity();

  [[nodiscard]] static FoundOrNot<PlaceModel> of(const HandStudy& study, const Pose& body, const Loads& loads,
                                                 const SpringWanted& wanted, int between);

  /// Of the linear program of a bound: σ, the four offsets of the studs times σ, and the force.
  static constexpr std::size_t program_unknowns = 6;

  /// A quantity over a box of studs, by station: its value in the middle, its slope by the four coordinates times half
  /// the box's sides, and what it differs from that at most.
  struct Linear {
    std::vector<double> middle, rest;
    std::array<std::vector<double>, 4> slope;
    void resize(std::size_t count);
  };
  /// Arrays of one thread, by station, and lines of force over the charge.
  struct Room {
    explicit Room(const PlaceModel& model);
    Linear length, rate, work;             ///< work: rate times static force over σ
    std::vector<double> low, high;         ///< of the length
    std::vector<double> slowest, fastest;  ///< of the rate: least of its size, largest
    std::vector<double> force, force_by;   ///< static, over σ: middle, and what it differs by at most
    std::vector<double> work_low, work_high;
    std::vector<double> fast_low, fast_high;  ///< work of a case whose gas is fast
    std::vector<double> a, b;
    SmallProgram program;
  };

  struct Value {
    double force = nowhere;  ///< where nothing can be built: infinite
    double charge = 0;       ///< (F1 + F3)/2, N
    double extended_length = 0, stroke = 0;
  };
  [[nodiscard]] Value value(const StudCoordinates& studs, Room& room) const;

  struct Bound {
    double force = nowhere;  ///< no place in the box has less; infinite: nothing can be built in it
    std::size_t widest = 0;  ///< the coordinate whose interval decides most about the bound
  };
  /// Over studs between `middle` − `half` and `middle` + `half`.
  /// `enough`: a higher bound is not looked for.
  [[nodiscard]] Bound bound(const StudCoordinates& middle, const StudCoordinates& half, Room& room,
                            double enough = nowhere) const;

  /// The spring of a place.
  [[nodiscard]] Spring spring(const StudCoordinates& studs, const Value& of) const;

  /// The same, whose values have the friction of pins, to first order, under the spring itself. The loads have pins.
  [[nodiscard]] PlaceModel with_pins(const HandStudy& study, const Pose& body, const Loads& loads) const;

 private:
  /// A demand on the hand's force at a station.
  struct Limited {
    std::size_t station = 0;
    int sense = 1;
    double limit = 0;
  };
  struct OfCase {
    bool is_objective = false;
    double strength = 1;  ///< of all springs side by side: their number times what is left of each, hot or cold
    double exponent = 1;
    std::vector<double> open, close;  ///< force of the hand without the spring, all but the pins' friction among it
    std::vector<double> per_power;
    std::vector<Limited> limits;
  };
  struct Lengths {
    double shortest_low = 0, shortest_high = 0, longest_low = 0, longest_high = 0;
  };

  struct Charges {
    double low = 0, high = 0;
  };

  void reach(const StudCoordinates& middle, const StudCoordinates& half, Room& room) const;
  [[nodiscard]] Lengths lengths(const Room& room) const;
  [[nodiscard]] bool may_be_built(const Lengths& lengths, const Room& room) const;
  void forces(const Lengths& lengths, Room& room) const;
  void forces_of_part(Room& room) const;
  [[nodiscard]] double force_at(double share) const { return ratio_ / (ratio_ - (ratio_ - 1) * share); }
  void works(Room& room) const;
  [[nodiscard]] bool has_lever(const Room& room) const;
  void add_lines(const OfCase& of, Room& room) const;
  void limit_charge(const OfCase& of, Room& room, Charges& charges) const;
  void fast_works(const OfCase& of, Room& room) const;
  [[nodiscard]] LeastTop least(Room& room, Charges& charges) const;
  [[nodiscard]] LeastTop least_with_pins(const StudCoordinates& studs, Room& room, const LeastTop& start) const;
  /// A row of the hand's force at a place, a + b σ and what pins add to it.
  struct PlaceRow {
    double a = 0, b = 0;
    const PlacePins* pins = nullptr;
    std::size_t station = 0;
    int sense = 1;
    PlacePins::Pushing spring;  ///< its force without charge
    bool is_objective = false;
    std::optional<double> limit;
  };
  [[nodiscard]] std::vector<PlaceRow> rows_at(const StudCoordinates& studs, Room& room) const;
  [[nodiscard]] double by_slopes(Room& room, const Charges& charges, double at_least, double enough) const;
  [[nodiscard]] std::size_t widest(const StudCoordinates& half, const Room& room, const LeastTop& least) const;
  void add_station(const LoadedPlace& place, const Pose& body, const std::vector<HandAt>& hand, bool is_last,
                   const std::vector<LoadCase>& cases, const SpringDemands& demands, const LinkPoint& handle);
  void pad();

  std::size_t count_ = 0, padded_ = 0;  ///< stations; and up to a multiple of lanes, the last one again
  Point first_pivot_{};                 ///< at the input, in position 1
  std::vector<double> turns_;
  std::vector<double> dx_, dy_, cosine_, sine_, vx_, vy_, omega_;  ///< of the moving frame: place, axis, twist
  std::vector<double> handle_speed_;
  std::vector<OfCase> of_case_;
  std::vector<PlacePins> pins_;  ///< by case; none: without their friction
  std::string name_;
  int number_ = 1;
  double ratio_ = 1, friction_ = 0, measured_at_ = 0, margin_ = 0;
  double least_charge_ = 0, most_charge_ = 0, min_stroke_ = 0, min_lever_ = 0;
  std::optional<double> end_length_, extended_, stroke_, told_measured_at_;
};

}  // namespace linkwright
