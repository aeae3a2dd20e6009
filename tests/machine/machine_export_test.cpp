#include "linkwright/machine/machine_export.hpp"

#include <gtest/gtest.h>

#include "machine/print_file.hpp"
#include "machine/simulator_file.hpp"
#include "support/machine_cases.hpp"

namespace linkwright::machine_export_test {
namespace {

TEST(MachineExport, GivesTheFileOfTheFormat) {
  const AnyStoredLinkage& linkage = testing::stored_linkages_of_examples().front();
  const Machine& made = testing::machines().front();
  EXPECT_EQ(exported_machine(linkage, "stl", {}).value().content, write_stl(made));
  EXPECT_EQ(exported_machine(linkage, "3mf", {}).value().content, write_3mf(made));
  EXPECT_EQ(exported_machine(linkage, "plates", {}).value().content, draw_plates(made));
  EXPECT_EQ(exported_machine(linkage, "mjcf", {}).value().content, write_mjcf(made));
}

TEST(MachineExport, WarnsWhereSomethingCollides) {
  StoredLinkage drag_link;
  drag_link.four_bar = {{0, 0}, {3, 0}, {1, 0}, {1, 3}};
  EXPECT_NE(exported_machine(drag_link, "stl", {}).value().warning.find("comes nearer"), std::string::npos);
}

TEST(MachineExport, PassesMistakesOn) {
  for (const AnyStoredLinkage& linkage : testing::stored_linkages_of_examples()) {
    MachineWishes wishes;
    wishes.sizes.pin = 1e6;
    EXPECT_FALSE(exported_machine(linkage, "stl", wishes).ok());
    if (!std::holds_alternative<StoredSphericalFourBar>(linkage)) continue;
    EXPECT_EQ(exported_machine(linkage, "plates", {}).errors().front().code, "curved_plates");
  }
}

}  // namespace
}  // namespace linkwright::machine_export_test
