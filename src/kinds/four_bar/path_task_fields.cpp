#include "files/fields/forms.hpp"
#include "files/problem_fields.hpp"
#include "files/vocabulary.hpp"
#include "four_bar_kind.hpp"

namespace linkwright {

static void fields(FieldVisitor& v, PathDerivative& derivative) {
  const Object described = {"path_derivative",
                            "x and y in the user's length, input in radians of the crank, per power of the parameter."};
  v.object(described, [&](FieldVisitor& to) {
    forms::coordinates(to, derivative.point);
    to.given(
        Field("input", "Left out: the parameter is the turn of the crank in the sense in which it passes the points."),
        derivative.input, forms::coordinate);
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
    to.optional(Field("derivatives",
                      "First, second, … derivatives by any parameter that increases along the task: the direction of "
                      "travel through the point, then its curvature, ….")
                    .written(!point.derivatives.empty()),
                point.derivatives, list);
  });
}

void fields(FieldVisitor& v, PathTask& task) {
  const Wanted missing = {"points_in_full", "a list of points {\"x\": …, \"y\": …, \"input_deg\": …}"};
  const List points = {
      .what = {"path_points", "a list of points"},
      .most_read = most_positions_looked_at,
      .code = "path_point_count",
      .sentence = "{count} points are given; five positions are the most that can be solved, remove the others",
      .on_lines = true};
  const Object described = {"path_task",
                            "Path generation: a point of the coupler passes four or five places at given angles of "
                            "the crank, in this order. A point counts as one position, and as one more for each of its "
                            "derivatives.",
                            true};
  v.object(described, [&](FieldVisitor& to) {
    to.constant("kind", "path");
    to.constant("mechanism", "four_bar");
    to.required(Field("points").missing(missing), task.points, points);
    to.check([&] { return mistakes_in(task); });
  });
}

}  // namespace linkwright
