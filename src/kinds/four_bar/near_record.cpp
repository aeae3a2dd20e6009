#include "near_record.hpp"

#include "files/pose_fit_fields.hpp"

namespace linkwright {

void near_field(FieldVisitor& v, const std::optional<NearMiss>& near) {
  const NearMiss miss = near.value_or(NearMiss{});
  v.member(Field("near", "Motions past near poses: how near, in their turn.").written(near.has_value()), false,
           [&](FieldVisitor& at) {
             at.object({.name = "near_poses", .on_lines = true}, [&](FieldVisitor& to) {
               error_field(to, miss.error);
               tolerance_fields(to, miss);
               to.shown(Field("in_order", "Driving meets all poses in their order, and no dead point on the way."),
                        miss.in_order);
               to.shown(
                   Field("at_length_limit", "Its longest link is as long as is allowed: longer ones may come nearer."),
                   miss.at_length_limit);
               nearest_field(to, miss);
             });
           });
}

}  // namespace linkwright
