#include "linkwright/robust/made_dimension.hpp"

#include <gtest/gtest.h>

namespace linkwright::made_dimension_test {
namespace {

TEST(MadeDimension, NamesAndVariesDimensionsAsThePlanarParametersAre) {
  for (const auto distribution : {ToleranceDistribution::normal, ToleranceDistribution::uniform}) {
    Tolerances t{.length = {1, 2, 3, 4, 5}, .clearance = 0.7, .driver = 0.1};
    t.distribution = distribution;
    const auto dimensions = made_dimensions(PlanarOutput{}, t);
    ASSERT_EQ(dimensions.size(), planar_parameters);
    for (std::size_t i = 0; i < dimensions.size(); ++i) {
      EXPECT_EQ(dimensions[i].name, name(static_cast<PlanarParameter>(i)));
      EXPECT_EQ(dimensions[i].tolerance, planar_half_tolerances(t)[i]);
      EXPECT_DOUBLE_EQ(dimensions[i].variance(t), planar_variances(t)[i]);
      EXPECT_DOUBLE_EQ(dimensions[i].reach(t), planar_reach(t)[i]);
      EXPECT_EQ(dimensions[i].is_driver, i == 9);
    }
  }
}

// Nobody is told to loosen what is not there.
TEST(MadeDimension, HasNoPointWhereAnAngleIsAskedFor) {
  const Tolerances t{.length = LengthTolerances::all(1)};
  PlanarOutput output;
  output.kind = PlanarOutput::Kind::angle;
  const auto dimensions = made_dimensions(output, t);
  EXPECT_EQ(dimensions[6].tolerance, 1);
  EXPECT_EQ(dimensions[7].tolerance, 0);
  EXPECT_EQ(dimensions[8].tolerance, 0);
}

TEST(MadeDimension, NamesAndVariesDimensionsAsTheSphericalParametersAre) {
  const Tolerances t{.clearance = 5, .driver = 0.1, .link_angle = 0.02};
  const auto dimensions = made_dimensions(SphericalOutput{}, t);
  ASSERT_EQ(dimensions.size(), spherical_parameters);
  for (std::size_t i = 0; i < dimensions.size(); ++i) {
    EXPECT_EQ(dimensions[i].name, name(static_cast<SphericalParameter>(i)));
    EXPECT_DOUBLE_EQ(dimensions[i].variance(t), spherical_variances(t)[i]);
    EXPECT_EQ(dimensions[i].reach(t), i == 4 ? 0.1 : 0.02);
  }
}

}  // namespace
}  // namespace linkwright::made_dimension_test
