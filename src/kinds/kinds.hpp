#pragma once

// The kinds of tasks. A new one has a folder here with a header like these, and its line.
#include "kinds/four_bar/four_bar_kind.hpp"
#include "kinds/six_bar/six_bar_kind.hpp"
#include "kinds/spherical/spherical_kind.hpp"
#include "kinds/straight_line/straight_line_kind.hpp"

// What is asked of a kind, by overloads for its task, its answer and its linkage. It is visited, never asked what it
// is: what it does not serve is an error of the compiler. (·) solve/of_all_kinds.hpp says what holds where it says
// nothing.
//
// Found, by solve() and sessions:
//   begin_answer           what is known of a task without mistakes before linkages are looked for
//   solve_of_kind          everything found for it; what driving does not confirm is still among it
//   leave_out_unconfirmed  takes that out of the lists
//   warn_of_locking        where the best stand at a dead point
//   output_of              how a linkage listed lies in the positions of the task; nothing where it does not
// Of a session, while its problem changes:
//   serves (·)             what was known of the task with one problem's requirements and options serves another's
//   with_defaults          requirements with the defaults of the kind filled in
//   no_map, nothing_on_map why there is no map, and why all of it is degenerate
//   links_along, marks_of (·)                 the grounded links along an axis, and marks on their curve
//   shown_axis             an axis as it is shown; `before`: as it was shown last, or null
//   coordinates_of (·)     of the rows or columns that are asked for; window_sets_axes (·)
//   live_samples, halo_samples, samples_for_best (·)   how many are soon computed
//   boxes_missed, write_property, generators_of (·)    what only some kinds have
//   solution_at            the linkage at a place, with `verify` driven through; nothing where there is none
//   describe               adds reason, travel and positions to what was picked; null: there is no linkage
//   meets_exactly (·)      where cells are estimated
//   residual_of            user's unit
// In files:
//   fields                 of its task; visit_curve, visit_dyads, visit_linkages, visit_pairs, visit_freed,
//   visit_search:
//                          what stands in these members of a result, of those that it has
//   list_columns           of its linkages in a table
//   label_of, short_label_of, axis_label      in words
//   is_mapped              a result has a map
//   stored                 a linkage of an answer as a file carries it, without title and unit
// Drawn:
//   draw_sheet             as draw_answer(const Problem&, const Answer&)
