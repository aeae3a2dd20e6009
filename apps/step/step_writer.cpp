#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "machine/body_colors.hpp"
#include "machine/step_component.hpp"
#include "step_shapes.hpp"

namespace linkwright::step {
namespace {

Quantity_Color color_of(const Part& part) {
  const auto [r, g, b] = std::holds_alternative<RoundPin>(part.shape) ? pin_color : body_color(part.body);
  return {r, g, b, Quantity_TOC_sRGB};
}

/// Without control characters, which STEP files may not hold.
std::string printable(std::string words) {
  for (char& c : words)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  return words;
}

void name(const TDF_Label& label, const std::string& words) {
  TDataStd_Name::Set(label, TCollection_ExtendedString(printable(words).c_str(), true));
}

/// The parts, and an assembly in which each stands in its place.
void fill(const Handle(TDocStd_Document) & document, const Machine& machine, int position, double scale) {
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const Handle(XCAFDoc_ColorTool) colors = XCAFDoc_DocumentTool::ColorTool(document->Main());
  const TDF_Label assembly = shapes->NewShape();
  name(assembly, machine.linkage.title.empty() ? "linkage" : machine.linkage.title);
  const MovingState& state = *machine.linkage.at_position(position);
  for (const Part& part : machine.parts) {
    const TDF_Label solid = shapes->AddShape(solid_of(part, scale), false);
    name(solid, part.name);
    colors->SetColor(solid, color_of(part), XCAFDoc_ColorGen);
    const gp_Trsf place = transformation(state.bodies[static_cast<std::size_t>(part.body)], scale);
    name(shapes->AddComponent(assembly, solid, TopLoc_Location(place)), part.name);
  }
  shapes->UpdateAssemblies();
}

void write_header(STEPCAFControl_Writer& writer, const std::string& title) {
  APIHeaderSection_MakeHeader header(writer.ChangeWriter().Model());
  const auto text = [](const std::string& words) { return new TCollection_HAsciiString(words.c_str()); };
  header.SetName(text(printable(title)));
  header.SetOriginatingSystem(text("Linkwright " LINKWRIGHT_VERSION));
}

/// A folder of its own that goes with it.
struct Scratch {
  Scratch() {
    std::string pattern = std::filesystem::temp_directory_path() / "linkwright-XXXXXX";
    if (mkdtemp(pattern.data()) != nullptr) folder = pattern;
  }
  ~Scratch() {
    std::error_code ignored;
    if (!folder.empty()) std::filesystem::remove_all(folder, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  std::filesystem::path folder;
};

bool write(const Machine& machine, int position, double scale, std::string& text) {
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
  STEPCAFControl_Controller::Init();
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  Interface_Static::SetCVal("write.step.unit", "MM");
  const Handle(TDocStd_Document) document = new TDocStd_Document("XmlXCAF");
  fill(document, machine, position, scale);
  STEPCAFControl_Writer writer;
  writer.SetNameMode(true);
  writer.SetColorMode(true);
  if (!writer.Transfer(document, STEPControl_AsIs)) return text = "the transfer failed", false;
  write_header(writer, machine.linkage.title);
  const Scratch scratch;
  const std::filesystem::path file = scratch.folder / "linkage.step";
  if (scratch.folder.empty() || writer.Write(file.c_str()) != IFSelect_RetDone)
    return text = "no temporary file could be written", false;
  std::ifstream read(file, std::ios::binary);
  text.assign(std::istreambuf_iterator<char>(read), {});
  return true;
}

}  // namespace
}  // namespace linkwright::step

extern "C" {

linkwright::StepWriter linkwright_step_writer;
linkwright::StepVersion linkwright_step_version;
linkwright::StepLayout linkwright_step_layout;

bool linkwright_step_writer(const linkwright::Machine& machine, int position, double scale, std::string& text) {
  try {
    return linkwright::step::write(machine, position, scale, text);
  } catch (const Standard_Failure& failure) {
    text = failure.GetMessageString();
  } catch (const std::exception& failure) {
    text = failure.what();
  }
  return false;
}

const char* linkwright_step_version() { return LINKWRIGHT_VERSION; }

std::size_t linkwright_step_layout() { return linkwright::machine_layout; }

}  // extern "C"
