#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "loads/hand_study.hpp"

namespace linkwright {

/// The hand's force over a travel as linear functions of what is not yet known of one spring, a row to each station,
/// case and direction; without the friction of pins.
class SpringRows {
 public:
  static constexpr std::size_t most_unknowns = 2;
  struct Row {
    double turn = 0;
    std::size_t of_case = 0;
    int sense = 1;  ///< +1 opening, −1 closing
    double constant = 0;
    std::array<double, most_unknowns> by{};
    DemandedRow demanded;
    std::size_t place = 0;  ///< among those looked at
  };

  /// Of the spring at a place in a case: force, pushing, N, of all that stand side by side.
  struct Force {
    double constant = 0;
    std::array<double, most_unknowns> by{};
  };
  using ForceAt = std::function<Force(std::size_t of_case, double length)>;

  /// All that is referred to must outlive it. `spring`: its studs count, and its friction.
  SpringRows(const Loads& loads, const HandStudy& study, const Pose& body, const Spring& spring,
             const SpringDemands& demands, ForceAt force);

  /// Takes in the stations at these turns. What stands in the way, if anything.
  [[nodiscard]] std::optional<Notice> add(std::span<const double> turns);
  /// Between the station of a row and its neighbours.
  [[nodiscard]] std::vector<double> turns_near(std::size_t row) const;

  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
  /// Of the spring, over the stations.
  [[nodiscard]] double shortest() const { return shortest_; }
  [[nodiscard]] double longest() const { return longest_; }

  /// By row, what the friction of pins adds to it under a spring of known strength; nothing where they lock.
  [[nodiscard]] std::optional<std::vector<double>> friction_of_pins(const Spring& known) const;

 private:
  [[nodiscard]] std::optional<Notice> add(double turn);

  const Loads& loads_;
  const HandStudy& study_;
  Pose body_;
  Spring spring_;
  const SpringDemands& demands_;
  ForceAt force_;
  BoundLoads alone_;  ///< the spring by itself
  std::vector<Row> rows_;
  std::vector<LoadedPlace> places_;
  std::vector<double> turns_;  ///< ascending
  double shortest_, longest_ = 0;
};

}  // namespace linkwright
