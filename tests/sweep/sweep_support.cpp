#include "sweep_support.hpp"

#include <cstdio>
#include <cstdlib>

namespace linkwright::sweep_support {

std::string sweep_text(const std::string& sampling, const std::string& vary, const std::string& keep) {
  return R"({"linkwright": 1, "problem": {"linkwright": 1, "length_unit": "mm", "task": {"kind": "function",
    "mechanism": "four_bar", "function": {"expression": "log", "x": [1, 4], "input_range_deg": [0, 60],
    "output_range_deg": [0, -45], "points": 5, "spacing": "chebyshev"},
    "ground_pivots": {"input": [0, 0], "output": [60, 0]}},
    "requirements": {"min_transmission_angle_deg": 40, "max_length": 120}},
    "sampling": )" +
         sampling + R"(, "vary": )" + vary + (keep.empty() ? "" : R"(, "keep": )" + keep) + "}";
}

SweepPlan plan_of(const std::string& text) {
  auto plan = SweepPlan::read(text, {});
  if (plan) return *std::move(plan);
  for (const Error& error : plan.errors()) std::fprintf(stderr, "%s: %s\n", error.place.c_str(), error.message.c_str());
  std::abort();
}

SweepPlan small_plan() {
  return plan_of(sweep_text(R"({"method": "sobol", "samples": 40})",
                            R"([{"name": "reach", "at": "/task/function/output_range_deg/1", "from": -90, "to": 0},
                                {"name": "longest", "at": "/requirements/max_length", "from": -20, "to": 130}])"));
}

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "linkwright-sweep-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) std::abort();
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code error;
  std::filesystem::remove_all(path_, error);
}

}  // namespace linkwright::sweep_support
