#pragma once

#include "drawing/four_bar/four_bar_drawing.hpp"
#include "drawing/six_bar/six_bar_drawing.hpp"
#include "drawing/spherical/spherical_drawing.hpp"
#include "drawing/spherical/spherical_function_drawing.hpp"
#include "drawing/straight_line/straight_line_drawing.hpp"

// The kinds that are drawn: each gives draw_sheet(). A new one has a folder beside four_bar/ and six_bar/, and its line
// here.
