#include "load_travel.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/pose_visits.hpp"

namespace linkwright {
namespace {

/// Steps from position to position in which angles are followed, and in which ways are measured.
constexpr int followed = 8, measured = 24;

double near(double angle, double known) { return known + wrap_signed(angle - known); }

}  // namespace

std::optional<LoadTravel> LoadTravel::of(const FourBar& bars, std::span<const PrescribedPose> poses) {
  const PoseVisits visits = pose_visits(bars, poses);
  if (visits.four_bars.empty()) return std::nullopt;
  if (!std::all_of(visits.on_branch.begin(), visits.on_branch.end(), [](bool is) { return is; })) return std::nullopt;
  LoadTravel travel;
  travel.first_ = bars;
  travel.lengths_ = bars.lengths();
  travel.start_ = configuration_of(bars);
  travel.assembly_ = visits.assembly.front();
  travel.sense_ = visits.counter_clockwise ? 1 : -1;
  travel.twist_sense_ = travel.assembly_ == Assembly::positive ? -travel.sense_ : travel.sense_;
  travel.positions_ = visits.turn;
  if (!std::is_sorted(travel.positions_.begin(), travel.positions_.end()) || travel.positions_.front() != 0)
    return std::nullopt;
  travel.positions_.front() = 0;  // not −0
  travel.anchor();
  return travel;
}

void LoadTravel::anchor() {
  Anchor last{0, start_.coupler_angle, start_.output_angle};
  for (const double turn : stations(followed)) {
    const auto there = assemble(lengths_, start_.input_angle + sense_ * turn, assembly_);
    if (!there) continue;
    last = {turn, near(there->coupler_angle, last.coupler), near(there->output_angle, last.output)};
    anchors_.push_back(last);
  }
}

std::optional<LoadedPlace> LoadTravel::at(double turn) const {
  auto there = assemble(lengths_, start_.input_angle + sense_ * turn, assembly_);
  if (!there || anchors_.empty()) return std::nullopt;
  const auto after = std::lower_bound(anchors_.begin(), anchors_.end(), turn,
                                      [](const Anchor& anchor, double wanted) { return anchor.turn < wanted; });
  const Anchor& known = after == anchors_.end() ? anchors_.back() : *after;
  LoadedPlace place;
  place.bars = turn == 0 ? first_ : placed(first_, *there);
  place.turn = {sense_ * turn, near(there->coupler_angle, known.coupler) - start_.coupler_angle,
                near(there->output_angle, known.output) - start_.output_angle};
  if (turn == 0) place.turn = {};
  place.whole = end();
  place.share = place.whole > 0 ? turn / place.whole : 0;
  const auto twist = twist_of(place.bars, twist_sense_);
  if (!twist) return std::nullopt;
  place.twist = *twist;
  return place;
}

std::vector<double> LoadTravel::stations(int between) const {
  std::vector<double> turns = {positions_.front()};
  for (std::size_t k = 1; k < positions_.size(); ++k) {
    const double from = positions_[k - 1], to = positions_[k];
    if (!(to > from)) continue;
    for (int i = 1; i < between; ++i) turns.push_back(from + (to - from) * i / between);
    turns.push_back(to);
  }
  return turns;
}

namespace {

/// The twist as a unit vector, and the handle's way.
struct Heading {
  std::array<double, 3> twist{};
  Point handle{};
};

Heading heading_of(const LoadedPlace& place, const std::optional<LinkPoint>& handle) {
  const auto& [input, coupler, output] = place.twist;
  const double norm = std::sqrt(input * input + coupler * coupler + output * output);
  Heading found{{input / norm, coupler / norm, output / norm}, {}};
  const Point velocity = handle ? place.velocity(*handle) : Point{};
  if (std::abs(velocity) > 0) found.handle = velocity / std::abs(velocity);
  return found;
}

bool turns_fast(const Heading& a, const Heading& b) {
  constexpr double much = 0.15;
  double square = std::norm(a.handle - b.handle);
  for (std::size_t k = 0; k < 3; ++k) square += (a.twist[k] - b.twist[k]) * (a.twist[k] - b.twist[k]);
  return square > much * much;
}

}  // namespace

std::vector<double> LoadTravel::close_stations(int between, const std::optional<LinkPoint>& handle) const {
  constexpr int most_halvings = 14;
  const std::vector<double> wide = stations(between);
  std::vector<double> close = {wide.front()};
  struct Stop {
    double turn;
    std::optional<Heading> heading;
  };
  const auto stop = [&](double turn) {
    const auto place = at(turn);
    return Stop{turn, place ? std::optional(heading_of(*place, handle)) : std::nullopt};
  };
  const auto add = [&](auto&& self, const Stop& from, const Stop& to, int halvings) -> void {
    if (halvings > 0 && from.heading && to.heading && turns_fast(*from.heading, *to.heading)) {
      const Stop middle = stop((from.turn + to.turn) / 2);
      self(self, from, middle, halvings - 1);
      self(self, middle, to, halvings - 1);
    } else {
      close.push_back(to.turn);
    }
  };
  Stop last = stop(wide.front());
  for (std::size_t k = 1; k < wide.size(); ++k) {
    const Stop next = stop(wide[k]);
    add(add, last, next, most_halvings);
    last = next;
  }
  return close;
}

HandlePath::HandlePath(const LoadTravel& travel, const LinkPoint& handle)
    : travel_(travel), handle_(handle), turns_(travel.stations(measured)) {
  for (std::size_t k = 0; k < turns_.size(); ++k)
    ways_.push_back(k == 0 ? 0 : ways_.back() + between(turns_[k - 1], turns_[k]));
}

double HandlePath::speed(double turn) const {
  const auto place = travel_.at(turn);
  return place && place->twist.input != 0 ? std::abs(place->velocity(handle_) / place->twist.input) : 0;
}

/// Simpson's rule.
double HandlePath::between(double from, double to) const {
  return (to - from) / 6 * (speed(from) + 4 * speed((from + to) / 2) + speed(to));
}

double HandlePath::way(double turn) const {
  const auto after = std::upper_bound(turns_.begin(), turns_.end(), turn);
  const auto k = static_cast<std::size_t>(after - turns_.begin());
  return k == 0 ? 0 : ways_[k - 1] + between(turns_[k - 1], turn);
}

double HandlePath::share(double turn) const {
  if (turn >= travel_.end()) return 1;
  return length() > 0 ? std::clamp(way(turn) / length(), 0.0, 1.0) : 0;
}

}  // namespace linkwright
