#pragma once

#include <string>
#include <vector>

#include "linkwright/algebra/point.hpp"
#include "linkwright/core/progress.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/region/requirements.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "linkwright/synthesis/options.hpp"
#include "linkwright/synthesis/task.hpp"

namespace linkwright {

/// What is asked: a task, what the user wants of its linkages, and how to look for them. Angles in radians.
struct Problem {
  Task task;
  Requirements requirements;
  SynthesisOptions options;
  std::string title;
  std::string length_unit;     ///< echoed, never converted
  std::vector<Point> outline;  ///< of the guided body, in the moving frame: for pictures; empty when absent
  std::string
      view;  ///< all else of the workbench's own object, as JSON text on one line, never read; empty when absent
};

/// All linkages that do the problem's task, and the best of them. A map that is cancelled is an error; a search that is
/// cancelled answers with the best so far.
[[nodiscard]] Result<Answer> solve(const Problem& problem, const Progress& progress = {});

}  // namespace linkwright
