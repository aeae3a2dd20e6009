#include "files/fields/forms.hpp"
#include "problem_fields.hpp"

namespace linkwright {
namespace {

Names<Objective> all_objectives() { return {{objectives().begin(), objectives().end()}}; }

}  // namespace

static void fields(FieldVisitor& v, MapWindow& window) {
  std::array<std::array<double, 2>, 2> intervals = {window.input, window.output};
  visit(v, intervals,
        List{.what = {"intervals", "a pair of intervals [[low, high], [low, high]]"}, .most = 2, .is_of_length = true},
        forms::interval);
  window = {intervals[0], intervals[1]};
}

static void fields(FieldVisitor& v, MapPoint& place) {
  std::array<double, 2> coordinates = {place.input, place.output};
  v.pair(coordinates, {.form = "[u, v]"});
  place = {coordinates[0], coordinates[1]};
}

static void fields(FieldVisitor& v, std::array<Objective, 2>& pareto) {
  const List two = {.what = {"two_objectives", "two objectives"},
                    .least = 2,
                    .most = 2,
                    .length_code = "pareto_two",
                    .length_sentence =
                        "a front is of two objectives: [\"min_transmission_angle\", "
                        "\"tolerance_error\"]"};
  visit(v, pareto, two, all_objectives());
}

namespace {

/// A grounded link of a start.
struct StartLink {
  Point &center, &circle;
};
void fields(FieldVisitor& v, StartLink& link) {
  v.object({.name = "start_link"}, [&](FieldVisitor& to) {
    to.required("center_point", link.center, forms::point);
    to.required("circle_point", link.circle, forms::point);
  });
}

}  // namespace

static void fields(FieldVisitor& v, Pose& pose) {
  v.object({.name = "start_pose"}, [&](FieldVisitor& to) {
    forms::coordinates(to, pose.origin);
    to.required("theta_deg", pose.angle, forms::degrees);
  });
}

void fields(FieldVisitor& v, FitStart& start) {
  StartLink input{start.bars.input_fixed, start.bars.input_moving};
  StartLink output{start.bars.output_fixed, start.bars.output_moving};
  v.object({.name = "fit_start"}, [&](FieldVisitor& to) {
    const Wanted link = {"side_link", "a grounded link {\"center_point\": [x, y], \"circle_point\": [x, y]}"};
    to.required(Field("input").missing(link), input);
    to.required(Field("output").missing(link), output);
    to.given(Field("point", "Of a path: that of the coupler."), start.point, forms::point);
    to.given(Field("pose", "Past poses: of the body that it carries; without it that is in the first of them."),
             start.pose);
  });
}

static void fields(FieldVisitor& v, FitWishes& fit) {
  const Names<FitEffort> efforts = {{FitEffort::quick, FitEffort::standard, FitEffort::deep}};
  const Names<FitMeasure> kinds = {{FitMeasure::least_squares, FitMeasure::least_largest}};
  v.object({.name = "fit"}, [&](FieldVisitor& to) {
    to.optional(Field("effort", "How many places and starts are tried."), fit.effort, efforts);
    to.optional(Field("measure", "What is least: the squares of the distances, or the largest distance."), fit.measure,
                kinds);
    to.optional(Field("grashof_margin",
                      "Closed paths: by how much the longest and the shortest link are shorter than the other two "
                      "together, at least, over the diagonal of the points; null: any linkage.")
                    .null_for_none(),
                fit.grashof_margin, Number{.least = 0, .most = 1, .below = true});
    to.optional(Field("starts",
                      "Linkages to begin with beside those that are found, each as it lies at the first of the points "
                      "or poses.")
                    .written(!fit.starts.empty()),
                fit.starts, List{.what = {"linkages", "a list of linkages"}, .most = FitWishes::most_starts});
  });
}

namespace {

void of_lines(FieldVisitor& v, LineMeasuring& line, bool is_written) {
  const Names<LineMeasure> measures = {{LineMeasure::tangent, LineMeasure::strip}};
  v.optional(Field("deviation",
                   "Straight lines: half the width of the strip in which the usable length counts; null: 1/10 000 of "
                   "the longest link or arm.")
                 .null_for_none()
                 .written(is_written),
             line.deviation, forms::positive);
  v.optional(Field("stroke",
                   "Straight lines: the stroke over which deviations, transmission angle and velocity are judged, "
                   "half of it either way; what does not reach it is not listed. Null: none, or that of the case.")
                 .null_for_none()
                 .written(is_written),
             line.stroke, forms::positive);
  v.optional(Field("measure", "Straight lines: usable by the line itself, or by the best strip beside it.")
                 .written(is_written),
             line.measure, measures);
}

void of_searches(FieldVisitor& v, SynthesisOptions& options) {
  const SynthesisOptions usual;
  constexpr std::string_view of_box =
      "Six-bars without a chain: where all pivots lie in position 1. Paths of five points and nothing else given: "
      "where the input's ground pivot is searched for.";
  v.optional(Field("box", of_box), options.box);
  v.optional(Field("seed", "Of the chains, or places, tried.").written(options.seed != usual.seed), options.seed,
             Whole{0, SynthesisOptions::max_seed});
  v.optional(Field("effort", "How many chains, or arms of a path, are tried.").written(options.effort != usual.effort),
             options.effort, Whole{1, SynthesisOptions::max_effort});
}

void of_places(FieldVisitor& v, SynthesisOptions& options) {
  v.optional(Field("window",
                   "The part of the region to sample: [[low, high], [low, high]] of the curve coordinates of input and "
                   "output."),
             options.window);
  v.optional(Field("at",
                   "A place [u, v] of the region by the coordinates of its axes: the result then lists the linkage "
                   "there, whether it meets the requirements or not, and no other. Not where six-bars are searched for "
                   "without a chain."),
             options.at);
}

}  // namespace

void fields(FieldVisitor& v, OptionsOf& of) {
  SynthesisOptions& options = of.options;
  const Names<Spacing> spacings = {{Spacing::coordinate, Spacing::arc_length}};
  v.object({.name = "options", .on_lines = true}, [&](FieldVisitor& to) {
    to.optional(Field("region_samples", "N of the N × N region."), options.region_samples,
                Whole{SynthesisOptions::min_samples, SynthesisOptions::max_samples});
    to.optional(
        Field("spacing", "Even steps of the curve coordinate, or of the length run by circle and centre point."),
        options.spacing, spacings);
    to.optional(Field("objective",
                      "What the best linkages have: the largest least transmission angle, the smallest link ratio, the "
                      "smallest longest link, the smallest structural error of a named function, of spherical linkages "
                      "the largest least link angle, or with tolerances the smallest error by them or the largest "
                      "yield."),
                options.objective, all_objectives());
    to.optional(Field("pareto",
                      "Two objectives of the map: linkages that no other beats in both are listed, instead of the best "
                      "by one."),
                options.pareto);
    to.optional(Field("best", "How many linkages the result lists."), options.best,
                Whole{0, SynthesisOptions::max_best});
    of_lines(to, options.line, of.of_line);
    to.optional(Field("fit", "Paths that pass near points, and linkages that pass near poses.")
                    .written(options.fit != FitWishes{}),
                options.fit);
    of_searches(to, options);
    of_places(to, options);
    to.check([&] { return mistakes_in(options); });
  });
}

}  // namespace linkwright
