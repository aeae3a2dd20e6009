#include "files/fields/forms.hpp"
#include "files/problem_fields.hpp"
#include "tolerance_analysis.hpp"

namespace linkwright {
namespace {

constexpr Number half_tolerance = {.least = 0, .most = largest_coordinate, .null = 0.0, .name = "half_tolerance"};
constexpr Number half_angle_tolerance = {
    .least = 0, .most = 90, .is_angle = true, .null = 0.0, .name = "half_angle_tolerance"};

void length_of_each(FieldVisitor& v, LengthTolerances& length) {
  v.object({.name = "length_tolerances"}, [&](FieldVisitor& to) {
    to.optional("input", length.input, half_tolerance);
    to.optional("coupler", length.coupler, half_tolerance);
    to.optional("output", length.output, half_tolerance);
    to.optional(Field("ground_pivots", "Of each coordinate."), length.ground_pivots, half_tolerance);
    to.optional(Field("point", "Of the body's origin in the coupler, each coordinate."), length.point, half_tolerance);
  });
}

void length_of_all(FieldVisitor& v, LengthTolerances& length) {
  double all = length.input;
  v.number(all, half_tolerance);
  length = LengthTolerances::all(all);
}

}  // namespace

static void fields(FieldVisitor& v, LengthTolerances& length) {
  const std::array<Shape, 2> shapes = {Shape{JsonType::object, [&](FieldVisitor& to) { length_of_each(to, length); }},
                                       Shape{JsonType::number, [&](FieldVisitor& to) { length_of_all(to, length); }}};
  v.shapes(length == LengthTolerances::all(length.input) ? 1 : 0, shapes, std::nullopt);
}

static void fields(FieldVisitor& v, ToleranceLimit& limit) {
  using Kind = ToleranceLimit::Kind;
  const auto alternative = [&](const char* key, Kind kind, const Number& number) {
    return Alternative{{key}, {}, [&limit, key, kind, number](FieldVisitor& to) {
                         limit.kind = kind;
                         to.required(key, limit.value, number);
                       }};
  };
  const Number angle = {.least = 0, .most = 180, .above = true, .is_angle = true};
  const std::array alternatives = {alternative("position", Kind::position, forms::positive),
                                   alternative("angle_deg", Kind::angle, angle),
                                   alternative("deviation", Kind::deviation, forms::positive)};
  constexpr std::string_view sentence = "a limit is exactly one of \"position\", \"angle_deg\" and \"deviation\"";
  v.object({.name = "tolerance_limit"}, [&](FieldVisitor& to) {
    to.one_of(static_cast<std::size_t>(limit.kind), alternatives, {"one_limit", sentence, "one_limit", sentence});
  });
}

namespace {

struct ToleranceCost {
  double exponent = 0;
};

}  // namespace

static void fields(FieldVisitor& v, ToleranceCost& cost) {
  v.object({.name = "tolerance_cost"},
           [&](FieldVisitor& to) { to.required("exponent", cost.exponent, forms::positive); });
}

namespace {

void visit_cost(FieldVisitor& v, std::optional<double>& exponent) {
  std::optional<ToleranceCost> cost;
  if (exponent) cost = ToleranceCost{*exponent};
  v.optional(Field("cost", "A tolerance T costs T^-exponent: asks for the tolerances of least cost."), cost);
  exponent = cost ? std::optional(cost->exponent) : std::nullopt;
}

const Names<ToleranceDistribution> distributions = {
    {ToleranceDistribution::normal, ToleranceDistribution::truncated_normal, ToleranceDistribution::uniform}};

void visit_lengths(FieldVisitor& v, LengthTolerances& length) {
  const Field field("length",
                    "Of all lengths of a planar linkage, or of each kind: of six-bars those of the driver, of the "
                    "other links on the ground, of all others.");
  std::optional<LengthTolerances> given;
  if (length != LengthTolerances{}) given = length;
  v.optional(field, given);
  length = given.value_or(LengthTolerances{});
}

}  // namespace

void fields(FieldVisitor& v, Tolerances& t) {
  constexpr Whole samples = {least_samples, most_samples}, seeds = {0, largest_seed, largest_seed + 1};
  const Object described = {
      "tolerances", "How exactly linkages are made: half tolerances, all independent, in the user's unit.", true};
  v.object(described, [&](FieldVisitor& to) {
    visit_lengths(to, t.length);
    to.optional(Field("clearance", "Radius by which a pin can move in its hole.").written(t.clearance > 0), t.clearance,
                half_tolerance);
    to.optional(Field("driver_deg", "Of the input's angle.").written(t.driver > 0), t.driver, half_angle_tolerance);
    to.optional(Field("link_angle_deg", "Of each arc of a spherical linkage.").written(t.link_angle > 0), t.link_angle,
                half_angle_tolerance);
    to.optional(Field("distribution",
                      "Normal with half tolerance = 3 standard deviations, the same cut off at the tolerances, or "
                      "even."),
                t.distribution, distributions);
    to.optional(Field("turning_length",
                      "By which an angle is multiplied to be weighed against a distance: 0 leaves angles out; the "
                      "characteristic length of the task where it is not given."),
                t.turning_length, Number{.least = 0});
    to.optional(Field("limit", "The error up to which a linkage is good, at all positions."), t.limit);
    visit_cost(to, t.cost_exponent);
    to.optional(Field("samples", "How many linkages are sampled."), t.samples, samples);
    to.optional(Field("seed", "Of the samples: the same one gives the same answer."), t.seed, seeds);
    to.check([&] { return mistakes_in(t); });
  });
}

}  // namespace linkwright
