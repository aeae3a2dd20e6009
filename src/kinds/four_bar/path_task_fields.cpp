#include "core/number_check.hpp"
#include "files/fields/forms.hpp"
#include "files/problem_fields.hpp"
#include "files/vocabulary.hpp"
#include "four_bar_kind.hpp"

namespace linkwright {

static void fields(FieldVisitor& v, PathDerivative& derivative) {
  const Object described = {"path_derivative",
                            "x and y in the user's length, input and theta in radians, per power of the parameter."};
  v.object(described, [&](FieldVisitor& to) {
    forms::coordinates(to, derivative.point);
    to.given(Field("input",
                   "Of the crank's angle, where that is given. Left out: the parameter is the turn of the crank in the "
                   "sense in which it passes the points."),
             derivative.input, forms::coordinate);
    to.given(Field("theta", "Of the coupler's angle, where that is given."), derivative.angle, forms::coordinate);
  });
}

static void fields(FieldVisitor& v, PathPoint& point) {
  const List list = {.what = {"path_derivatives", "a list of derivatives [{\"x\": …, \"y\": …}, …]"},
                     .most_read = 4,
                     .code = "derivative_count_of_point",
                     .sentence = "{count} derivatives are given; a point has at most {most}, remove the others"};
  const Object described = {"path_point", "A place that the point of the coupler is to pass, fixed frame."};
  v.object(described, [&](FieldVisitor& to) {
    forms::coordinates(to, point.point);
    to.given(Field("input_deg", "Angle of the crank there, counter-clockwise, from any datum."), point.input,
             forms::degrees);
    to.given(Field("theta_deg", "Or of the coupler, likewise."), point.angle, forms::degrees);
    to.optional(Field("derivatives",
                      "First, second, … derivatives by any parameter that increases along the task: the direction of "
                      "travel through the point, then its curvature, ….")
                    .written(!point.derivatives.empty()),
                point.derivatives, list);
    to.given(Field("tolerance", "Paths that pass near: how far from it, instead of the task's."), point.tolerance,
             forms::length);
    to.given(Field("weight", "Paths that pass near: of the squared distance; 1 where it is left out."), point.weight,
             Number{.least = 0, .most = largest_coordinate});
  });
}

static void fields(FieldVisitor& v, GroundPivots& pivots) {
  const Object described = {"path_ground_pivots", "Of both links, or of one of them."};
  v.object(described, [&](FieldVisitor& to) {
    to.given("input", pivots.input, forms::point);
    to.given("output", pivots.output, forms::point);
  });
}

namespace {

std::vector<Error> no_pivot_in(const GroundPivots& pivots) {
  if (pivots.count() > 0) return {};
  return {{"no_ground_pivot", "task.given.ground_pivots",
           "no ground pivot is given here; give \"input\": [x, y] or \"output\": [x, y], or leave \"given\" out"}};
}

void given_field(FieldVisitor& v, GroundPivots& pivots) {
  const Field field = Field("given",
                            "One ground pivot with five positions or with three at given angles of the crank; both "
                            "with three or five, or with three at given angles of the crank.")
                          .written(pivots.count() > 0);
  const Wanted missing = {"path_pivots_in_full", "a ground pivot {\"input\": [x, y]} or {\"output\": [x, y]}, or both"};
  v.member(field, false, [&](FieldVisitor& at) {
    at.object({.name = "path_given"}, [&](FieldVisitor& to) {
      to.required(Field("ground_pivots").missing(missing), pivots);
      to.check([&] { return no_pivot_in(pivots); });
    });
  });
}

}  // namespace

void fields(FieldVisitor& v, PathTask& task) {
  const Wanted missing = {"points_in_full", "a list of points {\"x\": …, \"y\": …, \"input_deg\": …}"};
  const List points = {
      .what = {"path_points", "a list of points"},
      .most_read = PathTask::most_points,
      .code = "path_point_count",
      .sentence = "{count} points are given; {most} are the most that a path is fitted to, remove the others",
      .on_lines = true};
  const Object described = {
      "path_task",
      "Path generation: a point of the coupler passes places in this order: four or five at given angles of the crank; "
      "three with angles of crank or coupler and two without, or four and one; or from given ground pivots, or from "
      "one that is searched for in options.box. A point counts as one position, and as one more for each of its "
      "derivatives. Or it passes as near as it can to three to 1000 points: where one of closed, tolerance and weight "
      "is "
      "given, or more than five points and nothing else.",
      true};
  v.object(described, [&](FieldVisitor& to) {
    to.constant("kind", "path");
    to.constant("mechanism", "four_bar");
    to.required(Field("points").missing(missing), task.points, points);
    given_field(to, task.pivots);
    to.optional(
        Field("closed",
              "The path passes near its points, from the last one on to the first, by an input that turns fully.")
            .written(task.closed),
        task.closed);
    to.given(Field("tolerance", "The path passes near its points: how far from each without a tolerance of its own."),
             task.tolerance, forms::length);
    to.given(Field("between", "The path passes near its points; between them it is free, or keeps to the polyline."),
             task.between, Names<PathBetween>{{PathBetween::free, PathBetween::polyline}});
    to.given(
        Field("map",
              "The path passes near its points; the map runs over the curves that were found, or over the places of "
              "the input's ground pivot, each with the nearest path from there."),
        task.map, Names<NearestMap>{{NearestMap::curves, NearestMap::pivots}});
  });
}

}  // namespace linkwright
