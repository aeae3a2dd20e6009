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

static std::vector<MadeSpring> made(const std::vector<Spring>& springs) {
  std::vector<MadeSpring> all;
  for (const Spring& spring : springs) all.push_back({spring});
  return all;
}

static void fields(FieldVisitor& v, const RealBalance& of) {
  v.object({.name = "real_balance", .on_lines = true}, [&](FieldVisitor& to) {
    to.shown("springs", made(of.springs), forms::on_lines);
    to.shown(Field("residual_hand_force", "Largest over the travel, absolute, without friction, N."),
             of.residual_hand_force, forms::not_negative);
  });
}

static void fields(FieldVisitor& v, const RealBalances& of) {
  v.object(
      {.name = "real_springs",
       .about = "Coil springs with a free length that leave least to the hand, in squares over the travel: the best "
                "of many places, without a proof.",
       .on_lines = true},
      [&](FieldVisitor& to) {
        to.shown(Field("free_share", "Free length by the shortest over the travel; 0: it was given."), of.free_share,
                 forms::share);
        to.shown(Field("hand_force_without", "Without any spring, likewise."), of.hand_force_without,
                 forms::not_negative);
        to.shown(Field("two", "To input and output; null: no spring helps."), of.two);
        to.shown(Field("one", "To the body; null: no spring helps."), of.one);
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
        std::vector<Spring> two;
        for (const BalanceSpring& found : of.balance.two_springs) two.push_back(found.spring());
        to.shown(Field("two_springs", "At the input and at the output; none where nothing is to be balanced."),
                 made(two), forms::on_lines);
        const auto& one = of.balance.one_spring;
        const bool is_usable = one && !of.balance.why_not_one;
        to.shown(Field("one_spring", "To the line of the coupler's pivots; null: see why_not_one."),
                 is_usable ? std::optional(MadeSpring{one->spring()}) : std::nullopt);
        to.shown_if_any("why_not_one", of.balance.why_not_one);
        to.shown("counterweights", of.balance.counterweights, forms::on_lines);
        to.shown(Field("real_springs", "As near to it as springs with a free length come; null: see why_not_real."),
                 of.real);
        to.shown_if_any("why_not_real", of.why_not_real);
      });
}

}  // namespace linkwright
