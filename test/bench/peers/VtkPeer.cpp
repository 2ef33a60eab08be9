// SPDX-License-Identifier: BSD-3-Clause

// VTK's cell locator: the closest point within a radius, with points in single precision.

#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include <cmath>

#include "Peer.h"

namespace {

using namespace perilymph;

class VtkPeer {
public:
  explicit VtkPeer(const anatomy::Surface& wall_mm)
  {
    const vtkNew<vtkPoints> points;
    for (const auto& each : wall_mm.points) points->InsertNextPoint(each.data());
    const vtkNew<vtkCellArray> triangles;
    for (const auto& each : wall_mm.triangles)
      triangles->InsertNextCell({each[0], each[1], each[2]});
    wall_->SetPoints(points);
    wall_->SetPolys(triangles);
    locator_->SetDataSet(wall_);
    locator_->BuildLocator();
  }

  double distance(const Eigen::Vector3d& center_mm)
  {
    double foot[3] = {};
    vtkIdType triangle = -1;
    int part = 0;
    double square = 0.0;
    const bool isFound = locator_->FindClosestPointWithinRadius(
                             const_cast<double*>(center_mm.data()), 1e3 * bench::reach, foot, cell_,
                             triangle, part, square) != 0;
    return isFound ? std::sqrt(square) : -1.0;
  }

private:
  vtkNew<vtkPolyData> wall_;
  vtkNew<vtkStaticCellLocator> locator_;
  vtkNew<vtkGenericCell> cell_;
};

BENCHMARK(bench::nearestWallBy<VtkPeer>)->Name("lumen/vtk")->Apply(bench::sizes);

}  // namespace
