#include "machine/step_file.hpp"

#include <cstdlib>
#include <gtest/gtest.h>

#include "support/machine_cases.hpp"

// What is in the files: tests/step, where OpenCASCADE is found.
namespace linkwright::step_file_test {
namespace {

TEST(StepFile, AsksForAPositionThatIsThere) {
  const Machine& made = testing::machines().front();
  for (const int position : {-1, 4, 1000})
    EXPECT_EQ(write_step(made, position).errors().front().code, "no_such_position");
}

TEST(StepFile, IsWrittenOrSaysHowToGetTheComponent) {
  const auto text = write_step(testing::machines().front());
  if (text) {
    EXPECT_EQ(text->substr(0, 13), "ISO-10303-21;");
  } else {
    EXPECT_EQ(text.errors().front().code, "no_step_component");
    EXPECT_NE(text.errors().front().message.find("libocct-data-exchange-dev"), std::string::npos);
  }
}

}  // namespace
}  // namespace linkwright::step_file_test
