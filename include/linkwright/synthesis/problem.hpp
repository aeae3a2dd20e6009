#pragma once

#include <string>

#include "linkwright/region/requirements.hpp"
#include "linkwright/synthesis/options.hpp"
#include "linkwright/synthesis/task.hpp"

namespace linkwright {

/// What is asked: a task, what the user wants of its linkages, and how to look for them. Angles in radians.
struct Problem {
  std::string title;
  std::string length_unit;  ///< echoed, never converted
  Task task;
  Requirements requirements;
  SynthesisOptions options;
  std::string view;  ///< the workbench's own object, kept as JSON text on one line and never read; empty when absent
};

}  // namespace linkwright
