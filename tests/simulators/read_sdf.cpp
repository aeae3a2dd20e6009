// Reads an SDF or URDF file by libsdformat: what it complains of goes to standard error, and is counted by the exit
// status; its links and joints, a line each, to standard output. usage: read_sdf FILE
#include <iostream>
#include <sdf/sdf.hh>

int main(int, char** arguments) {
  sdf::Root root;
  const sdf::Errors errors = root.Load(arguments[1]);
  for (const sdf::Error& error : errors) std::cerr << error << '\n';
  const sdf::Model* model = root.Model();
  if (model == nullptr) return 1;
  for (std::uint64_t k = 0; k < model->LinkCount(); ++k) {
    const sdf::Link& link = *model->LinkByIndex(k);
    ignition::math::Pose3d pose;
    const bool placed = link.SemanticPose().Resolve(pose, "__model__").empty();
    std::cout << "link " << link.Name() << ' ' << placed << ' ' << link.Inertial().MassMatrix().IsValid() << ' '
              << link.Inertial().MassMatrix().Mass() << ' ' << link.CollisionCount() << ' ' << pose.Pos() << '\n';
  }
  for (std::uint64_t k = 0; k < model->JointCount(); ++k) {
    const sdf::Joint& joint = *model->JointByIndex(k);
    std::string parent, child;
    ignition::math::Pose3d pose;
    const bool placed = joint.ResolveParentLink(parent).empty() && joint.ResolveChildLink(child).empty() &&
                        joint.SemanticPose().Resolve(pose, "__model__").empty();
    ignition::math::Vector3d axis;
    if (joint.Axis() != nullptr) placed&& joint.Axis()->ResolveXyz(axis, "__model__").empty();
    std::cout << "joint " << joint.Name() << ' ' << placed << ' ' << static_cast<int>(joint.Type()) << ' ' << parent
              << ' ' << child << ' ' << pose.Pos() << ' ' << axis << '\n';
  }
  return errors.empty() ? 0 : 1;
}
