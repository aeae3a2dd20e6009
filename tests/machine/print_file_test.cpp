#include "machine/print_file.hpp"

#include <cstring>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "machine/zip_archive.hpp"
#include "support/machine_cases.hpp"

namespace linkwright::print_file_test {
namespace {

TEST(LaidParts, LieOnTheBedBesideEachOtherAndKeepTheirVolume) {
  for (const Machine& made : testing::machines()) {
    const double mm = made.linkage.millimetres();
    const std::vector<LaidPart> parts = laid_parts(made);
    ASSERT_EQ(parts.size(), made.parts.size());
    std::vector<std::array<double, 4>> boxes;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      EXPECT_NEAR(volume(parts[k].mesh) / (mm * mm * mm * volume(mesh_of(made.parts[k]))), 1, 1e-9) << parts[k].name;
      std::array<double, 4> box = {1e300, 1e300, -1e300, -1e300};
      double lowest = 1e300;
      for (const Vector3 v : parts[k].mesh.vertices) {
        lowest = std::min(lowest, v.z);
        box = {std::min(box[0], v.x), std::min(box[1], v.y), std::max(box[2], v.x), std::max(box[3], v.y)};
      }
      EXPECT_NEAR(lowest, 0, 1e-9);
      for (const auto& other : boxes)
        EXPECT_TRUE(box[0] > other[2] || box[2] < other[0] || box[1] > other[3] || box[3] < other[1])
            << made.linkage.title << ' ' << parts[k].name;
      boxes.push_back(box);
    }
  }
}

TEST(LaidParts, FlatPlatesAreAsHighAsTheyAreThick) {
  const Machine& made = testing::machines().front();
  const double mm = made.linkage.millimetres();
  for (const LaidPart& part : laid_parts(made)) {
    if (part.name.starts_with("pin_")) continue;
    for (const Vector3 v : part.mesh.vertices)
      EXPECT_TRUE(std::abs(v.z) < 1e-9 || std::abs(v.z - mm * made.sizes.thickness) < 1e-9);
  }
}

TEST(StlFile, HasAllTrianglesWithTheirNormals) {
  for (const Machine& made : testing::machines()) {
    const std::string bytes = write_stl(made);
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, 4);
    ASSERT_EQ(bytes.size(), 84 + 50u * count);
    std::size_t triangles = 0;
    for (const LaidPart& part : laid_parts(made)) triangles += part.mesh.triangles.size();
    EXPECT_EQ(count, triangles);
    double six_volumes = 0, wanted = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
      std::array<float, 12> f{};
      std::memcpy(f.data(), bytes.data() + 84 + 50 * k, 48);
      const auto v = [&](int i) { return Vector3{f[3 * i], f[3 * i + 1], f[3 * i + 2]}; };
      six_volumes += determinant(v(1), v(2), v(3));
    }
    for (const LaidPart& part : laid_parts(made)) wanted += volume(part.mesh);
    EXPECT_NEAR(six_volumes / 6 / wanted, 1, 1e-4) << made.linkage.title;
  }
}

TEST(PlateDrawing, HasALayerAndTheTrueHolesOfEachPlate) {
  for (const Machine& made : testing::machines()) {
    const std::string dxf = draw_plates(made);
    EXPECT_EQ(dxf.empty(), made.linkage.spherical);
    if (dxf.empty()) continue;
    std::size_t circles = 0, holes = 0;
    for (std::size_t at = dxf.find("\nCIRCLE\n"); at != std::string::npos; at = dxf.find("\nCIRCLE\n", at + 1))
      ++circles;
    for (std::size_t body = 0; body < made.linkage.bodies.size(); ++body)
      holes += std::get<FlatPlate>(made.parts[body].shape).holes.size();
    EXPECT_EQ(circles, holes) << made.linkage.title;
  }
}

TEST(ZipArchive, KnowsTheChecksumOfTheStandard) {
  EXPECT_EQ(crc32_of("123456789"), 0xCBF43926u);  // ISO 3309's check value
  EXPECT_EQ(crc32_of(""), 0u);
}

TEST(ThreeMfFile, IsTheSameTwice) {
  const Machine& made = testing::machines().front();
  EXPECT_EQ(write_3mf(made), write_3mf(made));
  EXPECT_EQ(write_3mf(made).substr(0, 2), "PK");
}

}  // namespace
}  // namespace linkwright::print_file_test
