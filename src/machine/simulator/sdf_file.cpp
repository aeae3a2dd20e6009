#include <fmt/format.h>

#include "machine/simulator/simulator_model.hpp"
#include "machine/simulator/xml_writer.hpp"
#include "machine/simulator_file.hpp"

namespace linkwright {
namespace {

class SdfWriter {
 public:
  explicit SdfWriter(SimulatorModel model) : model_(std::move(model)) {}

  std::string write() {
    xml_.comment(model_.remark);
    xml_.open("sdf", {{"version", "1.9"}});
    xml_.open("model", {{"name", "linkage"}});
    xml_.text("self_collide", "false");
    xml_.open("joint", {{"name", "ground_to_world"}, {"type", "fixed"}});
    xml_.text("parent", "world");
    xml_.text("child", model_.links.front().name);
    xml_.close();
    for (const SimulatorLink& link : model_.links) write_link(link);
    for (int place = 1; place < static_cast<int>(model_.links.size()); ++place) {
      const SimulatorLink& link = model_.links[static_cast<std::size_t>(place)];
      write_joint(link.hinge, link.parent, place);
    }
    for (const SimulatorLoop& loop : model_.loops) write_loop(loop);
    xml_.close();
    xml_.close();
    return xml_.file();
  }

 private:
  void write_pose(const Displacement& place) {
    xml_.text("pose", numbers(place.translation, model_.size) + ' ' + numbers(roll_pitch_yaw(place.rotation)));
  }

  /// Of a link's matter that a pin of its takes, by which a loop is closed.
  static constexpr double share_of_pin = 1e-3;

  [[nodiscard]] double share_left(const SimulatorLink& link) const {
    double left = 1;
    for (const SimulatorLoop& loop : model_.loops)
      if (&link == &model_.links[static_cast<std::size_t>(loop.second)]) left -= share_of_pin;
    return left;
  }

  void write_link(const SimulatorLink& link) {
    xml_.open("link", {{"name", link.name}});
    write_pose(Displacement::translated(link.origin));
    const double left = share_left(link);
    const double mass = left * link.matter.mass;
    const Vector3 centre = link.matter.centre;
    const Matrix3x3 inertia = left * link.matter.inertia;
    const double size = trace(inertia);
    xml_.open("inertial");
    write_pose(Displacement::translated(centre - link.origin));
    xml_.text("mass", number(mass, mass));
    xml_.open("inertia");
    for (const auto& [name, row, column] : inertia_elements) xml_.text(name, number(inertia(row, column), size));
    xml_.close();
    xml_.close();
    for (const Solid& solid : link.solids) write_solid(link, solid, &solid - link.solids.data());
    xml_.close();
  }

  void write_solid(const SimulatorLink& link, const Solid& solid, std::ptrdiff_t count) {
    xml_.open("visual", {{"name", fmt::format("shape_{}", count + 1)}});
    write_pose(solid.place);
    xml_.open("geometry");
    if (const auto* box = std::get_if<SolidBox>(&solid.shape)) {
      xml_.open("box");
      xml_.text("size", numbers(box->size, model_.size));
    } else {
      const auto& cylinder = std::get<SolidCylinder>(solid.shape);
      xml_.open("cylinder");
      xml_.text("radius", number(cylinder.radius, model_.size));
      xml_.text("length", number(cylinder.length, model_.size));
    }
    xml_.close();
    xml_.close();
    const std::string colour = fmt::format("{} {} {} 1", link.colour[0], link.colour[1], link.colour[2]);
    xml_.open("material");
    xml_.text("ambient", colour);
    xml_.text("diffuse", colour);
    xml_.close();
    xml_.close();
  }

  /// Gazebo lets a link have one parent joint: a pin turns in the second link, and is welded to the first.
  void write_loop(const SimulatorLoop& loop) {
    const SimulatorLink &one = model_.links[static_cast<std::size_t>(loop.first)],
                        &other = model_.links[static_cast<std::size_t>(loop.second)];
    const std::string hinge = model_.hinge_names[loop.hinge], pin = hinge + "_pin";
    xml_.comment(fmt::format(
        "The hinge {} closes a loop. A link has one parent joint at most: so the pin {} turns in {}, and Gazebo (from "
        "Harmonic on) welds it to {} by the constraint of the plugin below. Other programs have to close it "
        "themselves.",
        hinge, pin, other.name, one.name));
    xml_.open("link", {{"name", pin}});
    write_pose(Displacement::translated(model_.hinge_points[loop.hinge]));
    xml_.open("inertial");
    xml_.text("mass", number(share_of_pin * other.matter.mass, other.matter.mass));
    xml_.open("inertia");
    const double moment = share_of_pin * trace(other.matter.inertia) / 3;
    for (const auto& [name, row, column] : inertia_elements)
      xml_.text(name, row == column ? number(moment, moment) : "0");
    xml_.close();
    xml_.close();
    xml_.close();
    xml_.open("joint", {{"name", hinge}, {"type", "revolute"}});
    xml_.text("parent", other.name);
    xml_.text("child", pin);
    xml_.open("axis");
    xml_.text("xyz", numbers(model_.hinge_axes[loop.hinge]), {{"expressed_in", "__model__"}});
    xml_.close();
    xml_.close();
    xml_.open("plugin",
              {{"filename", "gz-sim-detachable-joint-system"}, {"name", "gz::sim::systems::DetachableJoint"}});
    xml_.text("parent_link", one.name);
    xml_.text("child_model", "__model__");
    xml_.text("child_link", pin);
    xml_.close();
  }

  void write_joint(std::size_t hinge, int parent, int child) {
    const SimulatorLink &one = model_.links[static_cast<std::size_t>(parent)],
                        &other = model_.links[static_cast<std::size_t>(child)];
    xml_.open("joint", {{"name", model_.hinge_names[hinge]}, {"type", "revolute"}});
    write_pose(Displacement::translated(model_.hinge_points[hinge] - other.origin));
    xml_.text("parent", one.name);
    xml_.text("child", other.name);
    xml_.open("axis");
    xml_.text("xyz", numbers(model_.hinge_axes[hinge]), {{"expressed_in", "__model__"}});
    if (child == model_.driver && model_.driver_range) {
      xml_.open("limit");
      xml_.text("lower", number(model_.driver_range->first));
      xml_.text("upper", number(model_.driver_range->second));
      xml_.close();
    }
    xml_.close();
    xml_.close();
  }

  SimulatorModel model_;
  XmlWriter xml_;
};

}  // namespace

std::string write_sdf(const Machine& machine, double density) {
  return SdfWriter(simulator_model(machine, density)).write();
}

}  // namespace linkwright
