#include "files/fields/forms.hpp"
#include "files/problem_fields.hpp"
#include "four_bar_kind.hpp"

namespace linkwright {

void fields(FieldVisitor& v, FunctionTask& task) {
  const Object described = {"function_task",
                            "Function generation: the input link turns the output link through four or five pairs of "
                            "angles in this order. A pair counts as one position, and as one more for each of its "
                            "derivatives.",
                            true};
  v.object(described, [&](FieldVisitor& to) {
    to.constant("kind", "function");
    to.constant("mechanism", "four_bar");
    pair_fields(to, task);
    to.member(Field("ground_pivots", "Default: (0, 0) and (1, 0)."), false,
              [&](FieldVisitor& at) { forms::ground_pivots(at, task.input_pivot, task.output_pivot); });
    free_fields(to, task);
    to.check([&] { return mistakes_in(task); });
  });
}

}  // namespace linkwright
