#include "machine/simulator_file.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <regex>

#include "support/machine_cases.hpp"

namespace linkwright::simulator_file_test {
namespace {

int count(const std::string& text, const std::string& piece) {
  int found = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++found;
  return found;
}

Machine scaled(FourBar bars, const std::string& unit, double scale) {
  for (Point* pivot : {&bars.input_fixed, &bars.input_moving, &bars.output_moving, &bars.output_fixed}) *pivot *= scale;
  StoredLinkage linkage;
  linkage.four_bar = bars;
  linkage.length_unit = unit;
  return machine(moving_linkage(linkage)).value();
}

const FourBar parallelogram{{0, 0}, {30, 60}, {100, 0}, {130, 60}};

/// What remains of a file without its comments.
std::string bare(const std::string& text) { return std::regex_replace(text, std::regex("<!--[^>]*-->"), ""); }

TEST(SimulatorFile, CutsEachLoopOnce) {
  for (const Machine& made : testing::machines()) {
    const int bodies = static_cast<int>(made.linkage.bodies.size()),
              hinges = static_cast<int>(made.linkage.hinges.size());
    const int loops = hinges - (bodies - 1);
    const std::string mjcf = write_mjcf(made), sdf = write_sdf(made), urdf = write_urdf(made);
    EXPECT_EQ(count(mjcf, "<joint "), bodies - 1);
    EXPECT_EQ(count(mjcf, "<connect "), loops);
    EXPECT_EQ(count(mjcf, "<inertial "), bodies);
    EXPECT_EQ(count(sdf, "type=\"revolute\""), hinges);
    EXPECT_EQ(count(sdf, "<child>"), hinges + 1);
    EXPECT_EQ(count(sdf, "gz::sim::systems::DetachableJoint"), loops);
    EXPECT_EQ(count(sdf, "<link "), bodies + loops);
    EXPECT_EQ(count(urdf, "<gazebo>"), 0);
    EXPECT_EQ(count(urdf, "closes a loop"), loops);
    EXPECT_EQ(count(mjcf, "<key "), made.linkage.task.empty() ? count(mjcf, "<key ") : made.linkage.positions);
    for (const std::string& file : {mjcf, sdf, urdf})
      for (const char* wrong : {"nan", "inf ", "inf\"", "<collision"}) EXPECT_EQ(count(file, wrong), 0);
  }
}

// Two springs of one hinge are one there, one of a closed loop is told, and what has a name of another's gets its own.
TEST(SimulatorFile, TellsLoadsOnce) {
  LinkageLoads on{{}, parallelogram, {PrescribedPose{}}};
  const auto torsion = [](FourBarJoint joint, double rate, double torque) {
    return Spring{"", 1, {}, {}, TorsionSpring{joint, rate, torque}};
  };
  const CarriedPoint ground{LoadedBody::ground, {10, 90}}, body{LoadedBody::body, {60, 80}};
  on.loads.springs = {torsion(FourBarJoint::input_ground, 0.1, 2), torsion(FourBarJoint::input_ground, 0.3, -1),
                      torsion(FourBarJoint::output_coupler, 0.1, 0),
                      Spring{"wind", 1, ground, body, CoilSpring{.rate = 1, .free_length = 20}},
                      Spring{"motor", 1, ground, body, CoilSpring{.rate = 2, .free_length = 20}}};
  ExtraLoad wind;
  wind.name = "wind";
  wind.at = body;
  wind.force = {3, 4};
  wind.always = true;
  on.loads.extra = {wind};
  const std::string file = write_mjcf(scaled(parallelogram, "mm", 1), steel_density, &on);
  EXPECT_EQ(count(file, "springref=\""), 1);
  EXPECT_EQ(count(file, "where the loop is closed, is left out"), 1);
  EXPECT_EQ(count(file, "<spatial name=\"wind_\""), 1);
  EXPECT_EQ(count(file, "<general name=\"wind\""), 1);
  EXPECT_EQ(count(file, "<spatial name=\"motor_\""), 1);
  EXPECT_EQ(count(file, "nan"), 0);
}

TEST(SimulatorFile, KeepsTheInertiaOfABodyWithoutMass) {
  LinkageLoads on{{}, parallelogram, {PrescribedPose{}}};
  on.loads.output = LinkMass{.mass = 0, .inertia = 0.25};
  const std::string file = write_mjcf(scaled(parallelogram, "mm", 1), steel_density, &on);
  const std::size_t body = file.find("<body name=\"output\"");
  ASSERT_NE(body, std::string::npos);
  const std::string matter = file.substr(file.find("<inertial", body), 200);
  std::smatch found;
  ASSERT_TRUE(std::regex_search(matter, found, std::regex("mass=\"([^\"]+)\" fullinertia=\"\\S+ \\S+ (\\S+) ")));
  EXPECT_GT(std::stod(found[1]), 0);
  EXPECT_LT(std::stod(found[1]), 1e-3);
  EXPECT_NEAR(std::stod(found[2]), 0.25, 1e-9);
}

TEST(SimulatorFile, IsTheSameInAnyUnit) {
  const Machine in_mm = scaled(parallelogram, "mm", 1), in_m = scaled(parallelogram, "m", 0.001),
                in_none = scaled(parallelogram, "", 1);
  for (const char* format : {"mjcf", "sdf", "urdf"}) {
    const std::string file = simulator_text(in_mm, format).value();
    EXPECT_EQ(bare(file), bare(simulator_text(in_m, format).value())) << format;
    EXPECT_EQ(bare(file), bare(simulator_text(in_none, format).value())) << format;
    EXPECT_NE(simulator_text(in_none, format).value().find("no unit of length, taken for millimetres"),
              std::string::npos);
    EXPECT_NE(file.find("lengths in mm"), std::string::npos);
  }
}

TEST(SimulatorFile, MimicsOnlyWhereThatIsExact) {
  const std::string exact = write_urdf(scaled(parallelogram, "mm", 1));
  EXPECT_NE(exact.find("<mimic joint=\"input_ground\" multiplier=\"1\"/>"), std::string::npos);
  EXPECT_NE(exact.find("<mimic joint=\"input_ground\" multiplier=\"-1\"/>"), std::string::npos);
  const std::string other = write_urdf(scaled({{0, 0}, {30, 60}, {100, 0}, {130, 61}}, "mm", 1));
  EXPECT_EQ(count(other, "<mimic"), 0);
  EXPECT_EQ(count(other, "mimic would not be exact"), 2);
}

TEST(SimulatorFile, EscapesTheTitle) {
  Machine made = scaled(parallelogram, "mm", 1);
  made.linkage.title = "a <b> & \"c\" ---> d--";
  const std::string file = write_mjcf(made);
  EXPECT_NE(file.find("model=\"a &lt;b&gt; &amp; &quot;c&quot; ---&gt; d--\""), std::string::npos);
  for (std::size_t at = file.find("<!--"); at != std::string::npos; at = file.find("<!--", at + 1))
    EXPECT_EQ(file.find("--", at + 4), file.find("-->", at + 4));
}

TEST(SimulatorFile, SaysWhatItCannotTake) {
  const Machine made = scaled(parallelogram, "mm", 1);
  const auto code = [](const Result<std::string>& result) { return result.ok() ? "" : result.errors().front().code; };
  EXPECT_EQ(code(simulator_text(made, "obj")), "unknown_simulator");
  for (const double density : {0.0, -1.0, 1e9, std::nan("")})
    EXPECT_EQ(code(simulator_text(made, "mjcf", density)), "density_out_of_range");
  EXPECT_EQ(code(simulator_text(scaled(parallelogram, "mm", 0.002), "mjcf")), "machine_too_small");
  EXPECT_EQ(code(simulator_text(scaled(parallelogram, "m", 100), "mjcf")), "machine_too_large");
}

}  // namespace
}  // namespace linkwright::simulator_file_test
