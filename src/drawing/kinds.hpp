#pragma once

#include "drawing/four_bar/linkage_figure.hpp"
#include "drawing/six_bar/six_bar_figure.hpp"
#include "drawing/spherical/spherical_figure.hpp"
#include "drawing/straight_line/straight_line_figure.hpp"

// The kinds that are drawn: each gives draw_sheet(). A new one has a folder beside four_bar/ and six_bar/, and its line
// here.
