#include "place_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace linkwright {
namespace {

constexpr std::size_t dimensions = 4;

bool is_better_place(const StudPlace& a, const StudPlace& b) {
  return a.value.force != b.value.force ? a.value.force < b.value.force : a.studs < b.studs;
}

}  // namespace

StudRoom::StudRoom(const SpringWanted& wanted)
    : low{wanted.ground.low.real(), wanted.ground.low.imag(), wanted.body.low.real(), wanted.body.low.imag()} {
  const StudCoordinates high = {wanted.ground.high.real(), wanted.ground.high.imag(), wanted.body.high.real(),
                                wanted.body.high.imag()};
  for (std::size_t k = 0; k < dimensions; ++k) size[k] = high[k] - low[k];
}

StudCoordinates StudRoom::at(const StudCoordinates& shares) const {
  StudCoordinates studs;
  for (std::size_t k = 0; k < dimensions; ++k) studs[k] = low[k] + size[k] * shares[k];
  return studs;
}

GridLook look_at_grid(const PlaceModel& model, const StudRoom& room, int along, std::size_t most,
                      const Progress& progress) {
  std::array<int, dimensions> counts{};
  for (std::size_t k = 0; k < dimensions; ++k) counts[k] = room.size[k] > 0 ? along : 1;
  GridLook look;
  PlaceModel::Room arrays(model);
  const auto keep_best = [&](std::size_t count) {
    std::sort(look.best.begin(), look.best.end(), is_better_place);
    if (look.best.size() > count) look.best.resize(count);
  };
  std::array<int, dimensions> at{};
  for (at[0] = 0; at[0] < counts[0]; ++at[0])
    for (at[1] = 0; at[1] < counts[1]; ++at[1]) {
      if (progress.is_cancelled()) return keep_best(most), look;
      for (at[2] = 0; at[2] < counts[2]; ++at[2])
        for (at[3] = 0; at[3] < counts[3]; ++at[3]) {
          StudCoordinates shares;
          for (std::size_t k = 0; k < dimensions; ++k) shares[k] = (at[k] + 0.5) / counts[k];
          const StudCoordinates studs = room.at(shares);
          ++look.places;
          const PlaceModel::Value value = model.value(studs, arrays);
          if (std::isfinite(value.force)) look.best.push_back({studs, value});
        }
      if (look.best.size() > 64 * most) keep_best(most);
    }
  keep_best(most);
  return look;
}

namespace {

/// Nelder and Mead's simplex of the sides of a room that have a size; places outside count where the room ends.
class Polish {
 public:
  Polish(const PlaceModel& model, const StudRoom& room, const StudPlace& start)
      : model_(model), room_(room), arrays_(model), best_(start) {
    for (std::size_t k = 0; k < dimensions; ++k)
      if (room.size[k] > 0) sides_.push_back(k);
  }

  StudPlace run(std::size_t most_looks) {
    constexpr double smallest = 1e-7;  // of the room
    if (sides_.empty()) return best_;
    for (double step = 0.05; step > smallest && looks_ < most_looks;) {
      const double before = best_.value.force;
      descend(step, most_looks);
      const bool gained = best_.value.force < before - 1e-7 * std::abs(before);
      step *= gained ? 0.5 : 0.12;
      turn_ = !turn_;
    }
    return best_;
  }

 private:
  using Corner = StudPlace;

  [[nodiscard]] Corner look(StudCoordinates studs) {
    for (std::size_t k = 0; k < dimensions; ++k)
      studs[k] = std::clamp(studs[k], room_.low[k], room_.low[k] + room_.size[k]);
    ++looks_;
    const Corner found{studs, model_.value(studs, arrays_)};
    if (found.value.force < best_.value.force) best_ = found;
    return found;
  }

  void descend(double step, std::size_t most_looks) {
    std::vector<Corner> simplex = {best_};
    for (const std::size_t side : sides_) {
      StudCoordinates studs = best_.studs;
      const double by = step * room_.size[side];
      const bool upwards =
          studs[side] - by < room_.low[side] || (turn_ && studs[side] + by <= room_.low[side] + room_.size[side]);
      studs[side] += upwards ? by : -by;
      simplex.push_back(look(studs));
    }
    const std::size_t stop = std::min(most_looks, looks_ + 120 * sides_.size());
    while (looks_ < stop) {
      std::sort(simplex.begin(), simplex.end(), is_better_place);
      if (is_small(simplex, 0.01 * step)) return;
      move(simplex);
    }
  }

  [[nodiscard]] bool is_small(const std::vector<Corner>& simplex, double share) const {
    for (const std::size_t side : sides_)
      if (std::abs(simplex.back().studs[side] - simplex.front().studs[side]) > share * room_.size[side]) return false;
    return true;
  }

  /// The worst corner through the middle of the others.
  void move(std::vector<Corner>& simplex) {
    const std::size_t others = simplex.size() - 1;
    StudCoordinates middle{};
    for (std::size_t i = 0; i < others; ++i)
      for (std::size_t k = 0; k < dimensions; ++k) middle[k] += simplex[i].studs[k] / static_cast<double>(others);
    Corner& worst = simplex.back();
    const auto beyond = [&](double times) {
      StudCoordinates studs;
      for (std::size_t k = 0; k < dimensions; ++k) studs[k] = middle[k] + times * (middle[k] - worst.studs[k]);
      return look(studs);
    };
    const Corner mirrored = beyond(1);
    if (is_better_place(mirrored, simplex.front())) {
      const Corner farther = beyond(2);
      worst = is_better_place(farther, mirrored) ? farther : mirrored;
      return;
    }
    if (is_better_place(mirrored, simplex[others - 1])) {
      worst = mirrored;
      return;
    }
    const Corner nearer = beyond(is_better_place(mirrored, worst) ? 0.5 : -0.5);
    if (is_better_place(nearer, worst) && is_better_place(nearer, mirrored)) {
      worst = nearer;
      return;
    }
    for (std::size_t i = 1; i < simplex.size(); ++i) {
      StudCoordinates studs;
      for (std::size_t k = 0; k < dimensions; ++k) studs[k] = (simplex[0].studs[k] + simplex[i].studs[k]) / 2;
      simplex[i] = look(studs);
    }
  }

  const PlaceModel& model_;
  const StudRoom& room_;
  PlaceModel::Room arrays_;
  StudPlace best_;
  std::vector<std::size_t> sides_;
  std::size_t looks_ = 0;
  bool turn_ = false;
};

}  // namespace

StudPlace polished(const PlaceModel& model, const StudRoom& room, StudPlace start, std::size_t most_looks) {
  return Polish(model, room, start).run(most_looks);
}

namespace {

/// A part of the room: halved `level` times along each side, and which of these parts it is.
struct StudBoxes {
  std::array<std::uint32_t, dimensions> index{};
  std::array<std::uint8_t, dimensions> level{};
  std::uint8_t widest = 0;  ///< the side that is best halved
  float bound = 0;
};

/// Not above.
float rounded_down(double value) {
  const auto near = static_cast<float>(value);
  return near > value ? std::nextafter(near, -std::numeric_limits<float>::infinity()) : near;
}

class BranchAndBound {
 public:
  BranchAndBound(const PlaceModel& model, const StudRoom& room, const StudPlace& best,
                 const SpringSearchOptions& options, const Progress& progress, std::size_t places)
      : model_(model), room_(room), options_(options), progress_(progress), places_(places), arrays_(model) {
    search_.best = best;
  }

  BoundedSearch run() {
    constexpr std::size_t looked_at_once = 256;
    visit({});
    while (!heap_.empty() && !is_proven() && search_.boxes < options_.most_boxes && !progress_.is_cancelled()) {
      for (std::size_t k = 0; k < looked_at_once && !heap_.empty() && !is_proven(); ++k) halve(pop());
      tell();
    }
    search_.ended = is_proven() || (heap_.empty() && kept_away_ >= target());
    search_.lower_bound = lower_bound();
    return search_;
  }

 private:
  static bool is_higher(const StudBoxes& a, const StudBoxes& b) { return a.bound > b.bound; }

  [[nodiscard]] double lower_bound() const {
    return heap_.empty() ? kept_away_ : std::min<double>(heap_.front().bound, kept_away_);
  }
  [[nodiscard]] double target() const { return (1 - options_.proof) * search_.best.value.force; }
  [[nodiscard]] bool is_proven() const { return !heap_.empty() && heap_.front().bound >= target(); }

  StudBoxes pop() {
    std::pop_heap(heap_.begin(), heap_.end(), is_higher);
    const StudBoxes box = heap_.back();
    heap_.pop_back();
    return box;
  }

  void sides_of(const StudBoxes& box, StudCoordinates& middle, StudCoordinates& half) const {
    constexpr double rounding = 1 + 1e-9;
    for (std::size_t k = 0; k < dimensions; ++k) {
      const double part = std::ldexp(1.0, -box.level[k]);
      middle[k] = room_.low[k] + room_.size[k] * (box.index[k] + 0.5) * part;
      half[k] = 0.5 * room_.size[k] * part * rounding;
    }
  }

  void halve(const StudBoxes& box) {
    StudCoordinates middle, half;
    sides_of(box, middle, half);
    const std::size_t side = side_to_halve(box, half);
    if (box.level[side] >= most_levels) {  // smaller than any spring is made
      kept_away_ = std::min<double>(kept_away_, box.bound);
      return;
    }
    for (const std::uint32_t part : {0U, 1U}) {
      StudBoxes child = box;
      ++child.level[side];
      child.index[side] = 2 * box.index[side] + part;
      visit(child);
    }
  }

  [[nodiscard]] static std::size_t side_to_halve(const StudBoxes& box, const StudCoordinates& half) {
    if (half[box.widest] > 0 && box.level[box.widest] < most_levels) return box.widest;
    return static_cast<std::size_t>(std::max_element(half.begin(), half.end()) - half.begin());
  }

  void visit(StudBoxes box) {
    StudCoordinates middle, half;
    sides_of(box, middle, half);
    ++search_.boxes;
    const PlaceModel::Bound bound = model_.bound(middle, half, arrays_, target());
    if (bound.force == PlaceModel::nowhere) return;
    const double rounding = 1e-9 * (1 + std::abs(bound.force));
    box.bound = std::max(box.bound, rounded_down(bound.force - rounding));
    box.widest = static_cast<std::uint8_t>(bound.widest);
    if (search_.boxes % looked_into == 0 || !std::isfinite(search_.best.value.force)) look_into(middle);
    if (box.bound >= target()) {
      kept_away_ = std::min<double>(kept_away_, box.bound);
      return;
    }
    heap_.push_back(box);
    std::push_heap(heap_.begin(), heap_.end(), is_higher);
  }

  void look_into(const StudCoordinates& middle) {
    const PlaceModel::Value value = model_.value(middle, arrays_);
    if (value.force < search_.best.value.force) search_.best = polished(model_, room_, {middle, value}, 2000);
  }

  void tell() {
    if (search_.boxes < told_at_) return;
    told_at_ = search_.boxes + 8192;
    if (options_.told) options_.told({search_.best.value.force, lower_bound(), places_, search_.boxes});
    const double wanted = target();
    if (std::isfinite(wanted) && wanted > 0) progress_(0.2 + 0.8 * std::clamp(lower_bound() / wanted, 0.0, 1.0));
  }

  static constexpr std::uint8_t most_levels = 30;
  static constexpr std::size_t looked_into = 4;  ///< of so many boxes one, for a better place
  const PlaceModel& model_;
  const StudRoom& room_;
  const SpringSearchOptions& options_;
  const Progress& progress_;
  std::size_t places_, told_at_ = 0;
  PlaceModel::Room arrays_;
  std::vector<StudBoxes> heap_;
  double kept_away_ = PlaceModel::nowhere;  ///< least bound of the boxes that were not looked into
  BoundedSearch search_;
};

}  // namespace

BoundedSearch prove(const PlaceModel& model, const StudRoom& room, const StudPlace& best,
                    const SpringSearchOptions& options, const Progress& progress, std::size_t places) {
  return BranchAndBound(model, room, best, options, progress, places).run();
}

}  // namespace linkwright
