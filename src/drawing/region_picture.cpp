#include "region_picture.hpp"

#include <algorithm>
#include <cmath>

#include "palette.hpp"

namespace linkwright {
namespace {

constexpr double washed_share = 0.3;
constexpr std::size_t hatch_period = 13;  // pixels between hatch lines, across
constexpr std::uint8_t transparent = 0, paper = 1, defect = 2, full_types = 5,
                       washed_types = full_types + static_cast<std::uint8_t>(linkage_type_count);

std::vector<std::uint32_t> picture_colors() {
  std::vector<std::uint32_t> colors = {0, palette::white, palette::defect,
                                       palette::mixed(palette::hatch, palette::defect, 0.5), palette::hatch};
  for (const std::uint32_t color : palette::types) colors.push_back(color);
  for (const std::uint32_t color : palette::types) {
    colors.push_back(palette::mixed(color, palette::white, washed_share));
  }
  return colors;
}

/// How much of a hatch line covers a pixel: 0, 1 (its edge) or 2.
int hatching(std::size_t x, std::size_t y) {
  const std::size_t place = (x + y) % hatch_period;
  if (place == 1 || place == 2) return 2;
  return place == 0 || place == 3 ? 1 : 0;
}

/// The sample of each pixel along a scale; −1 in a gap.
std::vector<int> samples_of_pixels(const RegionScale& scale, int pixels_per_px) {
  std::vector<int> samples(static_cast<std::size_t>(std::lround(scale.length() * pixels_per_px)));
  for (std::size_t pixel = 0; pixel < samples.size(); ++pixel) {
    samples[pixel] = scale.sample_at((static_cast<double>(pixel) + 0.5) / pixels_per_px);
  }
  return samples;
}

}  // namespace

PngImage region_picture(const Findings& found, const LinkageFamily& family, const RegionScale& input,
                        const RegionScale& output, int pixels_per_px) {
  const RegionMap& region = found.region;
  std::vector<FailureBits> failures(region.rows() * region.columns());
  filter_of(family, region, found.requirements).failures_of_all(failures);
  const std::vector<int> rows = samples_of_pixels(input, pixels_per_px);
  const std::vector<int> columns = samples_of_pixels(output, pixels_per_px);
  // Where each cell can be named its type is shown, defect or not.
  const bool is_board = family.axis(Side::input).is_discrete() && family.axis(Side::output).is_discrete();
  PngImage image{columns.size(), rows.size(), picture_colors(), {}};
  image.pixels.reserve(rows.size() * columns.size());
  const auto pixel = [&](std::size_t x, std::size_t y) -> std::uint8_t {
    const int row = rows[rows.size() - 1 - y], column = columns[x];
    if (row < 0 || column < 0) return transparent;
    const auto i = static_cast<std::size_t>(row), k = static_cast<std::size_t>(column);
    const std::size_t cell = region.index(i, k);
    if (region.type(cell) == LinkageType::degenerate) return paper;
    const bool has_defect = !region.defects(cell).none();
    if (has_defect && is_board)
      return static_cast<std::uint8_t>((hatching(x, y) == 2 ? full_types : washed_types) + region.types()[cell]);
    if (has_defect && found.requirements.no_defects) return static_cast<std::uint8_t>(defect + hatching(x, y));
    const bool is_line = has_defect && hatching(x, y) > 0;  // defects are allowed: lines over the type's colour
    if (failures[cell] != 0) return is_line ? paper : static_cast<std::uint8_t>(washed_types + region.types()[cell]);
    return static_cast<std::uint8_t>((is_line ? washed_types : full_types) + region.types()[cell]);
  };
  for (std::size_t y = 0; y < rows.size(); ++y) {
    for (std::size_t x = 0; x < columns.size(); ++x) image.pixels.push_back(pixel(x, y));
  }
  return image;
}

}  // namespace linkwright
