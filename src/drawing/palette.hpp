#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "linkwright/mechanism/linkage_type.hpp"

namespace linkwright::palette {

// The light theme of the workbench, whose colours for types keep their distance in every kind of colour vision.
inline constexpr std::string_view paper = "#FFFFFF", page = "#F3F5F7";
inline constexpr std::string_view ink = "#101418", ink2 = "#48525E", ink3 = "#5A6470";
inline constexpr std::string_view line = "#D5DBE1", grid = "#EDF0F3";
inline constexpr std::string_view accent = "#1F5FBF", good = "#16703F", bad = "#B42318";
inline constexpr std::string_view input = "#0B57D0", output = "#B3470B", body = "#37424E";
inline constexpr std::string_view link_2 = "#0F766E", link_5 = "#9D174D";  // of six-bars; link 4 as the output
inline constexpr std::string_view curve = "#7A8694";

inline constexpr std::uint32_t defect = 0xDDE2E7, hatch = 0xC6CED6, white = 0xFFFFFF;

/// By LinkageType. A triple rocker of the sphere has the colour of one of the plane: no map shows both.
inline constexpr std::array<std::uint32_t, linkage_type_count> types = {
    0x3B63C1, 0x27D0FC, 0x3BA26E, 0xEBD122, 0x652962, 0xEC5112, 0xC684A8, 0x4B4B2B, 0x101418, 0xFFFFFF, 0x652962};

/// `share` of a colour on another, share in [0, 1].
[[nodiscard]] inline std::uint32_t mixed(std::uint32_t color, std::uint32_t ground, double share) {
  std::uint32_t result = 0;
  for (int shift = 0; shift < 24; shift += 8) {
    const double c = (color >> shift) & 255, g = (ground >> shift) & 255;
    result |= static_cast<std::uint32_t>(std::lround(g + (c - g) * share)) << shift;
  }
  return result;
}

}  // namespace linkwright::palette
