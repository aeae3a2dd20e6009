#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "drawing/number_rows.hpp"
#include "drawing/palette.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/number_text.hpp"
#include "six_bar_figure.hpp"

namespace linkwright {
namespace {

int decimals_of(const SixBar& six_bar) {
  double longest = 0;
  for (const SixBarLength& length : six_bar.lengths()) longest = std::max(longest, length.length);
  return length_decimals(longest);
}

std::string angle_text(double angle) { return fmt::format("{}°", rounded_text(degrees(angle), 1)); }

/// "0-2": what a link joins, or what a body of the chain is.
std::string body_name(const SixBar& six_bar, int body) {
  constexpr std::array<std::string_view, 4> names = {"ground", "driver", "floating link", "guided body"};
  if (body < 4) return fmt::format("{}  {}", body, names.at(static_cast<std::size_t>(body)));
  return fmt::format("{}  added link {}", body, text(six_bar.added()[static_cast<std::size_t>(body - 4)]));
}

}  // namespace

std::string drive_text(const SixBarDriveReport& drive) {
  if (drive.sense == DriveSense::none) return "–";
  return fmt::format("{} {}", angle_text(drive.sweep), label(drive.sense));
}

void draw_hinge_rows(SvgCanvas& svg, Point corner, double width, const SixBar& six_bar, std::size_t from,
                     std::size_t to) {
  const int decimals = decimals_of(six_bar);
  NumberRows rows(svg, corner, width);
  for (std::size_t joint = from; joint < std::min<std::size_t>(to, SixBar::joint_count); ++joint) {
    const SixBarJoint& hinge = six_bar.joints[joint];
    rows.row(
        fmt::format("{} ({}-{})", joint_name(joint), hinge.bodies[0], hinge.bodies[1]),
        fmt::format("{}, {}", rounded_text(hinge.point.real(), decimals), rounded_text(hinge.point.imag(), decimals)),
        body_color(std::max(hinge.bodies[0], hinge.bodies[1])));
  }
}

void draw_length_rows(SvgCanvas& svg, Point corner, double width, const SixBar& six_bar, std::size_t from,
                      std::size_t to) {
  const int decimals = decimals_of(six_bar);
  const std::vector<SixBarLength> lengths = six_bar.lengths();
  NumberRows rows(svg, corner, width);
  for (std::size_t i = from; i < std::min(to, lengths.size()); ++i)
    rows.row(
        fmt::format("{}: {}-{}", lengths[i].body, joint_name(lengths[i].joints[0]), joint_name(lengths[i].joints[1])),
        rounded_text(lengths[i].length, decimals), body_color(lengths[i].body));
}

void draw_body_rows(SvgCanvas& svg, Point corner, double width, const SixBar& six_bar) {
  NumberRows rows(svg, corner, width);
  for (int body = 0; body < SixBar::bodies; ++body) {
    std::string hinges;
    for (const std::size_t joint : six_bar.joints_of(body))
      hinges += fmt::format("{}{}", hinges.empty() ? "" : ", ", joint_name(joint));
    rows.row(body_name(six_bar, body), hinges, body_color(body));
  }
}

void draw_six_bar_table(SvgCanvas& svg, Point corner, double width, const SixBarAnswer& answer) {
  constexpr double row_height = 23, size = 13;
  constexpr std::size_t max_rows = 10;
  // Right ends of the columns as shares of the width.
  constexpr std::array<double, 5> ends = {0.04, 0.56, 0.70, 0.83, 1};
  const auto put_row = [&](std::size_t row, const std::array<std::string, 5>& cells, std::string_view color,
                           int weight) {
    for (std::size_t i = 0; i < cells.size(); ++i)
      svg.text(corner + Point{ends[i] * width, row_height * static_cast<double>(row)}, cells[i],
               {.size = size, .color = color, .anchor = "end", .weight = weight});
  };
  put_row(0, {"#", "input rotation", "γ", "ratio", "longest"}, palette::ink2, 650);
  for (std::size_t i = 0; i < std::min(answer.linkages.size(), max_rows); ++i) {
    const SixBarRating& rating = answer.linkages[i].rating;
    const bool driven = rating.drive.sense != DriveSense::none;
    put_row(i + 1,
            {fmt::format("{}", i + 1), drive_text(rating.drive),
             driven ? angle_text(rating.min_transmission_angle()) : "–", rounded_text(rating.shape.link_ratio, 2),
             rounded_text(rating.shape.longest, length_decimals(rating.shape.longest))},
            palette::ink, 400);
  }
}

}  // namespace linkwright
