#include "path_record.hpp"

#include <cmath>

#include "files/fields/result_forms.hpp"
#include "files/linkage_fields.hpp"
#include "files/path_fit_fields.hpp"
#include "four_bar_kind.hpp"
#include "linkwright/planar/path_crank.hpp"

namespace linkwright {
namespace {

std::vector<double> degrees_of_all(const std::vector<double>& radians) {
  std::vector<double> all;
  for (const double each : radians) all.push_back(degrees(each));
  return all;
}

/// A grounded link of the cognate, whose pivots may have run to infinity.
void link_field(FieldVisitor& v, std::string_view key, Point center, Point circle) {
  const auto if_finite = [](Point p) { return std::isfinite(std::norm(p)) ? std::optional(p) : std::nullopt; };
  v.member(key, true, [&](FieldVisitor& at) {
    at.object({.name = "cognate_link"}, [&](FieldVisitor& to) {
      to.shown("center_point", if_finite(center), forms::shown_point);
      to.shown("circle_point", if_finite(circle), forms::shown_point);
    });
  });
}

void cognate_field(FieldVisitor& v, const std::optional<TimedPath>& of) {
  const TimedPath none;
  const TimedPath& path = of ? *of : none;
  const FourBar bars = path.cognate.value_or(FourBar{});
  const Object described = {"timed_cognate",
                            "The other four-bar with the same path and timing; fixed frame, position 1. null: at "
                            "infinity."};
  v.member(Field("cognate", "Paths at given angles of the crank.").written(of && of->cognate), false,
           [&](FieldVisitor& at) {
             at.object(described, [&](FieldVisitor& to) {
               link_field(to, "input", bars.input_fixed, bars.input_moving);
               link_field(to, "output", bars.output_fixed, bars.output_moving);
               to.shown(Field("size_ratio", "Its crank over this one."), path.cognate_size, forms::not_negative);
             });
           });
}

/// A crank as one builds it, and as a dyad.
struct CrankRecord {
  const BurmesterPoint& point;
  const WorkingFrame& frame;
};

void fields(FieldVisitor& v, const CrankRecord& of) {
  const Dyad user = of.frame.to_user(crank_link(of.point.dyad));
  const auto center = of.frame.finite_user_point(user.center), circle = of.frame.finite_user_point(user.circle);
  const Point first = of.frame.origin;
  const auto distance = [](const std::optional<Point>& a, const std::optional<Point>& b) {
    return a && b ? std::optional(std::abs(*a - *b)) : std::nullopt;
  };
  const Object described = {"crank", "Fixed frame, position 1; null: at infinity.", true};
  v.object(described, [&](FieldVisitor& to) {
    to.shown("center_point", center, forms::shown_point);
    to.shown("moving_pivot", circle, forms::shown_point);
    to.shown("crank_length", distance(center, circle), forms::not_negative);
    to.shown(Field("point_arm", "From its moving pivot to the point."), distance(circle, first), forms::not_negative);
  });
}

void realisations_field(FieldVisitor& v, const FittedPath& path) {
  const Field field("realisations",
                    "The four-bars that trace the same path (Roberts' theorem), this one first; at angles of the crank "
                    "those whose cranks turn alike. Fixed frame, position 1, the point the same in each.");
  v.member(field, true, [&](FieldVisitor& to) {
    visit_each(to, List{.what = ""}, path.realisations, [](FieldVisitor& each, const FourBar& bars) {
      each.object({.name = "realisation"}, [&](FieldVisitor& of) {
        link_field(of, "input", bars.input_fixed, bars.input_moving);
        link_field(of, "output", bars.output_fixed, bars.output_moving);
      });
    });
  });
}

void fit_field(FieldVisitor& v, const std::optional<FittedPath>& fit) {
  const FittedPath path = fit.value_or(FittedPath{});
  std::vector<std::int64_t> outside;
  for (const std::size_t point : path.outside) outside.push_back(static_cast<std::int64_t>(point) + 1);
  v.member(Field("fit", "Paths that pass near points: how near, in their turn.").written(fit.has_value()), false,
           [&](FieldVisitor& at) {
             at.object({.name = "path_fit", .on_lines = true}, [&](FieldVisitor& to) {
               to.shown(Field("timed", "Distances are those at the angles of the crank that are given."), path.timed);
               error_field(to, path.error);
               to.shown(Field("within_tolerance", "At all points that have one."), path.outside.empty());
               to.shown(Field("outside", "Points that are farther off than their tolerance, from 1."), outside,
                        forms::on_a_line, forms::count);
               to.shown(
                   Field("at_length_limit", "Its longest link is as long as is allowed: longer ones may come nearer."),
                   path.at_length_limit);
               nearest_field(to, path);
               realisations_field(to, path);
             });
           });
}

}  // namespace

void lengths_field(FieldVisitor& v, const FourBarSolution& found) {
  const LinkLengths& lengths = found.lengths;
  const auto arm = [&](Point pivot) {
    return found.path ? std::optional(std::abs(found.path->point - pivot)) : std::nullopt;
  };
  constexpr Number bar = {.least = 0, .above = true};
  v.member("lengths", true, [&](FieldVisitor& at) {
    at.object({.name = "four_bar_lengths"}, [&](FieldVisitor& to) {
      to.shown("ground", lengths.ground, bar);
      to.shown("input", lengths.input, bar);
      to.shown("coupler", lengths.coupler, bar);
      to.shown("output", lengths.output, bar);
      to.shown_if_any(Field("point_to_input", "Paths: from the point to the input's moving pivot."),
                      arm(found.four_bar.input_moving), forms::not_negative);
      to.shown_if_any(Field("point_to_output", "Paths: from the point to the output's moving pivot."),
                      arm(found.four_bar.output_moving), forms::not_negative);
    });
  });
}

void path_fields(FieldVisitor& v, const FourBarSolution& found) {
  const bool is = found.path.has_value(), was_driven = is && found.verified_by_driving && found.report.defects.none();
  const TimedPath none;
  const TimedPath& path = is ? *found.path : none;
  v.shown_if_any(Field("point", "Paths: the point of the coupler in position 1."), forms::where(is, path.point),
                 forms::shown_point);
  v.shown_if_any(Field("input_deg_at_points", "Paths: turns of the crank from position 1."),
                 forms::where(is, degrees_of_all(path.input)), forms::on_a_line, Number{});
  v.shown_if_any(Field("theta_deg_at_points", "Paths: turns of the coupler from position 1, in (-180, 180]."),
                 forms::where(is, degrees_of_all(path.coupler)), forms::on_a_line, Number{});
  cognate_field(v, found.path);
  fit_field(v, found.fit);
  v.shown_if_any(Field("elbows",
                       "Paths with points at which no angle is given: on which side of the line from the arm's ground "
                       "pivot to each of them its elbow stands, + left or - right, and which of the further dyads."),
                 forms::where(is && !path.elbows.empty(), path.elbows));
  v.shown_if_any(Field("full_turn", "Paths: the crank turns fully, so that the path is closed."),
                 forms::where(is, path.full_turn));
  std::optional<bool> in_order = path.circuit_order;
  v.optional(Field("circuit_order",
                   "Paths: along the circuit of the linkage, either way round, the points come as they are listed; "
                   "null where they lie on different circuits.")
                 .null_for_none()
                 .written(is),
             in_order);
  v.shown_if_any(Field("position_error",
                       "Paths, free of defects: by driving, the largest distance of the point from where it is to be "
                       "with the crank turned by input_deg_at_points."),
                 forms::where(was_driven, path.position_error), forms::not_negative);
  v.shown_if_any(Field("timing_error_deg",
                       "Paths, free of defects: by driving, the largest turn of the crank from there to where the "
                       "point is nearest."),
                 forms::where(was_driven, degrees(path.timing_error)), forms::not_negative);
}

void visit_cranks(FieldVisitor& v, const PathAnswer& answer) {
  visit_each(v, forms::on_lines, answer.given.points, [&](FieldVisitor& to, const BurmesterPoint& point) {
    fields(to, CrankRecord{point, answer.given.frame()});
  });
}

}  // namespace linkwright
