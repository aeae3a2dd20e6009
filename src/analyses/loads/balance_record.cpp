#include <vector>

#include "files/fields/result_forms.hpp"
#include "files/result_fields.hpp"
#include "loads_analysis.hpp"

namespace linkwright {

static void fields(FieldVisitor& v, const CounterWeight& weight) {
  v.object({.name = "counterweight"}, [&](FieldVisitor& to) {
    to.shown(Field("mass", "kg."), weight.mass, forms::not_negative);
    to.shown("at", CarriedPoint{weight.on, weight.at});
  });
}

namespace {

/// As in problem files.
struct MadeSpring {
  Spring spring;
};

}  // namespace

static void fields(FieldVisitor& v, const MadeSpring& made) {
  v.described_in("problem.schema.json#/$defs/spring", [&](FieldVisitor& in) {
    Spring spring = made.spring;
    fields(in, spring);
  });
}

void fields(FieldVisitor& v, const BalanceOfCase& of) {
  v.object(
      {.name = "balance",
       .about = "What holds the linkage at rest anywhere, in place of its springs: as springs of no free length in "
                "the form of problem files, or as counterweights.",
       .on_lines = true},
      [&](FieldVisitor& to) {
        to.shown(Field("case", "It goes by the weights and steady forces of this one."), of.name);
        std::vector<MadeSpring> two;
        for (const BalanceSpring& found : of.balance.two_springs) two.push_back({found.spring()});
        to.shown(Field("two_springs", "At the input and at the output; none where nothing is to be balanced."), two,
                 forms::on_lines);
        const auto& one = of.balance.one_spring;
        const bool is_usable = one && !of.balance.why_not_one;
        to.shown(Field("one_spring", "To the line of the coupler's pivots; null: see why_not_one."),
                 is_usable ? std::optional(MadeSpring{one->spring()}) : std::nullopt);
        to.shown_if_any("why_not_one", of.balance.why_not_one);
        to.shown("counterweights", of.balance.counterweights, forms::on_lines);
      });
}

}  // namespace linkwright
