#include "machine/step_file.hpp"

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepBndLib.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <fstream>
#include <gtest/gtest.h>
#include <map>

#include "linkwright/core/angle.hpp"
#include "linkwright/machine/machine_export.hpp"
#include "linkwright/machine/mesh.hpp"
#include "support/file_support.hpp"
#include "support/machine_cases.hpp"

namespace linkwright::step_test {
namespace {

/// What a STEP file holds, by the names of the components, where they stand.
std::map<std::string, TopoDS_Shape> read_back(const std::string& text) {
  const testing::Folder folder;
  const std::filesystem::path file = folder / "linkage.step";
  std::ofstream(file) << text;
  Handle(TDocStd_Document) document = new TDocStd_Document("XmlXCAF");
  STEPCAFControl_Reader reader;
  reader.SetNameMode(true);
  EXPECT_EQ(reader.ReadFile(file.c_str()), IFSelect_RetDone);
  EXPECT_TRUE(reader.Transfer(document));
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  TDF_LabelSequence roots, parts;
  shapes->GetFreeShapes(roots);
  EXPECT_EQ(roots.Length(), 1) << "one assembly";
  XCAFDoc_ShapeTool::GetComponents(roots.First(), parts);
  std::map<std::string, TopoDS_Shape> found;
  for (const TDF_Label& part : parts) {
    Handle(TDataStd_Name) name;
    EXPECT_TRUE(part.FindAttribute(TDataStd_Name::GetID(), name));
    found[TCollection_AsciiString(name->Get()).ToCString()] = XCAFDoc_ShapeTool::GetShape(part);
  }
  return found;
}

std::map<std::string, TopoDS_Shape> written(const Machine& made, int position) {
  const auto text = write_step(made, position);
  EXPECT_TRUE(text.ok()) << (text.ok() ? "" : text.errors().front().message);
  return text.ok() ? read_back(*text) : std::map<std::string, TopoDS_Shape>();
}

double volume_of(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

/// The axes of its cylindrical holes: those of the radius.
std::vector<gp_Ax1> holes(const TopoDS_Shape& shape, double radius) {
  std::vector<gp_Ax1> axes;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    const BRepAdaptor_Surface surface(TopoDS::Face(face.Current()));
    if (surface.GetType() != GeomAbs_Cylinder || std::abs(surface.Cylinder().Radius() - radius) > 1e-9 * radius)
      continue;
    const gp_Ax1 axis = surface.Cylinder().Axis();
    const bool known = std::any_of(axes.begin(), axes.end(), [&](const gp_Ax1& other) {
      return gp_Lin(other).Distance(axis.Location()) < 1e-6 * radius && axis.IsParallel(other, 1e-9);
    });
    if (!known) axes.push_back(axis);
  }
  return axes;
}

std::vector<const Machine*> some_machines() {
  std::vector<const Machine*> some;
  for (const Machine& made : testing::machines())
    if (made.linkage.title.ends_with(" 1")) some.push_back(&made);
  return some;
}

TEST(StepFile, HasNamedSolidsOfTheRightVolume) {
  for (const Machine* made : some_machines()) {
    const auto parts = written(*made, 0);
    const double mm = made->linkage.millimetres();
    EXPECT_EQ(parts.size(), made->parts.size()) << made->linkage.title;
    for (const Part& part : made->parts) {
      ASSERT_TRUE(parts.contains(part.name)) << made->linkage.title << ' ' << part.name;
      EXPECT_TRUE(BRepCheck_Analyzer(parts.at(part.name)).IsValid()) << part.name;
      // Finer and finer chords, and what they tend to: the error falls with the square.
      const double coarse = volume(mesh_of(part, 0.08)), fine = volume(mesh_of(part, 0.04));
      const double limit = (fine + (fine - coarse) / 3) * mm * mm * mm;
      EXPECT_NEAR(volume_of(parts.at(part.name)) / limit, 1, made->linkage.spherical ? 2e-3 : 1e-5)
          << made->linkage.title << ' ' << part.name;
    }
  }
}

TEST(StepFile, AxesOfHolesLieAsFarApartAsTheLinksAreLong) {
  for (const Machine* made : some_machines()) {
    const auto parts = written(*made, 0);
    const double mm = made->linkage.millimetres(), size = made->linkage.longest_link() * mm;
    for (std::size_t body = 0; body < made->linkage.bodies.size(); ++body) {
      const std::vector<gp_Ax1> axes = holes(parts.at(made->linkage.bodies[body]), mm * made->sizes.hole() / 2);
      const auto hinges = made->linkage.hinges_of(static_cast<int>(body));
      ASSERT_GE(axes.size(), hinges.size()) << made->linkage.title << ' ' << made->linkage.bodies[body];
      for (std::size_t i = 0; i < hinges.size(); ++i)
        for (std::size_t k = i + 1; k < hinges.size(); ++k) {
          const Vector3 a = made->linkage.hinges[hinges[i]].point, b = made->linkage.hinges[hinges[k]].point;
          const double wanted =
              made->linkage.spherical ? std::min(angle_between(a, b), pi - angle_between(a, b)) : mm * norm(a - b);
          double nearest = 1e300;
          for (const gp_Ax1& one : axes)
            for (const gp_Ax1& other : axes) {
              if (&one == &other) continue;
              const double angle = one.Direction().Angle(other.Direction());
              const double apart =
                  made->linkage.spherical ? std::min(angle, pi - angle) : gp_Lin(one).Distance(other.Location());
              nearest = std::min(nearest, std::abs(apart - wanted));
            }
          EXPECT_LT(nearest, made->linkage.spherical ? 1e-9 : 1e-9 * size) << made->linkage.title;
        }
    }
  }
}

TEST(StepFile, HoldsTheStudsAndGasSpringsOfLoads) {
  const Problem problem = testing::example("tailgate_struts.json", 60);
  const AnyStoredLinkage stored = stored_linkages(problem, testing::answer_of(problem)).front();
  const auto& bars = std::get<StoredLinkage>(stored);
  for (const int position : {0, 3}) {
    MachineWishes wishes;
    wishes.position = position;
    wishes.loads = problem.options.loads;
    const auto file = exported_machine(stored, "step", wishes);
    ASSERT_TRUE(file.ok()) << file.errors().front().message;
    const auto parts = read_back(file->content);
    const Pose& pose = bars.poses[static_cast<std::size_t>(position)].pose;
    const Point ground{150, 115}, body = pose.origin + direction(pose.angle) * Point{60, 298};
    const auto axis_of = [&](const std::string& name, double radius) {
      const auto axes = holes(parts.at(name), radius);
      EXPECT_EQ(axes.size(), 1U) << name;
      return gp_Lin(axes.front());
    };
    const double pin = machine(moving_linkage(stored)).value().sizes.pin / 2;
    EXPECT_LT(axis_of("stud_strut_from", pin).Distance(gp_Pnt(ground.real(), ground.imag(), 0)), 1e-6) << position;
    EXPECT_LT(axis_of("stud_strut_to", pin).Distance(gp_Pnt(body.real(), body.imag(), 0)), 1e-6) << position;
    // Tube and rod lie in one line, from stud to stud: rods of 8 mm.
    const gp_Lin rod = axis_of("strut_rod", 4), tube = axis_of("strut_tube", 8);
    for (const gp_Lin& line : {rod, tube})
      for (const Point stud : {ground, body})
        EXPECT_LT(line.Distance(gp_Pnt(stud.real(), stud.imag(), rod.Location().Z())), 1e-5) << position;
    EXPECT_NEAR(volume_of(parts.at("strut_tube")) / (pi * 64 * (325 - 128 - 3 * pin)), 1, 1e-9);
  }
}

bool boxes_meet(const TopoDS_Shape& one, const TopoDS_Shape& other) {
  Bnd_Box a, b;
  BRepBndLib::Add(one, a);
  BRepBndLib::Add(other, b);
  return !a.IsOut(b);
}

TEST(StepFile, NothingInterferesInAnyPositionOfTheTask) {
  int pairs = 0;
  for (const Machine* made : some_machines())
    for (int position = 0; position < made->linkage.positions; ++position) {
      const auto parts = written(*made, position);
      for (auto one = parts.begin(); one != parts.end(); ++one)
        for (auto other = std::next(one); other != parts.end(); ++other) {
          if (!boxes_meet(one->second, other->second)) continue;
          ++pairs;
          const double common = volume_of(BRepAlgoAPI_Common(one->second, other->second).Shape());
          EXPECT_LT(common, 1e-9 * volume_of(one->second)) << made->linkage.title << ": " << one->first << " and "
                                                           << other->first << " in position " << position + 1;
        }
    }
  EXPECT_GT(pairs, 100);
}

}  // namespace
}  // namespace linkwright::step_test
