#include "linkwright/sweep/sweep_plan.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "linkwright/files/problem_file.hpp"
#include "plan_base.hpp"

namespace linkwright {
namespace {

// Whole numbers stay whole in JSON text; a negative zero is none.
Json json_number(double value) {
  const bool is_whole = value == std::floor(value) && std::abs(value) < static_cast<double>(SweepPlan::most_samples);
  if (is_whole && !(value == 0 && std::signbit(value))) return static_cast<std::int64_t>(value);
  return value;
}

}  // namespace

double SweepVariable::at(double share) const {
  if (whole) return std::min(from + std::floor(share * (to - from + 1)), to);
  if (share >= 1) return to;
  // to / from may be more than a double holds.
  return logarithmic ? std::pow(from, 1 - share) * std::pow(to, share) : from + share * (to - from);
}

double SweepVariable::on_grid(std::int64_t k) const {
  if (!values.empty()) return values[static_cast<std::size_t>(k)];
  if (count < 2) return from;
  const double share = static_cast<double>(k) / static_cast<double>(count - 1);
  if (whole) return from + std::round(share * (to - from));
  return at(share);
}

std::vector<double> SweepPlan::values(std::int64_t sample) const {
  if (sampling_ == Sampling::list) return rows_[static_cast<std::size_t>(sample)];
  std::vector<double> values(variables_.size());
  if (sampling_ == Sampling::grid) {
    for (std::size_t k = variables_.size(); k-- > 0; sample /= variables_[k].count)
      values[k] = variables_[k].on_grid(sample % variables_[k].count);
    return values;
  }
  const std::vector<double> point = sequence_->point(static_cast<std::uint64_t>(sample));
  for (std::size_t k = 0; k < point.size(); ++k) values[k] = variables_[k].at(point[k]);
  return values;
}

std::string SweepPlan::problem_text(std::int64_t sample) const {
  Json problem = base_->problem;
  const std::vector<double> now = values(sample);
  for (std::size_t k = 0; k < variables_.size(); ++k)
    for (const VariedNumber& number : variables_[k].numbers)
      problem[JsonPointer(number.pointer)] = json_number(number.scale * now[k] + number.offset);
  return problem.dump();
}

// JSON has no infinity: what overflows would read as if it were not given.
Result<Problem> SweepPlan::problem(std::int64_t sample) const {
  const std::vector<double> now = values(sample);
  for (std::size_t k = 0; k < variables_.size(); ++k)
    for (const VariedNumber& number : variables_[k].numbers)
      if (!std::isfinite(number.scale * now[k] + number.offset))
        return Error{"number_overflows",
                     number.pointer,
                     fmt::format("{} times the scale {}, plus {}, is more than a double holds", now[k], number.scale,
                                 number.offset),
                     {{"given", now[k]}}};
  return read_problem(problem_text(sample));
}

// Small ones, so that little is lost and many can share; not so small that a sweep of 2⁵³ samples cannot remember them.
std::int64_t SweepPlan::block_samples() const {
  constexpr std::int64_t usual_blocks = 4096, most_blocks = std::int64_t{1} << 22, most_usual = 64;
  return std::max(std::clamp<std::int64_t>(samples_ / usual_blocks, 1, most_usual),
                  (samples_ + most_blocks - 1) / most_blocks);
}

}  // namespace linkwright
