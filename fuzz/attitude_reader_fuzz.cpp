// Any bytes as a file for each of the commands of `linkwright attitude`. What is read must be reported and drawn
// without a number that is none, and the orientation that is written must read as the same one.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "fuzz_support.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/angular_motion_file.hpp"
#include "linkwright/files/displacement_file.hpp"
#include "linkwright/files/link_chain_file.hpp"
#include "linkwright/files/orientation_file.hpp"
#include "linkwright/files/twist_file.hpp"

namespace {

using namespace linkwright;
using fuzz::check_errors, fuzz::require;

/// What is not finite is written as null: in a list of numbers it never is.
void check_numbers(std::string_view written) {
  require(written.find("[null") == std::string_view::npos && written.find(", null") == std::string_view::npos);
}

void check_orientation(std::string_view text) {
  const auto task = read_orientation_task(text);
  if (!task) return check_errors(task.errors());
  const OrientationReport report = orientation_report(*task);
  require(report.orthogonality_error < 1e-13);
  check_numbers(write_orientation_report(report));
  require(draw_orientation(report).find("nan") == std::string::npos);
  const UnitQuaternion q = task->orientation.quaternion.canonical();
  for (const EulerDecomposition& found : report.euler) require(angle_between(found.angles.quaternion(), q) < 1e-14);
}

void check_displacement(std::string_view text) {
  const auto task = read_displacement_task(text);
  if (!task) return check_errors(task.errors());
  const auto report = displacement_report(*task);
  if (!report) return check_errors(report.errors());
  check_numbers(write_displacement_report(*report));
  static_cast<void>(draw_displacement(*report));
}

void check_twist(std::string_view text) {
  const auto task = read_twist_task(text);
  if (!task) return check_errors(task.errors());
  const auto report = twist_report(*task);
  if (!report) return check_errors(report.errors());
  check_numbers(write_twist_report(*report));
}

void check_angular_motion(std::string_view text) {
  const auto task = read_angular_motion_task(text);
  if (!task) return check_errors(task.errors());
  const auto report = angular_motion_report(*task);
  if (!report) return check_errors(report.errors());
  check_numbers(write_angular_motion_report(*report));
}

void check_link_chain(std::string_view text) {
  const auto task = read_link_chain_task(text);
  if (!task) return check_errors(task.errors());
  const auto report = link_chain_report(*task);
  if (!report) return check_errors(report.errors());
  check_numbers(write_link_chain_report(*report));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  check_orientation(text);
  check_displacement(text);
  check_twist(text);
  check_angular_motion(text);
  check_link_chain(text);
  return 0;
}
