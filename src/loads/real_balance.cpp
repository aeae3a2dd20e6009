#include "linkwright/loads/real_balance.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "linkwright/core/angle.hpp"
#include "linkwright/loads/load_report.hpp"
#include "loads/box_descent.hpp"
#include "loads/carried.hpp"
#include "loads/hand_study.hpp"

namespace linkwright {
namespace {

using Place = BoxDescent::Place;

/// A station of the travel: the linkage, and its hand without springs.
struct BalanceStation {
  LoadedPlace place;
  HandAt hand;
};

/// A spring by its ends.
struct RealEnds {
  Point ground;
  LinkPoint stud;
};

/// A spring over the stations.
struct RealColumn {
  std::vector<double> force;  ///< of the hand by a unit of its rate
  double free_length = 0;
};

/// The best rates of springs with given ends.
struct RatedSprings {
  std::vector<RealColumn> columns;
  std::array<double, 2> rate{};
  std::vector<double> residual;
};

double product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// Least squares of forces + Σ rate column, the rates ≥ 0.
std::array<double, 2> best_rates(const std::vector<double>& forces, const std::vector<RealColumn>& columns) {
  constexpr double parallel = 1e-12;
  const auto alone = [&](std::size_t k) {
    const double square = product(columns[k].force, columns[k].force);
    return square > 0 ? std::max(0.0, -product(columns[k].force, forces) / square) : 0;
  };
  if (columns.size() == 1) return {alone(0), 0};
  const auto &a = columns[0].force, &b = columns[1].force;
  const double aa = product(a, a), ab = product(a, b), bb = product(b, b), fa = product(forces, a),
               fb = product(forces, b);
  const double area = aa * bb - ab * ab;
  if (area > parallel * aa * bb) {
    const double at_a = (ab * fb - bb * fa) / area, at_b = (ab * fa - aa * fb) / area;
    if (at_a >= 0 && at_b >= 0) return {at_a, at_b};
  }
  const double only_a = alone(0), only_b = alone(1);
  return only_a * fa < only_b * fb ? std::array{only_a, 0.0} : std::array{0.0, only_b};  // which gains more
}

class RealBalancing {
 public:
  RealBalancing(const Loads& weights, const FourBar& bars, std::span<const PrescribedPose> poses,
                const RealBalanceOptions& options)
      : weights_(weights), bars_(bars), poses_(poses), options_(options), size_(bars.lengths().perimeter()) {}

  /// What stands in the way, if anything.
  [[nodiscard]] std::optional<Notice> begin(const LoadTravel& travel) {
    const HandStudy study(weights_, travel, body());
    for (const double turn : travel.stations(options_.between)) {
      const auto place = travel.at(turn);
      if (!place) return no_travel();
      const auto hand = study.at(*place);
      if (!hand.found) return hand.why_not;
      stations_.push_back({*place, hand.found->front()});
      forces_.push_back(hand.found->front().without);
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<RealBalance> two() const {
    const StudBox ground = options_.ground.value_or(room_of_pivots());
    const LinkLengths lengths = bars_.lengths();
    const std::array<Point, 2> studs = {options_.stud[0].value_or(Point{lengths.input, 0}),
                                        options_.stud[1].value_or(Point{lengths.output, 0})};
    const auto ends = [studs](const Place& x) {
      return std::vector<RealEnds>{{{x[0], x[1]}, {LinkPoint::Link::input, studs[0]}},
                                   {{x[2], x[3]}, {LinkPoint::Link::output, studs[1]}}};
    };
    return best(ground, ground, ends, [&](std::size_t k, const Place&) {
      return CarriedPoint{k == 0 ? LoadedBody::input : LoadedBody::output, studs[k]};
    });
  }

  [[nodiscard]] std::optional<RealBalance> one() const {
    const CarriedFrame coupler = frame_of(LoadedBody::coupler, bars_, body());
    const CarriedFrame moving = frame_of(LoadedBody::body, bars_, body());
    const auto ends = [coupler, moving](const Place& x) {
      const Point at = moving.place({x[2], x[3]});
      return std::vector<RealEnds>{{{x[0], x[1]}, {LinkPoint::Link::coupler, (at - coupler.origin) / coupler.axis}}};
    };
    return best(options_.ground.value_or(room_of_pivots()), options_.body.value_or(room_on_body()), ends,
                [](std::size_t, const Place& x) {
                  return CarriedPoint{LoadedBody::body, {x[2], x[3]}};
                });
  }

  /// Largest of the hand over the travel under some springs, absolute.
  [[nodiscard]] double largest_hand(const std::vector<Spring>& springs) const {
    Loads loads = weights_;
    loads.springs = springs;
    const auto report = load_report(loads, bars_, poses_);
    const auto worst = report ? report->worst_of(ReadOut::hand_force) : std::nullopt;
    return worst ? worst->value : 0;
  }

 private:
  [[nodiscard]] const Pose& body() const { return poses_.front().pose; }

  [[nodiscard]] RealColumn column_of(const RealEnds& ends) const {
    RealColumn column;
    std::vector<double> lengths, rates;
    for (const BalanceStation& station : stations_) {
      const Point arm = station.place.position(ends.stud) - ends.ground;
      const double length = std::abs(arm);
      lengths.push_back(length);
      rates.push_back(length > 0 ? dot(arm, station.place.velocity(ends.stud)) / length : 0);
    }
    const double shortest = *std::min_element(lengths.begin(), lengths.end());
    column.free_length = options_.free_length.value_or(options_.free_share * shortest);
    for (std::size_t j = 0; j < lengths.size(); ++j)
      column.force.push_back(std::max(0.0, lengths[j] - column.free_length) * rates[j] * stations_[j].hand.per_power);
    return column;
  }

  [[nodiscard]] RatedSprings rated(const std::vector<RealEnds>& ends) const {
    RatedSprings springs;
    for (const RealEnds& each : ends) springs.columns.push_back(column_of(each));
    springs.rate = best_rates(forces_, springs.columns);
    springs.residual = forces_;
    for (std::size_t k = 0; k < ends.size(); ++k)
      for (std::size_t j = 0; j < forces_.size(); ++j)
        springs.residual[j] += springs.rate[k] * springs.columns[k].force[j];
    return springs;
  }

  /// First and second stud within their boxes.
  template <class EndsOf, class StudOf>
  [[nodiscard]] std::optional<RealBalance> best(const StudBox& first, const StudBox& second, const EndsOf& ends_of,
                                                const StudOf& stud_of) const {
    constexpr int along = 9;
    constexpr std::size_t starts = 16;
    const BoxDescent search({first.low.real(), first.low.imag(), second.low.real(), second.low.imag()},
                            {first.high.real(), first.high.imag(), second.high.real(), second.high.imag()}, size_,
                            [&](const Place& x) { return rated(ends_of(x)).residual; });
    std::optional<BoxDescent::Found> found;
    for (const BoxDescent::Found& start : search.best_of_grid(along, starts)) {
      const BoxDescent::Found here = search.descend(start.at);
      if (!found || here.square < found->square) found = here;
    }
    if (!found) return std::nullopt;
    const RatedSprings springs = rated(ends_of(found->at));
    RealBalance balance;
    for (std::size_t k = 0; k < springs.columns.size(); ++k) {
      if (!(springs.rate[k] > 0)) continue;
      const Point ground = ends_of(found->at)[k].ground;
      balance.springs.push_back(
          {"",
           1,
           {LoadedBody::ground, ground},
           stud_of(k, found->at),
           CoilSpring{springs.rate[k], springs.columns[k].free_length, CoilSpring::Acts::tension}});
    }
    if (balance.springs.empty()) return std::nullopt;
    balance.residual_hand_force = largest_hand(balance.springs);
    return balance;
  }

  static StudBox room_of(const std::vector<Point>& points) {
    StudBox box{points.front(), points.front()};
    for (const Point p : points) {
      box.low = {std::min(box.low.real(), p.real()), std::min(box.low.imag(), p.imag())};
      box.high = {std::max(box.high.real(), p.real()), std::max(box.high.imag(), p.imag())};
    }
    return box;
  }
  [[nodiscard]] StudBox room_of_pivots() const {
    std::vector<Point> points = {bars_.input_fixed, bars_.output_fixed};
    for (const BalanceStation& station : stations_)
      points.insert(points.end(), {station.place.bars.input_moving, station.place.bars.output_moving});
    return room_of(points);
  }
  [[nodiscard]] StudBox room_on_body() const {
    const CarriedFrame moving = frame_of(LoadedBody::body, bars_, body());
    std::vector<Point> points = {weights_.handle->point};
    if (weights_.body) points.push_back(weights_.body->center);
    for (const Point pivot : {bars_.input_moving, bars_.output_moving})
      points.push_back((pivot - moving.origin) / moving.axis);
    return room_of(points);
  }

  const Loads& weights_;
  const FourBar& bars_;
  std::span<const PrescribedPose> poses_;
  const RealBalanceOptions& options_;
  double size_;
  std::vector<BalanceStation> stations_;
  std::vector<double> forces_;
};

/// What is to be balanced: without springs, friction and inertia.
Loads weights_of(Loads loads, LoadCase of) {
  of.counts_for.clear();
  loads.cases = {std::move(of)};
  loads.springs.clear();
  loads.pins.reset();
  loads.rpm.reset();
  loads.motion.reset();
  loads.drive = LoadDrive::hand;
  return loads;
}

}  // namespace

FoundOrNot<RealBalances> real_balance(const Loads& loads, const LoadCase& of, const FourBar& bars,
                                      std::span<const PrescribedPose> poses, const RealBalanceOptions& options) {
  const Loads weights = weights_of(loads, of);
  if (auto notice = hand_missing(weights)) return {{}, *std::move(notice)};
  const auto travel = LoadTravel::of(bars, poses);
  if (!travel) return {{}, no_travel()};
  RealBalancing balancing(weights, bars, poses, options);
  if (auto notice = balancing.begin(*travel)) return {{}, *std::move(notice)};
  RealBalances found;
  found.free_share = options.free_length ? 0 : options.free_share;
  found.hand_force_without = balancing.largest_hand({});
  found.two = balancing.two();
  found.one = balancing.one();
  return {std::move(found), {}};
}

std::vector<Error> mistakes_in(const RealBalanceOptions& options) {
  std::vector<Error> found;
  const auto add = [&](const char* code, const char* what, const char* message) {
    found.push_back({code, std::string("balance.") + what, message, {}});
  };
  if (!(options.free_share >= 0 && options.free_share <= 1))
    add("bad_free_share", "free_share", "a share of the shortest length lies between 0 and 1");
  if (options.free_length && !(*options.free_length >= 0 && std::isfinite(*options.free_length)))
    add("bad_free_length", "free_length", "a length of 0 or more");
  const auto is_box = [](const std::optional<StudBox>& box) {
    return !box || (is_finite(box->low) && is_finite(box->high) && box->low.real() <= box->high.real() &&
                    box->low.imag() <= box->high.imag());
  };
  constexpr const char* of_box = "a box has finite sides, each from its lower to its upper end";
  if (!is_box(options.ground)) add("bad_stud_box", "ground", of_box);
  if (!is_box(options.body)) add("bad_stud_box", "body", of_box);
  if (options.between < 1) add("bad_between", "between", "1 step or more from position to position");
  return found;
}

}  // namespace linkwright
