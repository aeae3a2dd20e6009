#include "print_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <limits>

#include "linkwright/files/number_text.hpp"
#include "machine/zip_archive.hpp"

namespace linkwright {
namespace {

struct Box3 {
  Vector3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
};

Box3 box_of(const Mesh& mesh) {
  Box3 box;
  for (const Vector3 vertex : mesh.vertices)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], vertex[axis]);
      box.high[axis] = std::max(box.high[axis], vertex[axis]);
    }
  return box;
}

/// A right-handed frame with the part's own directions: z is up on the printer's bed.
struct Bed {
  Vector3 x, y, z;
};

Bed bed(Vector3 x, Vector3 z) { return {x, cross(z, x), z}; }

Bed bed_of(const FlatPlate& plate) {
  const Point along = plate.outline[1] - plate.outline[0];
  return bed(normalized(in_space(along)), {0, 0, 1});
}
Bed bed_of(const ShellPlate& plate) {
  return bed(normalized(plate.to - plate.from), normalized(plate.from + plate.to));
}
Bed bed_of(const RoundPin& pin) {
  const Vector3 z = normalized(pin.to - pin.from);
  return bed(normalized(cross(std::abs(z.z) > 0.5 ? Vector3{0, 1, 0} : Vector3{0, 0, 1}, z)), z);
}

void turn_onto_bed(Mesh& mesh, const Bed& frame, double scale) {
  for (Vector3& vertex : mesh.vertices)
    vertex = scale * Vector3{dot(frame.x, vertex), dot(frame.y, vertex), dot(frame.z, vertex)};
}

/// Rows about as wide as they are deep together.
void lay_in_rows(std::vector<LaidPart>& parts, double gap) {
  double area = 0;
  for (const LaidPart& part : parts) {
    const Box3 box = box_of(part.mesh);
    area += (box.high.x - box.low.x + gap) * (box.high.y - box.low.y + gap);
  }
  const double width = 1.4 * std::sqrt(area);
  double x = 0, y = 0, depth = 0;
  for (LaidPart& part : parts) {
    const Box3 box = box_of(part.mesh);
    const Vector3 size = box.high - box.low;
    if (x > 0 && x + size.x > width) {
      x = 0;
      y += depth + gap;
      depth = 0;
    }
    for (Vector3& vertex : part.mesh.vertices) vertex = vertex - box.low + Vector3{x, y, 0};
    x += size.x + gap;
    depth = std::max(depth, size.y);
  }
}

void put_float(std::string& bytes, double value) {
  const auto number = static_cast<float>(value);
  std::uint32_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>((bits >> (8 * k)) & 0xFF);
}

/// Decimals that tell a hundred millionth of what is laid out: beyond them stands rounding.
int vertex_decimals(const std::vector<LaidPart>& parts) {
  double size = 0;
  for (const LaidPart& part : parts)
    for (const Vector3 v : part.mesh.vertices) size = std::max({size, v.x, v.y, v.z});
  return std::clamp(8 - static_cast<int>(std::floor(std::log10(size))), 0, 30);
}

std::string model_of(const std::vector<LaidPart>& parts) {
  const int decimals = vertex_decimals(parts);
  std::string xml =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" xml:lang=\"en-US\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n<resources>\n";
  for (std::size_t k = 0; k < parts.size(); ++k) {
    xml += fmt::format("<object id=\"{}\" type=\"model\" name=\"{}\"><mesh><vertices>\n", k + 1, parts[k].name);
    for (const Vector3 v : parts[k].mesh.vertices)
      xml += fmt::format("<vertex x=\"{:.{}f}\" y=\"{:.{}f}\" z=\"{:.{}f}\"/>\n", v.x, decimals, v.y, decimals, v.z,
                         decimals);
    xml += "</vertices><triangles>\n";
    for (const auto& [a, b, c] : parts[k].mesh.triangles)
      xml += fmt::format("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n", a, b, c);
    xml += "</triangles></mesh></object>\n";
  }
  xml += "</resources>\n<build>\n";
  for (std::size_t k = 0; k < parts.size(); ++k) xml += fmt::format("<item objectid=\"{}\"/>\n", k + 1);
  return xml + "</build>\n</model>\n";
}

constexpr const char* content_types =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Types "
    "xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
    "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
    "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>\n";
constexpr const char* relationships =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Relationships "
    "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
    "<Relationship Target=\"/3D/3dmodel.model\" Id=\"model\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";

}  // namespace

std::vector<LaidPart> laid_parts(const Machine& machine) {
  const double scale = machine.linkage.millimetres();
  std::vector<LaidPart> parts;
  for (const Part& part : machine.parts) {
    parts.push_back({part.name, mesh_of(part)});
    turn_onto_bed(parts.back().mesh, std::visit([](const auto& shape) { return bed_of(shape); }, part.shape), scale);
  }
  lay_in_rows(parts, scale * machine.sizes.pin);
  return parts;
}

std::string write_stl(const Machine& machine) {
  const std::vector<LaidPart> parts = laid_parts(machine);
  std::uint32_t count = 0;
  std::string bytes = "Linkwright, millimetres";
  bytes.resize(84, ' ');
  for (const LaidPart& part : parts)
    for (const auto& [a, b, c] : part.mesh.triangles) {
      const auto at = [&](int k) { return part.mesh.vertices[static_cast<std::size_t>(k)]; };
      const Vector3 normal = normalized(cross(at(b) - at(a), at(c) - at(a)));
      for (const Vector3 v : {normal, at(a), at(b), at(c)})
        for (std::size_t axis = 0; axis < 3; ++axis) put_float(bytes, v[axis]);
      bytes.append(2, '\0');
      ++count;
    }
  for (std::size_t k = 0; k < 4; ++k) bytes[80 + k] = static_cast<char>((count >> (8 * k)) & 0xFF);
  return bytes;
}

std::string write_3mf(const Machine& machine) {
  return zip_archive({{"[Content_Types].xml", content_types},
                      {"_rels/.rels", relationships},
                      {"3D/3dmodel.model", model_of(laid_parts(machine))}});
}

Result<std::string> write_parts(const Machine& machine, std::string_view format) {
  if (format == "stl") return write_stl(machine);
  if (format == "3mf") return write_3mf(machine);
  std::string drawing = draw_plates(machine);
  if (!drawing.empty()) return drawing;
  return Error{"curved_plates",
               "--format",
               "the plates of a spherical four-bar are curved, so that nobody can cut them from a sheet; export it as "
               "step, stl or 3mf",
               {}};
}

}  // namespace linkwright
