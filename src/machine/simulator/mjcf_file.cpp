#include <cmath>
#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "machine/simulator/simulator_model.hpp"
#include "machine/simulator/xml_writer.hpp"
#include "machine/simulator_file.hpp"

namespace linkwright {
namespace {

class MjcfWriter {
 public:
  explicit MjcfWriter(SimulatorModel model) : model_(std::move(model)) {}

  std::string write(const std::string& title) {
    xml_.comment(model_.remark);
    xml_.open("mujoco", {{"model", title.empty() ? "linkage" : title}});
    xml_.leaf("compiler", {{"angle", "radian"}, {"autolimits", "true"}});
    xml_.comment("Without gravity, so that the motor alone moves it; gravity 0 0 -9.81 pulls down along z.");
    xml_.leaf("option",
              {{"timestep", "0.001"}, {"integrator", "implicitfast"}, {"tolerance", "1e-12"}, {"gravity", "0 0 0"}});
    write_defaults();
    xml_.open("worldbody");
    const double far = 3 * model_.size;
    xml_.leaf("light", {{"pos", numbers({far, -far, far})}, {"dir", "-1 1 -1"}});
    write_body(0);
    xml_.close();
    write_loops();
    write_motor();
    write_keys();
    xml_.close();
    return xml_.file();
  }

 private:
  void write_defaults() {
    xml_.open("default");
    xml_.leaf("geom", {{"contype", "0"}, {"conaffinity", "0"}});
    xml_.leaf("site", {{"size", number(0.01 * model_.size)}});
    // As stiff as the time step allows.
    xml_.leaf("equality", {{"solref", "0.002 1"}, {"solimp", "0.9999 0.9999 0.001 0.5 2"}});
    xml_.close();
  }

  void write_body(int place) {
    const SimulatorLink& link = model_.links[static_cast<std::size_t>(place)];
    const Vector3 before = link.parent < 0 ? Vector3{} : model_.links[static_cast<std::size_t>(link.parent)].origin;
    xml_.open("body", {{"name", link.name}, {"pos", numbers(link.origin - before, model_.size)}});
    if (link.parent >= 0)
      xml_.leaf("joint", {{"name", model_.hinge_names[link.hinge]},
                          {"type", "hinge"},
                          {"axis", numbers(model_.hinge_axes[link.hinge])}});
    write_matter(link);
    for (const Solid& solid : link.solids) write_solid(link, solid);
    if (link.parent >= 0) write_site(link, model_.hinge_names[link.hinge], link.origin);
    for (const SimulatorLoop& loop : model_.loops)
      if (place == loop.first || place == loop.second)
        write_site(link, model_.hinge_names[loop.hinge] + "_of_" + link.name, model_.hinge_points[loop.hinge]);
    if (place == model_.guided) write_site(link, "guided", model_.guided_point);
    for (int child = place + 1; child < static_cast<int>(model_.links.size()); ++child)
      if (model_.links[static_cast<std::size_t>(child)].parent == place) write_body(child);
    xml_.close();
  }

  void write_matter(const SimulatorLink& link) {
    const auto& [mass, centre, inertia] = link.matter;
    const double size = trace(inertia);
    xml_.leaf("inertial", {{"pos", numbers(centre - link.origin, model_.size)},
                           {"mass", number(mass, mass)},
                           {"fullinertia", numbers({inertia(0, 0), inertia(1, 1), inertia(2, 2)}, size) + ' ' +
                                               numbers({inertia(0, 1), inertia(0, 2), inertia(1, 2)}, size)}});
  }

  void write_solid(const SimulatorLink& link, const Solid& solid) {
    const UnitQuaternion q = solid.place.rotation.quaternion();
    XmlWriter::Attributes attributes;
    if (const auto* box = std::get_if<SolidBox>(&solid.shape))
      attributes = {{"type", "box"}, {"size", numbers(0.5 * box->size, model_.size)}};
    else {
      const auto& cylinder = std::get<SolidCylinder>(solid.shape);
      attributes = {{"type", "cylinder"},
                    {"size", number(cylinder.radius, model_.size) + ' ' + number(cylinder.length / 2, model_.size)}};
    }
    attributes.emplace_back("pos", numbers(solid.place.translation, model_.size));
    attributes.emplace_back("quat", number(q.w()) + ' ' + numbers(q.v()));
    attributes.emplace_back("rgba", fmt::format("{} {} {} 1", link.colour[0], link.colour[1], link.colour[2]));
    xml_.leaf("geom", attributes);
  }

  void write_site(const SimulatorLink& link, const std::string& name, Vector3 point) {
    xml_.leaf("site", {{"name", name}, {"pos", numbers(point - link.origin, model_.size)}});
  }

  void write_loops() {
    xml_.open("equality");
    for (const auto& [hinge, first, second] : model_.loops) {
      const SimulatorLink& one = model_.links[static_cast<std::size_t>(first)];
      xml_.leaf("connect", {{"name", model_.hinge_names[hinge]},
                            {"body1", one.name},
                            {"body2", model_.links[static_cast<std::size_t>(second)].name},
                            {"anchor", numbers(model_.hinge_points[hinge] - one.origin, model_.size)}});
    }
    xml_.close();
  }

  /// A servo of some 10 Hz on all that moves, as if it were at the longest link's end; damped so that it does not
  /// overshoot.
  void write_motor() {
    const double inertia = model_.mass * model_.size * model_.size, speed = two_pi * 10;
    XmlWriter::Attributes attributes = {
        {"name", "motor"},
        {"joint", model_.hinge_names[model_.links[static_cast<std::size_t>(model_.driver)].hinge]},
        {"kp", number(inertia * speed * speed, inertia)},
        {"kv", number(2 * inertia * speed, inertia)}};
    if (model_.driver_range) {
      xml_.comment("Beyond this range the linkage locks.");
      attributes.emplace_back("ctrlrange",
                              number(model_.driver_range->first) + ' ' + number(model_.driver_range->second));
    }
    xml_.open("actuator");
    xml_.leaf("position", attributes);
    xml_.close();
  }

  void write_keys() {
    if (model_.keys.empty()) return;
    xml_.open("keyframe");
    for (const auto& [position, turns] : model_.keys) {
      std::string joints;
      for (const double turn : turns) joints += (joints.empty() ? "" : " ") + number(turn);
      xml_.leaf("key", {{"name", fmt::format("position_{}", position + 1)},
                        {"qpos", joints},
                        {"ctrl", number(turns[static_cast<std::size_t>(model_.driver - 1)])}});
    }
    xml_.close();
  }

  SimulatorModel model_;
  XmlWriter xml_;
};

}  // namespace

std::string write_mjcf(const Machine& machine, double density) {
  return MjcfWriter(simulator_model(machine, density)).write(machine.linkage.title);
}

}  // namespace linkwright
