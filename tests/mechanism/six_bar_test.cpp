#include "linkwright/mechanism/six_bar.hpp"

#include <gtest/gtest.h>

namespace linkwright::six_bar_test {
namespace {

SixBar with_links(BodyPair link_4, BodyPair link_5) {
  return SixBar::of({Point{0, 0}, Point{0, 3}, Point{4, 3}}, {link_4, link_5}, {Point{5, 0}, Point{2, 5}},
                    {Point{6, 1}, Point{7, 4}});
}

TEST(SixBar, NamesItsTopologyByTheGround) {
  EXPECT_EQ(with_links({0, 2}, {0, 3}).topology(), SixBarTopology::stephenson_3);
  EXPECT_EQ(with_links({0, 2}, {1, 3}).topology(), SixBarTopology::watt_1);
  EXPECT_EQ(with_links({0, 3}, {1, 4}).topology(), SixBarTopology::stephenson_1);
  EXPECT_EQ(with_links({1, 3}, {0, 3}).topology(), SixBarTopology::stephenson_2);
  EXPECT_EQ(with_links({0, 3}, {2, 4}).topology(), SixBarTopology::stephenson_2);
}

TEST(SixBar, RefusesChainsThatGuideNothing) {
  EXPECT_FALSE(with_links({0, 2}, {0, 2}).topology()) << "body 3 dangles";
  EXPECT_FALSE(with_links({0, 2}, {0, 4}).topology()) << "Watt's chain with a ternary ground (Watt II)";
}

TEST(SixBar, HasTenLengths) {
  const SixBar six_bar = with_links({0, 2}, {0, 3});
  const std::vector<SixBarLength> lengths = six_bar.lengths();
  ASSERT_EQ(lengths.size(), 10u);
  EXPECT_EQ(name(lengths[0]), "0:a-c4");
  EXPECT_DOUBLE_EQ(lengths[0].length, 5);
  EXPECT_EQ(name(lengths[3]), "1:a-b");
  EXPECT_DOUBLE_EQ(lengths[3].length, 3);
  EXPECT_EQ(name(lengths[9]), "5:c5-z5");
}

TEST(SixBar, KnowsTheHingesOfABody) {
  const SixBar six_bar = with_links({0, 2}, {4, 3});
  EXPECT_EQ(six_bar.joints_of(4), (std::vector<std::size_t>{SixBar::c4, SixBar::z4, SixBar::c5}));
  EXPECT_EQ(six_bar.joints_of(5), (std::vector<std::size_t>{SixBar::c5, SixBar::z5}));
  EXPECT_EQ(six_bar.added()[1], (BodyPair{4, 3}));
}

TEST(SixBar, ReadsAndWritesItsNames) {
  EXPECT_EQ(text(BodyPair{0, 2}), "0-2");
  EXPECT_EQ(body_pair_from("4-3"), (BodyPair{4, 3}));
  for (const char* wrong : {"", "0", "02", "0-", "0-22", "0+2", "6-1", "a-b"}) EXPECT_FALSE(body_pair_from(wrong));
}

}  // namespace
}  // namespace linkwright::six_bar_test
