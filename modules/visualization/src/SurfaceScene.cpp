// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/visualization/SurfaceScene.h"

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTubeFilter.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "PictureSpace.h"
#include "SceneColors.h"

namespace perilymph::visualization {

namespace {

constexpr double mm = 1e3, pointRadius_mm = 0.18, wallOpacity = 0.55;
constexpr double closeness = 1.2;  // VTK leaves space for the bounding sphere
constexpr int tubeSides = 16;
constexpr double cameraDistance_mm = 150.0;  // at least

void paint(vtkActor& actor, const Rgba& color, double opacity)
{
  actor.GetProperty()->SetColor(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  actor.GetProperty()->SetOpacity(opacity);
}

void setPointsOf(vtkPolyData& data, const std::vector<Eigen::Vector3d>& points_mm)
{
  vtkNew<vtkPoints> points;
  for (const Eigen::Vector3d& point : points_mm) points->InsertNextPoint(point.data());
  data.SetPoints(points);
}

}  // namespace

struct SurfaceScene::Content {
  explicit Content(const SceneStyle& style)
      : bone(*renderer, Eigen::Affine3d(Eigen::Scaling(mm)), style)
  {
    bone.setVisible(true);
    prepareCommand->SetClientData(this);
    prepareCommand->SetCallback([](vtkObject*, unsigned long, void* content, void*) {
      static_cast<Content*>(content)->prepare();
    });
    prepareObserver = renderer->AddObserver(vtkCommand::StartEvent, prepareCommand);
  }
  ~Content() { renderer->RemoveObserver(prepareObserver); }

  /// Before each picture: updates what depends on the view.
  void prepare()
  {
    vtkCamera& camera = *renderer->GetActiveCamera();
    const double* away = camera.GetDirectionOfProjection();
    const double* viewUp = camera.GetViewUp();
    ViewFrame view;
    view.back = -Eigen::Vector3d(away[0], away[1], away[2]);
    view.right = Eigen::Vector3d(viewUp[0], viewUp[1], viewUp[2]).cross(view.back).normalized();
    view.up = view.back.cross(view.right);
    view.pixel_mm =
        pixelRatio * 2.0 * camera.GetParallelScale() / std::max(1, renderer->GetSize()[1]);
    bone.lookFrom(view);
  }

  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkPolyData> wall, marks, path;
  vtkNew<vtkPolyDataNormals> normals;
  vtkNew<vtkTubeFilter> tube;
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPolyDataMapper> wallMapper, pathMapper;
  vtkNew<vtkGlyph3DMapper> markMapper;
  vtkNew<vtkActor> wallActor, markActor, pathActor;
  BoneLayer bone;
  double pixelRatio = 1.0;
  vtkNew<vtkCallbackCommand> prepareCommand;
  unsigned long prepareObserver = 0;
};

SurfaceScene::SurfaceScene(const anatomy::Surface& surface, const SceneStyle& style)
    : content_(std::make_unique<Content>(style))
{
  Content& c = *content_;
  const SceneColors& palette = sceneColorsOf(style.scheme);
  vtkNew<vtkPoints> points;
  for (const auto& point : surface.points)
    points->InsertNextPoint(mm * point[0], mm * point[1], mm * point[2]);
  vtkNew<vtkCellArray> triangles;
  for (const auto& corners : surface.triangles)
    triangles->InsertNextCell({corners[0], corners[1], corners[2]});
  c.wall->SetPoints(points);
  c.wall->SetPolys(triangles);
  c.normals->SetInputData(c.wall);
  c.normals->SplittingOff();
  c.wallMapper->SetInputConnection(c.normals->GetOutputPort());
  c.wallActor->SetMapper(c.wallMapper);
  paint(*c.wallActor, palette.lumen, wallOpacity);

  c.sphere->SetRadius(pointRadius_mm);
  c.sphere->SetThetaResolution(tubeSides);
  c.sphere->SetPhiResolution(tubeSides);
  c.markMapper->SetInputData(c.marks);
  c.markMapper->SetSourceConnection(c.sphere->GetOutputPort());
  c.markMapper->ScalingOff();
  c.markActor->SetMapper(c.markMapper);
  paint(*c.markActor, palette.forceLow, 1.0);

  c.tube->SetInputData(c.path);
  c.tube->SetNumberOfSides(tubeSides);
  c.pathMapper->SetInputConnection(c.tube->GetOutputPort());
  c.pathActor->SetMapper(c.pathMapper);
  paint(*c.pathActor, palette.silicone, 1.0);

  c.renderer->SetBackground(palette.ground[0] / 255.0, palette.ground[1] / 255.0,
                            palette.ground[2] / 255.0);
  // opaque actors first, so that they show through the wall
  for (vtkActor* actor : {c.markActor.Get(), c.pathActor.Get(), c.wallActor.Get()})
    c.renderer->AddActor(actor);
  c.wallActor->SetVisibility(!surface.triangles.empty());
  c.bone.addLines();
  c.renderer->GetActiveCamera()->ParallelProjectionOn();
  setPoints({});
  setPath({}, 0.1);
  lookAlong(-Eigen::Vector3d::UnitZ(), -Eigen::Vector3d::UnitY());
}

SurfaceScene::~SurfaceScene() = default;

void SurfaceScene::attachTo(vtkRenderWindow& window) { window.AddRenderer(content_->renderer); }

vtkRenderer& SurfaceScene::renderer() { return *content_->renderer; }

BoneLayer& SurfaceScene::bone() { return content_->bone; }

void SurfaceScene::setScale(double pixelRatio) { content_->pixelRatio = pixelRatio; }

void SurfaceScene::setPoints(const std::vector<Eigen::Vector3d>& points_mm)
{
  setPointsOf(*content_->marks, points_mm);
  content_->marks->Modified();
  content_->markActor->SetVisibility(!points_mm.empty());
}

void SurfaceScene::setPath(const std::vector<Eigen::Vector3d>& points_mm, double radius_mm)
{
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(static_cast<int>(points_mm.size()));
  for (std::size_t k = 0; k < points_mm.size(); ++k)
    line->InsertCellPoint(static_cast<vtkIdType>(k));
  setPointsOf(*content_->path, points_mm);
  content_->path->SetLines(line);
  content_->tube->SetRadius(radius_mm);
  content_->pathActor->SetVisibility(points_mm.size() > 1);
}

void SurfaceScene::lookAlong(const Eigen::Vector3d& away, const Eigen::Vector3d& down)
{
  vtkCamera& camera = *content_->renderer->GetActiveCamera();
  camera.SetFocalPoint(0, 0, 0);
  camera.SetPosition(-away.x(), -away.y(), -away.z());
  camera.SetViewUp(-down.x(), -down.y(), -down.z());
  double bounds[6];
  content_->wall->GetBounds(bounds);
  if (const auto& bone = content_->bone.bone(); bone && content_->wall->GetNumberOfPoints() == 0)
    for (int axis = 0; axis < 3; ++axis) {
      // half of the ball's box: a volume does not fill it
      bounds[2 * axis] = mm * (bone->center[axis] - 0.6 * bone->radius);
      bounds[2 * axis + 1] = mm * (bone->center[axis] + 0.6 * bone->radius);
    }
  content_->renderer->ResetCamera(bounds);
  camera.Zoom(closeness);
  // Parallel projection: far enough for landmarks and bone beside the surface.
  const double distance = std::max(cameraDistance_mm, 2.0 * camera.GetDistance());
  const double* focus = camera.GetFocalPoint();
  const Eigen::Vector3d eye =
      Eigen::Vector3d(focus[0], focus[1], focus[2]) - distance * away.normalized();
  camera.SetPosition(eye.x(), eye.y(), eye.z());
  camera.SetClippingRange(1.0, 2.0 * distance);
}

void SurfaceScene::rotate(double azimuth_deg, double elevation_deg)
{
  vtkCamera& camera = *content_->renderer->GetActiveCamera();
  camera.Azimuth(-azimuth_deg);
  camera.Elevation(elevation_deg);
  camera.OrthogonalizeViewUp();
}

void SurfaceScene::zoom(double factor) { content_->renderer->GetActiveCamera()->Zoom(factor); }

}  // namespace perilymph::visualization
