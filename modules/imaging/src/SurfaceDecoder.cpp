// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceDecoder.h"

#include <vtkCellArray.h>
#include <vtkExecutive.h>
#include <vtkPLYReader.h>
#include <vtkSTLReader.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <initializer_list>
#include <type_traits>

#include "PolyData.h"
#include "VtkErrorCollector.h"

namespace perilymph::imaging {
namespace {

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
vtkSmartPointer<vtkPolyData> readWith(const std::filesystem::path& file, std::size_t& corners)
{
  const auto complaints = vtkSmartPointer<ErrorCollector>::New();
  const auto reader = vtkSmartPointer<Reader>::New();
  const auto triangles = vtkSmartPointer<vtkTriangleFilter>::New();
  complaints->listenTo({reader, reader->GetExecutive(), triangles, triangles->GetExecutive()});
  if constexpr (std::is_base_of_v<vtkXMLReader, Reader>) reader->SetParserErrorObserver(complaints);
  reader->SetFileName(file.c_str());
  reader->Update();
  if (complaints->isAny || !cornersExist(*reader->GetOutput())) return nullptr;
  corners = static_cast<std::size_t>(reader->GetOutput()->GetPolys()->GetNumberOfConnectivityIds());
  triangles->SetInputConnection(reader->GetOutputPort());
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  if (complaints->isAny) return nullptr;
  return triangles->GetOutput();
}

}  // namespace

std::optional<anatomy::Surface> decodeSurface(const std::filesystem::path& file,
                                              const std::string& ending, std::size_t& corners)
{
  vtkSmartPointer<vtkPolyData> data;
  if (ending == ".stl")
    data = readWith<vtkSTLReader>(file, corners);
  else if (ending == ".ply")
    data = readWith<vtkPLYReader>(file, corners);
  else
    data = readWith<vtkXMLPolyDataReader>(file, corners);
  if (!data || data->GetNumberOfPolys() == 0) return std::nullopt;
  return fromPolyData(*data);
}

}  // namespace perilymph::imaging
