// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/SurfaceReader.h"

#include <vtkCellArray.h>
#include <vtkExecutive.h>
#include <vtkSTLReader.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <exception>
#include <initializer_list>
#include <string>
#include <type_traits>

#include "PlyFile.h"
#include "PolyData.h"
#include "VtkComplaints.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::imaging {
namespace {

// 256 MiB contain five million triangles, a hundred times what a cochlea needs.
constexpr std::size_t maxBytes = 256u << 20;

/// Whether VTK also regards the content as text: above a fraction of other bytes, such as control
/// characters, it takes the file for binary and its text for a number of triangles.
bool isPlainText(const std::string& content)
{
  return std::all_of(content.begin(), content.end(), [](char c) {
    return (c >= ' ' && c <= '~') || c == '\n' || c == '\r' || c == '\t';
  });
}

/// Whether the content matches the extension; VTK's readers do not check it.
bool beginsRight(const std::string& content, const std::string& ending)
{
  if (ending == ".vtp") return content.find("<VTKFile") != std::string::npos;
  const bool isText = content.rfind("solid", 0) == 0 && content.find("facet") != std::string::npos;
  if (isText && isPlainText(content)) return true;
  if (content.size() < 84) return false;
  std::uint32_t count = 0;
  for (std::size_t k = 4; k-- > 0;)
    count = (count << 8) | static_cast<unsigned char>(content[80 + k]);
  return content.size() == 84 + 50 * static_cast<std::size_t>(count);
}

/// Whether the cells only refer to existing points; VTK's filters do not check it.
bool cornersExist(vtkPolyData& data)
{
  const vtkIdType points = data.GetNumberOfPoints();
  for (vtkCellArray* const cells :
       {data.GetVerts(), data.GetLines(), data.GetPolys(), data.GetStrips()}) {
    if (!cells) continue;
    if (!cells->IsValid()) return false;
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    for (cells->InitTraversal(); cells->GetNextCell(count, corners) != 0;)
      if (std::any_of(corners, corners + count,
                      [points](vtkIdType corner) { return corner < 0 || corner >= points; }))
        return false;
  }
  return true;
}

/// The output of a VTK reader for a file; empty if it reports an error.
template <class Reader>
vtkSmartPointer<vtkPolyData> readWith(const std::filesystem::path& file)
{
  const auto complaints = vtkSmartPointer<Complaints>::New();
  const auto reader = vtkSmartPointer<Reader>::New();
  const auto triangles = vtkSmartPointer<vtkTriangleFilter>::New();
  complaints->listenTo({reader, reader->GetExecutive(), triangles, triangles->GetExecutive()});
  if constexpr (std::is_base_of_v<vtkXMLReader, Reader>) reader->SetParserErrorObserver(complaints);
  reader->SetFileName(file.c_str());
  reader->Update();
  if (complaints->isAny || !cornersExist(*reader->GetOutput())) return nullptr;
  triangles->SetInputConnection(reader->GetOutputPort());
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  if (complaints->isAny) return nullptr;
  return triangles->GetOutput();
}

}  // namespace

Result<anatomy::Surface> readSurface(const std::filesystem::path& file)
{
  const std::string name = file.string();
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending != ".stl" && ending != ".ply" && ending != ".vtp")
    return Error{name + " ends in '" + ending +
                 "'; a surface is read from .stl, .ply or .vtp. Export it as one of these."};
  const auto content = readWhole(file, maxBytes);
  if (!content) return content.error();
  const Error damaged{name + " is not a whole " + ending +
                      " file of a surface. Export it again from the segmentation program."};
  try {
    if (ending == ".ply") {
      if (auto surface = readPly(*content)) return *std::move(surface);
      return damaged;
    }
    if (!beginsRight(*content, ending)) return damaged;
    const vtkSmartPointer<vtkPolyData> data =
        ending == ".stl" ? readWith<vtkSTLReader>(file) : readWith<vtkXMLPolyDataReader>(file);
    if (!data || data->GetNumberOfPolys() == 0) return damaged;
    return fromPolyData(*data);
  } catch (const std::exception&) {  // sizes beyond the available memory
    return damaged;
  }
}

}  // namespace perilymph::imaging
