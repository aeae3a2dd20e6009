#include "pose_fit_fields.hpp"

#include "files/fields/result_forms.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {

void error_field(FieldVisitor& v, const PoseFitError& error) {
  v.member("error", true, [&](FieldVisitor& at) {
    const Object described = {"pose_fit_error",
                              "Of the body from the near poses, user's unit; of a pose √(distance² + (turning length × "
                              "angle)²)."};
    at.object(described, [&](FieldVisitor& to) {
      to.shown(Field("sum_of_squares", "Weighted."), error.sum_of_squares, forms::not_negative);
      to.shown(Field("rms", "Root of the weighted mean of the squares."), error.rms, forms::not_negative);
      to.shown("position_rms", error.position_rms, forms::not_negative);
      to.shown("position_max", error.position_max, forms::not_negative);
      to.shown("angle_rms_deg", degrees(error.angle_rms), forms::arc_deg);
      to.shown("angle_max_deg", degrees(error.angle_max), forms::arc_deg);
      to.shown(Field("max_at", "At which pose, from 1."), static_cast<std::int64_t>(error.max_at) + 1, forms::count);
      to.shown(Field("exact_residual", "Largest error at the exact poses."), error.exact_residual, forms::not_negative);
    });
  });
}

void nearest_field(FieldVisitor& v, const NearMiss& miss) {
  v.member(Field("at", "Where the linkage is nearest to each pose, in their order."), true, [&](FieldVisitor& to) {
    visit_each(to, List{.what = ""}, miss.at, [](FieldVisitor& each, const NearMiss::Nearest& nearest) {
      each.object({.name = "nearest_to_pose"}, [&](FieldVisitor& of) {
        of.shown(Field("pose", "From 1."), static_cast<std::int64_t>(nearest.pose) + 1, forms::count);
        of.shown("near", nearest.is_near);
        of.shown(Field("input_deg", "Turn of the input from position 1."), degrees(nearest.input), Number{});
        of.shown(Field("place", "Of the moving frame's origin, fixed frame."), std::optional(nearest.body.origin),
                 forms::shown_point);
        of.shown("theta_deg", degrees(nearest.body.angle), Number{});
        of.shown("distance", nearest.position_error, forms::not_negative);
        of.shown("angle_deg", degrees(nearest.angle_error), forms::arc_deg);
      });
    });
  });
}

void tolerance_fields(FieldVisitor& v, const NearMiss& miss) {
  std::vector<std::int64_t> outside;
  for (const std::size_t pose : miss.outside) outside.push_back(static_cast<std::int64_t>(pose) + 1);
  v.shown(Field("within_tolerance", "At all near poses that have one."), miss.outside.empty());
  v.shown(Field("outside", "Poses at which it is farther off than their tolerance, from 1."), outside, forms::on_a_line,
          forms::count);
}

}  // namespace linkwright
