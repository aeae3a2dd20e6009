#pragma once

#include "core/kernels.hpp"

namespace linkwright {

/// Within this share, and so many newtons, forces are as large as each other.
inline constexpr double as_large = 1e-8;

/// A point that a body carries, as a kernel reads it: of the ground in the fixed frame, of the body from its origin as
/// it lies in position 1, of links along and across from their pivot.
struct LanePoint {
  enum On : unsigned char { ground, input, body, coupler, output };
  On on = ground;
  double x = 0, y = 0;
};

/// What acts in some cases, number by number, newtons and the user's unit of length.
struct LaneLoads {
  static constexpr int most_cases = 16, most_forces = 40, most_springs = 16;

  /// A weight or another force.
  struct Force {
    LanePoint at;
    double x[most_cases] = {}, y[most_cases] = {};  ///< 0 where it does not act
    bool turns = false;                             ///< its components are then told with its body in position 1, of
                                                    ///< links along and across
    bool is_rod = false;                            ///< a force per length of its link, at the link's middle
    bool at_middle = false;
  };
  struct Spring {
    LanePoint from, to;
    double count = 1;
    bool is_gas = false;
    double per_volume = 0, extended = 0;                   ///< of gas: F = charge / (1 − x per_volume) − air
    double charge[most_cases] = {}, air[most_cases] = {};  ///< of gas
    double friction = 0, friction_slope = 0;
    double rate[most_cases] = {}, free_length = 0;  ///< of coils
    bool pushes = true, pulls = true;
    /// Its strength is each linkage's own, LoadRow::shares: `charge` is that of the weakest, and the strongest has so
    /// much more.
    bool is_free = false;
    double charge_rise[most_cases] = {};
  };
  int cases = 0, forces = 0;
  Force force[most_forces];
  /// In the positions of the task springs between ground and body act alike in all linkages, those that end at the
  /// input link alike in a row of a map, those that end at the output link alike in a column. Each kind stands after
  /// the last; here is where it ends.
  int common_springs = 0, row_springs = 0, column_springs = 0, springs = 0;
  Spring spring[most_springs];
  bool on_coupler = false;                                  ///< forces act there, or springs or the cylinder end there
  bool on_output = false;                                   ///< forces act there
  bool turning = false;                                     ///< some forces do
  double hand_x[most_cases] = {}, hand_y[most_cases] = {};  ///< direction of a hand that has one of its own
};

/// Forces on input link and body, moments about their pivots.
struct LaneWrench {
  double input[2] = {}, input_moment = 0, body[2] = {}, body_moment = 0;
  double about_input = 0;  ///< of all of them about the fixed pivot, if the body's acted at its own
};

/// Forces that a body carries in one case, as it turns by e: force + e turning in all, and of moment
/// e × lever + moment about its pivot.
struct LaneCarried {
  double force[2] = {}, lever[2] = {}, turning[2] = {}, moment = 0;
};

/// What the linkages of a map share, and what those of a column do. All lie in one frame; moments on the body are about
/// its origin.
struct LoadTables {
  static constexpr int most_positions = 5;
  static constexpr int most_lanes = 8;  ///< so many columns may be read from any one on

  const LaneLoads* loads = nullptr;
  int positions = 0;
  double origin[most_positions][2] = {}, turned[most_positions][2] = {};  ///< of the body, from position 1
  LaneCarried carried[LaneLoads::most_cases];                             ///< by the body, turned from position 1
  LaneWrench* common = nullptr;                                           ///< to each position and case
  LaneWrench* common_rubbing = nullptr;                                   ///< to each position and common spring

  /// Numbers of columns: fixed pivot, moving pivot in the positions, length; forces carried by the output link, to each
  /// case; what acts on the output link and by its springs on the body in a position, to each position and case, and by
  /// the friction of a spring, to each position and spring of columns.
  double* numbers = nullptr;
  int stride = 0;  ///< columns, and as many more as may be read
  static constexpr int of_wrench = 6, of_carried = 7;
  [[nodiscard]] double* fixed(int axis) const { return row(axis); }
  [[nodiscard]] double* moving(int position, int axis) const { return row(2 + 2 * position + axis); }
  [[nodiscard]] double* length() const { return row(2 + 2 * positions); }
  [[nodiscard]] double* carried_at(int c) const { return row(first_carried() + of_carried * c); }
  [[nodiscard]] double* acting(int position, int c) const {
    return row(first_acting() + of_wrench * (position * loads->cases + c));
  }
  [[nodiscard]] double* rubbing(int position, int spring) const {
    return row(first_rubbing() + of_wrench * (position * springs() + spring - loads->row_springs));
  }
  [[nodiscard]] int rows() const { return first_rubbing() + of_wrench * positions * springs(); }

 private:
  [[nodiscard]] double* row(int number) const { return numbers + number * stride; }
  [[nodiscard]] int springs() const { return loads->column_springs - loads->row_springs; }
  [[nodiscard]] int first_carried() const { return 3 + 2 * positions; }
  [[nodiscard]] int first_acting() const { return first_carried() + of_carried * loads->cases; }
  [[nodiscard]] int first_rubbing() const { return first_acting() + of_wrench * positions * loads->cases; }
};

/// Steps about an inner station of those that were passed.
struct LoadSteps {
  double before = 0, after = 0, over_before = 0, over_after = 0, over_both = 0;
};

/// The linkages of a row whose driver turns in one sense, and what is read off each, as CellLoads::read_out() has it
/// with CellLook::map.
struct LoadRow {
  static constexpr int most_stations = 64;

  enum What : unsigned char { open, close, hand, hold, pin, effort, rise, shut, error };
  static constexpr int whats = 9;
  static constexpr int curves = 7;  ///< of a case at most
  /// Numbers to each lane of curves: those of all cases, and the turn of the body.
  [[nodiscard]] int of_curves() const { return (tables->loads->cases * curves + 1) * stations; }
  enum Drive : unsigned char { by_hand, by_input, by_output, by_cylinder };
  enum Hand : unsigned char { tangential, along };

  unsigned counted[whats] = {};  ///< the cases that count, a bit to each; none: it is not asked for
  Drive drive = by_hand;
  Hand hand_way = tangential;
  LanePoint handle, cylinder_from, cylinder_to;
  double friction_circle = 0;
  const LoadTables* tables = nullptr;

  int stations = 0;
  int position[most_stations] = {};  ///< of the task at a station, −1 between them
  double sense = 1;                  ///< of the driver
  double input_fixed[2] = {}, input_moving[most_stations][2] = {};
  LoadSteps steps[most_stations];                        ///< of inner ones
  LoadSteps position_steps[LoadTables::most_positions];  ///< of positions, without what is between them
  const double* shares = nullptr;  ///< of columns: strength of the free spring between its weakest and its strongest

  // Worked out of these by the kernel.
  LaneWrench* acting = nullptr;  ///< to each station and case; of the body between positions what is fixed in the frame
  LaneWrench* rubbing = nullptr;                    ///< to each position and common spring or spring of the row
  LaneCarried carried[LaneLoads::most_cases];       ///< by the body, about its pivot
  double length = 0;                                ///< of the input link
  double body[2] = {};                              ///< its origin from its pivot in position 1
  double grip[LoadTables::most_positions][2] = {};  ///< the handle from the body's pivot

  double* values = nullptr;  ///< room for those of curves, to each case, curve, station and lane
  /// Where the hand's forces are kept: to each column and case those of opening at all stations, then of closing; null:
  /// nowhere.
  double* hand_forces = nullptr;

  int columns = 0;
  const signed char* senses = nullptr;  ///< of the drivers; 0 where nothing is asked
  double unit[whats] = {};              ///< by which values are multiplied
  float* value[whats] = {};  ///< of columns, written where they are in this sense; infinite, to the worse side, where
                             ///< the effort rests somewhere
};

LINKWRIGHT_DECLARE_KERNELS(load_tables_kernel, LoadTables&);
LINKWRIGHT_DECLARE_KERNELS(load_kernel, LoadRow&);

}  // namespace linkwright
