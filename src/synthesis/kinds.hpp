#pragma once

#include "pair_answer.hpp"
#include "six_bar_answer.hpp"
#include "straight_line_answer.hpp"

// The kinds that are solved: each gives solve_of_kind(), leave_out_unconfirmed() and warn_of_locking(). A new one has a
// header, and its line here.
