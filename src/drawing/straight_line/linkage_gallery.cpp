#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "drawing/palette.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/number_text.hpp"
#include "straight_line_figure.hpp"

namespace linkwright {
namespace {

constexpr double least_width = 240, least_height = 190, caption_height = 40, gap = 14;

struct GalleryGrid {
  std::size_t columns = 1, rows = 1;
};

// As large as so many pictures can be.
GalleryGrid grid_of(const PixelBox& box, std::size_t count) {
  const auto fitting = [](double room, double least) {
    return std::max<std::size_t>(1, static_cast<std::size_t>((room + gap) / (least + gap)));
  };
  const std::size_t most_rows = fitting(box.height, least_height), most_columns = fitting(box.width, least_width);
  const std::size_t rows = std::min(count, most_rows);
  return {std::min((count + rows - 1) / rows, most_columns), rows};
}

void draw_entry(SvgCanvas& svg, const PixelBox& box, const StraightLineAnswer& answer, std::size_t index,
                std::string_view unit) {
  const StraightLineSolution& found = answer.linkages[index];
  const LineMeasure measure = answer.options.line.measure;
  const PixelBox picture{box.left, box.top + caption_height, box.width, box.height - caption_height};
  // Of a search each is of a case of its own.
  const std::string kind = answer.search ? std::string(name(found.task.given)) : std::string(label(found.type));
  svg.text({box.left, box.top + 12}, fitted(fmt::format("{}  {}", index + 1, kind), 12, 0.92 * box.width),
           {.size = 12, .weight = 650});
  const std::string words =
      fmt::format("{}{}{} within ±{}, {} points", significant_text(found.counted(measure).length(), 4),
                  unit.empty() ? "" : " ", unit, significant_text(found.deviation, 3), found.contact.points);
  svg.text({box.left, box.top + 29}, fitted(words, 11.5, box.width), {.size = 11.5, .color = palette::ink2});
  draw_small_scene(svg, picture, line_scene(found, measure));
  svg.rectangle(picture.corner(), picture.width, picture.height, "fill=\"none\" " + stroke(palette::line, 1));
}

}  // namespace

void draw_gallery(SvgCanvas& svg, const PixelBox& box, const StraightLineAnswer& answer, std::string_view length_unit) {
  if (answer.linkages.empty()) return;
  const auto [columns, rows] = grid_of(box, answer.linkages.size());
  const auto share = [](double room, std::size_t parts) {
    return (room - gap * static_cast<double>(parts - 1)) / static_cast<double>(parts);
  };
  const double width = share(box.width, columns), height = share(box.height, rows);
  for (std::size_t i = 0; i < std::min(columns * rows, answer.linkages.size()); ++i) {
    const auto row = static_cast<double>(i / columns), column = static_cast<double>(i % columns);
    draw_entry(svg, {box.left + column * (width + gap), box.top + row * (height + gap), width, height}, answer, i,
               length_unit);
  }
}

}  // namespace linkwright
