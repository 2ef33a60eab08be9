// SPDX-License-Identifier: BSD-3-Clause

// Surface files in millimeters: the formats of 3D printers, modelers, VTK, and of the paper (VRML).

#include <Eigen/Geometry>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "perilymph/anatomy/Surface.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Utf8.h"

namespace perilymph::anatomy {
namespace {

/// Text with numbers in shortest form, in any locale.
class Text {
public:
  Text& operator<<(const char* text)
  {
    content += text;
    return *this;
  }
  Text& operator<<(const std::string& text)
  {
    content += text;
    return *this;
  }
  Text& operator<<(double number) { return append(number); }
  Text& operator<<(int number) { return append(number); }
  Text& operator<<(std::size_t number) { return append(number); }
  std::string content;

private:
  template <class Number>
  Text& append(Number number)
  {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, number);
    content.append(buffer, end.ptr);
    return *this;
  }
};

double inFile_mm(double meters) { return std::round(meters * 1e9) / 1e6; }

void writeCorners(Text& text, const Surface& surface, const char* before, const char* after)
{
  for (const auto& point : surface.points)
    text << before << inFile_mm(point[0]) << " " << inFile_mm(point[1]) << " "
         << inFile_mm(point[2]) << after;
}

std::string binaryStl(const Surface& surface, const std::string& title)
{
  std::string content = (title + ", mm").substr(0, 80);
  content.resize(80, ' ');
  const auto append = [&content](const auto& value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    content.append(bytes, sizeof value);
  };
  append(static_cast<std::uint32_t>(surface.triangles.size()));
  for (const auto& triangle : surface.triangles) {
    Eigen::Vector3d corners[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& point = surface.points[static_cast<std::size_t>(triangle[k])];
      corners[k] = 1e3 * Eigen::Vector3d(point[0], point[1], point[2]);
    }
    const Eigen::Vector3d across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double length = across.norm();
    const Eigen::Vector3d normal = length > 0.0 ? Eigen::Vector3d(across / length) : across;
    for (int k = 0; k < 3; ++k) append(static_cast<float>(normal[k]));
    for (const auto& point : corners)
      for (int k = 0; k < 3; ++k) append(static_cast<float>(point[k]));
    append(std::uint16_t{0});
  }
  return content;
}

std::string ply(const Surface& surface, const std::string& title)
{
  Text text;
  text << "ply\nformat ascii 1.0\ncomment " << title << ", mm\nelement vertex "
       << surface.points.size()
       << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
       << surface.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  writeCorners(text, surface, "", "\n");
  for (const auto& t : surface.triangles)
    text << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
  return text.content;
}

std::string obj(const Surface& surface, const std::string& title)
{
  Text text;
  text << "# " << title << ", mm\n";
  writeCorners(text, surface, "v ", "\n");
  for (const auto& t : surface.triangles)
    text << "f " << t[0] + 1 << " " << t[1] + 1 << " " << t[2] + 1 << "\n";
  return text.content;
}

std::string vrml(const Surface& surface, const std::string& title)
{
  Text text;
  text << "#VRML V2.0 utf8\n# " << title << ", mm\nShape {\n  geometry IndexedFaceSet {\n"
       << "    solid FALSE\n    coord Coordinate { point [\n";
  writeCorners(text, surface, "      ", ",\n");
  text << "    ] }\n    coordIndex [\n";
  for (const auto& t : surface.triangles)
    text << "      " << t[0] << ", " << t[1] << ", " << t[2] << ", -1,\n";
  text << "    ]\n  }\n}\n";
  return text.content;
}

std::string vtp(const Surface& surface, const std::string& title)
{
  Text text;
  std::string comment = title;  // XML comments must not contain two consecutive hyphens
  for (std::size_t at = comment.find("--"); at != std::string::npos; at = comment.find("--"))
    comment.replace(at, 2, "- -");
  text << "<?xml version=\"1.0\"?>\n<!-- " << comment << ", mm -->\n"
       << "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
       << "<Piece NumberOfPoints=\"" << surface.points.size() << "\" NumberOfPolys=\""
       << surface.triangles.size() << "\">\n<Points>\n"
       << "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  writeCorners(text, surface, "", "\n");
  text << "</DataArray>\n</Points>\n<Polys>\n"
       << "<DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">\n";
  for (const auto& t : surface.triangles) text << t[0] << " " << t[1] << " " << t[2] << "\n";
  text << "</DataArray>\n<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">\n";
  for (std::size_t i = 1; i <= surface.triangles.size(); ++i) text << 3 * i << "\n";
  text << "</DataArray>\n</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  return text.content;
}

}  // namespace

Result<void> writeSurface(const Surface& surface, const std::string& title,
                          const std::filesystem::path& file)
{
  const std::string line = onOneLine(title);
  const std::string ending = file.extension().string();
  if (ending == ".stl") return writeWhole(file, binaryStl(surface, line));
  if (ending == ".ply") return writeWhole(file, ply(surface, line));
  if (ending == ".obj") return writeWhole(file, obj(surface, line));
  if (ending == ".wrl") return writeWhole(file, vrml(surface, line));
  if (ending == ".vtp") return writeWhole(file, vtp(surface, line));
  return Error{
      "%1 ends in '%2'; a surface is written as .stl, .ply, .obj, .wrl or .vtp. Choose one of "
      "these.",
      file, ending};
}

}  // namespace perilymph::anatomy
