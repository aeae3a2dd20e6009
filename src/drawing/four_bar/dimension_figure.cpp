#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "drawing/palette.hpp"
#include "linkage_figure.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {
namespace {

constexpr double text_size = 13, lift = 16;  // px from the link's middle line to the text's

struct Bar {
  Point from, to;  ///< px
  double length = 0;
  std::string_view color;
};

/// Where a length may stand: the middle of the text, and the text's direction, left to right.
struct Place {
  Point middle, along;
};

double distance(Point p, const Bar& bar) {
  const Point way = bar.to - bar.from;
  const double square = std::norm(way);
  const double share = square > 0 ? std::clamp(dot(p - bar.from, way) / square, 0.0, 1.0) : 0;
  return std::abs(p - bar.from - share * way);
}

std::vector<Point> points_of_text(const Place& place, double width) {
  std::vector<Point> points;
  for (const double share : {-0.5, -0.25, 0.0, 0.25, 0.5}) points.push_back(place.middle + share * width * place.along);
  return points;
}

/// Finds a place for each length in turn.
class DimensionPlacer {
 public:
  explicit DimensionPlacer(std::vector<Bar> bars) : bars_(std::move(bars)) {
    for (const Bar& bar : bars_) obstacles_.insert(obstacles_.end(), {bar.from, bar.to});
    constexpr Point ground_symbol{0, 14};
    obstacles_.push_back(bars_[0].from + ground_symbol);
    obstacles_.push_back(bars_[0].to + ground_symbol);
  }

  Place place(std::size_t index, double width) {
    const Bar& bar = bars_[index];
    Point along = (bar.to - bar.from) / std::abs(bar.to - bar.from);
    if (along.real() < -1e-9 || (std::abs(along.real()) <= 1e-9 && along.imag() > 0)) along = -along;
    const Point across = Point{0, 1} * along;
    Place best{};
    double best_room = -1;
    for (const double share : {0.5, 0.38, 0.62, 0.25, 0.75}) {
      for (const double side : {-1.0, 1.0}) {
        const Place candidate{bar.from + share * (bar.to - bar.from) + side * lift * across, along};
        const double found = room(candidate, width, index);
        if (found <= best_room + 1) continue;  // a later place must be clearly better
        best = candidate;
        best_room = found;
      }
    }
    for (const Point p : points_of_text(best, width)) obstacles_.push_back(p);
    return best;
  }

 private:
  /// px to the nearest thing in the way, more than enough being enough.
  [[nodiscard]] double room(const Place& place, double width, std::size_t own) const {
    constexpr double enough = 20;
    double nearest = enough;
    for (const Point p : points_of_text(place, width)) {
      for (const Point obstacle : obstacles_) nearest = std::min(nearest, std::abs(p - obstacle));
      for (std::size_t i = 0; i < bars_.size(); ++i) {
        if (i != own) nearest = std::min(nearest, distance(p, bars_[i]));
      }
    }
    return nearest;
  }

  std::vector<Bar> bars_;
  std::vector<Point> obstacles_;
};

}  // namespace

void draw_dimensions(SvgCanvas& svg, const PlaneWindow& window, const FourBar& four_bar) {
  const LinkLengths lengths = four_bar.lengths();
  const int decimals = length_decimals(lengths.longest());
  const Point input_fixed = window.to_px(four_bar.input_fixed), input_moving = window.to_px(four_bar.input_moving);
  const Point output_fixed = window.to_px(four_bar.output_fixed), output_moving = window.to_px(four_bar.output_moving);
  const std::vector<Bar> bars = {{input_fixed, output_fixed, lengths.ground, palette::ink3},
                                 {input_fixed, input_moving, lengths.input, palette::input},
                                 {input_moving, output_moving, lengths.coupler, palette::body},
                                 {output_fixed, output_moving, lengths.output, palette::output}};
  DimensionPlacer placer(bars);
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const std::string text = rounded_text(bars[i].length, decimals);
    const Place place = placer.place(i, text_width(text, text_size));
    const Point down = Point{0, 1} * place.along;
    svg.text(place.middle + 0.36 * text_size * down, text,
             {.size = text_size,
              .color = bars[i].color,
              .anchor = "middle",
              .weight = 650,
              .turn = degrees(std::arg(place.along)),
              .halo = palette::paper});
  }
}

}  // namespace linkwright
