#pragma once

// The kinds that files know. A new one has a folder beside four_bar/ and six_bar/ with the functions of their headers.
#include "files/four_bar/four_bar_kind.hpp"
#include "files/six_bar/six_bar_kind.hpp"
#include "files/spherical/spherical_kind.hpp"
#include "files/straight_line/straight_line_kind.hpp"
