#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/files/text_file.hpp"
#include "linkwright/loads/balance.hpp"
#include "linkwright/loads/load_report.hpp"
#include "linkwright/loads/loads.hpp"
#include "linkwright/loads/real_balance.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright {

/// What holds a linkage at rest anywhere, by the weights and steady forces of one case.
struct BalanceOfCase {
  std::string name;
  Balance balance;
  std::optional<RealBalances> real;    ///< as near to it as springs with a free length come, of listed_loads() only
  std::optional<Notice> why_not_real;  ///< there is none
};

/// One linkage listed, what acts on it, what that does, and its curves.
struct LoadStudy {
  std::string title, length_unit;
  Loads loads;  ///< as used
  LoadReport report;
  std::vector<std::vector<LoadStation>> curves;  ///< by case
  std::optional<BalanceOfCase> balance;          ///< of the first case; nothing where a force turns with its link
};
/// Of the linkage number `place` of the answer, from 0; it has a report. `between`: steps from position to position.
[[nodiscard]] LoadStudy load_study(const Problem& problem, const Answer& answer, std::size_t place, int between = 24);

/// What is asked otherwise than the problem says: one of its cases alone.
struct LoadChanges {
  std::optional<std::string> only_case;
  RealBalanceOptions real_springs;  ///< how such a balance is sought
};

/// What loads do to one linkage of a result file: `text`; `linkage` from 1. The caller's mistakes: those of
/// read_listed_problem(), a problem without loads, a case that it does not have, a linkage that does not get through
/// its positions.
[[nodiscard]] Result<LoadStudy> listed_loads(std::string_view text, int linkage, const LoadChanges& changes = {});

/// The loads of a result file's problem; nothing where it has none or the file is no result.
[[nodiscard]] std::optional<Loads> loads_of_result(std::string_view text);

/// As JSON text: `loads` as in a problem file, `report` as in a result's linkages, `balance` with springs as in a
/// problem file.
[[nodiscard]] std::string write_load_study(const LoadStudy& study);

/// A row a station and case: turns, the handle's way, forces, energy, torque, springs, pins while opening.
[[nodiscard]] std::string load_table(const LoadStudy& study);

/// As a picture (SVG, 1000 × 800): the forces of opening and closing over the body's turn, a line a case with the band
/// of all, and the lengths of the springs within their strokes.
[[nodiscard]] std::string draw_loads(const LoadStudy& study);

}  // namespace linkwright
