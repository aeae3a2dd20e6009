#include "loads/carried.hpp"

#include <variant>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

CarriedFrame along(Point from, Point to) {
  const double length = std::abs(to - from);
  return {from, length > 0 ? (to - from) / length : Point{1, 0}};
}

CarriedMass mass_of(LoadedBody on, const LinkMass& link, double length, double metres) {
  const double mass = link.kg_per_m ? *link.kg_per_m * length * metres : link.mass.value_or(0);
  const double of_rod = link.kg_per_m ? mass * length * length * metres * metres / 12 : 0;
  return {{on, link.center.value_or(Point{length / 2, 0})}, mass, link.inertia.value_or(of_rod)};
}

}  // namespace

CarriedFrame frame_of(LoadedBody on, const FourBar& bars, const Pose& body) {
  switch (on) {
    case LoadedBody::ground:
      return {};
    case LoadedBody::input:
      return along(bars.input_fixed, bars.input_moving);
    case LoadedBody::coupler:
      return along(bars.input_moving, bars.output_moving);
    case LoadedBody::output:
      return along(bars.output_fixed, bars.output_moving);
    default:
      return {body.origin, direction(body.angle)};
  }
}

Point gravity_in(const Loads& loads, const LoadCase& of) {
  return loads.gravity ? loads.gravity->acceleration * direction(loads.gravity->direction - of.slope) : Point{};
}

std::vector<CarriedMass> masses_in(const Loads& loads, const LoadCase& of, const FourBar& bars) {
  std::vector<CarriedMass> masses;
  const LinkLengths lengths = bars.lengths();
  const double metres = metres_of(loads);
  if (loads.body) masses.push_back({{LoadedBody::body, loads.body->center}, loads.body->mass, loads.body->inertia});
  if (loads.input) masses.push_back(mass_of(LoadedBody::input, *loads.input, lengths.input, metres));
  if (loads.coupler) masses.push_back(mass_of(LoadedBody::coupler, *loads.coupler, lengths.coupler, metres));
  if (loads.output) masses.push_back(mass_of(LoadedBody::output, *loads.output, lengths.output, metres));
  for (const ExtraLoad& extra : loads.extra)
    if (extra.mass && acts_in(extra, of)) masses.push_back({extra.at, *extra.mass, 0});
  return masses;
}

std::vector<Point> LoadMarks::points() const {
  std::vector<Point> all = masses;
  for (const Strut& spring : springs) all.insert(all.end(), {spring.from, spring.to});
  if (cylinder) all.insert(all.end(), {cylinder->from, cylinder->to});
  if (handle) all.push_back(*handle);
  return all;
}

LoadMarks marks_of(const Loads& loads, const FourBar& bars, const Pose& body) {
  const auto place = [&](const CarriedPoint& point) { return place_of(point, bars, body); };
  LoadMarks marks;
  for (const Spring& spring : loads.springs)
    if (!std::holds_alternative<TorsionSpring>(spring.law))
      marks.springs.push_back({place(spring.from), place(spring.to)});
  if (loads.drive == LoadDrive::cylinder) marks.cylinder = {place(loads.cylinder.from), place(loads.cylinder.to)};
  LoadCase all;
  for (const ExtraLoad& extra : loads.extra) all.extra.push_back(extra.name);
  for (const CarriedMass& mass : masses_in(loads, all, bars)) marks.masses.push_back(place(mass.at));
  if (loads.handle) marks.handle = place({LoadedBody::body, loads.handle->point});
  return marks;
}

}  // namespace linkwright
