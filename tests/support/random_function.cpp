#include "support/random_function.hpp"

#include "linkwright/core/angle.hpp"
#include "support/random_task.hpp"

namespace linkwright::testing {

std::vector<AnglePair> random_pairs(std::mt19937_64& random, const std::vector<int>& multiplicities) {
  std::vector<AnglePair> pairs;
  for (const int multiplicity : multiplicities) {
    AnglePair pair{uniform(random, -3, 3), uniform(random, -3, 3), {}};
    for (int m = 1; m < multiplicity; ++m) pair.derivatives.push_back({uniform(random, -2, 2), uniform(random, -2, 2)});
    pairs.push_back(pair);
  }
  return pairs;
}

std::vector<AnglePair> gentle_pairs(std::mt19937_64& random, int count) {
  std::vector<AnglePair> pairs = {{uniform(random, -3, 3), uniform(random, -3, 3), {}}};
  while (static_cast<int>(pairs.size()) < count)
    pairs.push_back(
        {pairs.back().input + uniform(random, 0.1, 0.7), pairs.back().output + uniform(random, -0.5, 0.5), {}});
  return pairs;
}

const std::vector<std::vector<int>>& four_position_patterns() {
  static const std::vector<std::vector<int>> patterns = [] {
    std::vector<std::vector<int>> all = {{1, 1, 1, 1}};
    all.insert(all.end(), mixed_patterns().begin(), mixed_patterns().end());
    return all;
  }();
  return patterns;
}

AnglePair pair_after(const AnglePair& pair, double t) {
  AnglePair moved{pair.input, pair.output, {}};
  double power = 1;
  for (std::size_t m = 0; m < pair.derivatives.size(); ++m) {
    power *= t / static_cast<double>(m + 1);
    moved.input += power * pair.derivatives[m].input;
    moved.output += power * pair.derivatives[m].output;
  }
  return moved;
}

FunctionTask named_task(const std::string& expression, std::array<double, 2> x, double input_deg, double output_deg) {
  FunctionTask task;
  task.function.emplace();
  task.function->expression = expression;
  task.function->x = x;
  task.function->input_range = {0, radians(input_deg)};
  task.function->output_range = {0, radians(output_deg)};
  task.pairs = precision_pairs(*task.function);
  return task;
}

}  // namespace linkwright::testing
