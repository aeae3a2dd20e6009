#include "step_shapes.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <gp_Circ.hxx>

#include "linkwright/core/angle.hpp"

namespace linkwright::step {
namespace {

gp_Pnt point(Vector3 p) { return {p.x, p.y, p.z}; }
gp_Dir unit(Vector3 d) { return {d.x, d.y, d.z}; }

TopoDS_Wire circle_wire(const gp_Circ& circle, bool reversed) {
  const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle).Edge()).Wire();
  return reversed ? TopoDS::Wire(wire.Reversed()) : wire;
}

/// Arcs about the corners and straight sides between them.
TopoDS_Wire rounded_wire(const std::vector<Point>& polygon, double radius, double z) {
  BRepBuilderAPI_MakeWire wire;
  const std::size_t count = polygon.size();
  const auto at = [z](Point p) { return gp_Pnt(p.real(), p.imag(), z); };
  const auto aside = [&](std::size_t from) {
    const Point along = polygon[(from + 1) % count] - polygon[from];
    return radius * (along / std::abs(along)) * Point{0, -1};
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Point here = polygon[i], next = polygon[(i + 1) % count];
    const gp_Circ circle(gp_Ax2(at(here), gp::DZ()), radius);
    wire.Add(BRepBuilderAPI_MakeEdge(circle, at(here + aside((i + count - 1) % count)), at(here + aside(i))).Edge());
    wire.Add(BRepBuilderAPI_MakeEdge(at(here + aside(i)), at(next + aside(i))).Edge());
  }
  return wire.Wire();
}

TopoDS_Shape solid(const FlatPlate& plate, double scale) {
  std::vector<Point> outline;
  for (const Point corner : plate.outline) outline.push_back(scale * corner);
  const double low = scale * plate.low;
  BRepBuilderAPI_MakeFace face(rounded_wire(outline, scale * plate.radius, low), true);
  for (const Point hole : plate.holes) {
    const gp_Pnt middle(scale * hole.real(), scale * hole.imag(), low);
    face.Add(circle_wire(gp_Circ(gp_Ax2(middle, gp::DZ()), scale * plate.hole_radius), true));
  }
  return BRepPrimAPI_MakePrism(face.Face(), gp_Vec(0, 0, scale * plate.high - low)).Shape();
}

TopoDS_Shape solid(const RoundPin& pin, double scale) {
  const Vector3 along = pin.to - pin.from;
  return BRepPrimAPI_MakeCylinder(gp_Ax2(point(scale * pin.from), unit(along)), scale * pin.radius, scale * norm(along))
      .Shape();
}

/// Between two radii, the directions from one to another at an angle from the first, towards `beside` (a unit vector
/// square to it).
TopoDS_Face sector(Vector3 middle, Vector3 beside, double from, double to, double low, double high) {
  const auto at = [&](double radius, double angle) {
    return point(radius * (std::cos(angle) * middle + std::sin(angle) * beside));
  };
  const gp_Ax2 axes(gp::Origin(), unit(cross(middle, beside)), unit(middle));
  const gp_Circ inner(axes, low), outer(axes, high);
  BRepBuilderAPI_MakeWire wire;
  wire.Add(BRepBuilderAPI_MakeEdge(inner, at(low, from), at(low, to)).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(at(low, to), at(high, to)).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(outer, at(high, from), at(high, to)).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(at(high, from), at(low, from)).Edge());
  return BRepBuilderAPI_MakeFace(wire.Wire(), true).Face();
}

TopoDS_Shape turned(const TopoDS_Face& face, Vector3 axis, double angle) {
  return BRepPrimAPI_MakeRevol(face, gp_Ax1(gp::Origin(), unit(axis)), angle).Shape();
}

TopoDS_Shape solid(const ShellPlate& plate, double scale) {
  const double low = scale * plate.low, high = scale * plate.high, half = plate.half_angle;
  const Vector3 normal = normalized(cross(plate.from, plate.to));
  const TopoDS_Shape strip =
      turned(sector(plate.from, normal, -half, half, low, high), normal, angle_between(plate.from, plate.to));
  const TopoDS_Shape first = turned(sector(plate.from, normal, 0, half, low, high), plate.from, pi);
  const TopoDS_Shape last = turned(sector(plate.to, normal, 0, half, low, high), -plate.to, pi);
  TopoDS_Shape whole = BRepAlgoAPI_Fuse(BRepAlgoAPI_Fuse(strip, first).Shape(), last).Shape();
  for (const Vector3 axis : {plate.from, plate.to}) {
    const gp_Ax2 place(point(0.9 * low * axis), unit(axis));
    whole = BRepAlgoAPI_Cut(whole,
                            BRepPrimAPI_MakeCylinder(place, scale * plate.hole_radius, 1.1 * high - 0.9 * low).Shape())
                .Shape();
  }
  return whole;
}

}  // namespace

TopoDS_Shape solid_of(const Part& part, double scale) {
  return std::visit([scale](const auto& shape) { return solid(shape, scale); }, part.shape);
}

gp_Trsf transformation(const Displacement& displacement, double scale) {
  const auto m = displacement.matrix();
  gp_Trsf place;
  place.SetValues(m[0][0], m[0][1], m[0][2], scale * m[0][3], m[1][0], m[1][1], m[1][2], scale * m[1][3], m[2][0],
                  m[2][1], m[2][2], scale * m[2][3]);
  return place;
}

}  // namespace linkwright::step
