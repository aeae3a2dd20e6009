#include "path_fit_fields.hpp"

#include "files/fields/result_forms.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {

void error_field(FieldVisitor& v, const CurveError& error) {
  v.member("error", true, [&](FieldVisitor& at) {
    at.object({.name = "path_error", .about = "Of the points from the path, user's unit."}, [&](FieldVisitor& to) {
      to.shown(Field("sum_of_squares", "Weighted."), error.sum_of_squares, forms::not_negative);
      to.shown(Field("rms", "Root of the weighted mean of the squares."), error.rms, forms::not_negative);
      to.shown("max", error.max, forms::not_negative);
      to.shown(Field("max_at", "At which point, from 1."), static_cast<std::int64_t>(error.max_at) + 1, forms::count);
      to.shown("rms_over_diagonal", error.rms_over_diagonal, forms::not_negative);
      to.shown(Field("excursion", "Largest distance of the path between the points from the polygon through them."),
               error.excursion, forms::not_negative);
      to.shown(Field("path_length_ratio", "Length of the path over that of the polygon."), error.path_length_ratio,
               forms::not_negative);
    });
  });
}

void nearest_field(FieldVisitor& v, const FittedPath& path) {
  v.member(Field("at", "Where the linkage is nearest to each point, or its crank at the angle given there."), true,
           [&](FieldVisitor& to) {
             visit_each(to, List{.what = ""}, path.at, [](FieldVisitor& each, const FittedPath::Nearest& nearest) {
               each.object({.name = "nearest_to_point"}, [&](FieldVisitor& of) {
                 of.shown(Field("point", "From 1."), static_cast<std::int64_t>(nearest.point) + 1, forms::count);
                 of.shown(Field("input_deg", "Turn of the input from position 1."), degrees(nearest.input), Number{});
                 of.shown(Field("place", "Of the path, fixed frame."), std::optional(nearest.place),
                          forms::shown_point);
                 of.shown("distance", nearest.distance, forms::not_negative);
               });
             });
           });
}

}  // namespace linkwright
