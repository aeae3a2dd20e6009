#include "linkwright/core/notice.hpp"

#include <gtest/gtest.h>

namespace linkwright::notice_test {
namespace {

TEST(Notice, HoldsNumbersAndWordsByName) {
  const Notice notice{"order_defect", "Order defect.", {{"order", "1-3-2-4"}, {"count", 4.0}}};
  EXPECT_EQ(std::get<std::string>(notice.values[0].value), "1-3-2-4");
  EXPECT_EQ(std::get<double>(notice.values[1].value), 4.0);
}

}  // namespace
}  // namespace linkwright::notice_test
