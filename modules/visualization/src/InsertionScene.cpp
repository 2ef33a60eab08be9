// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/visualization/InsertionScene.h"

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkCullerCollection.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPropCollection.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <optional>

#include "ArrayParts.h"
#include "ArrayPath.h"
#include "Backdrop.h"
#include "CameraPath.h"
#include "ContactField.h"
#include "ContactMarks.h"
#include "GhostArray.h"
#include "PictureSpace.h"
#include "RestingPicture.h"
#include "ScalaParts.h"
#include "ScaleBars.h"

namespace perilymph::visualization {
namespace {

constexpr double cameraDistance_mm = 100.0;  ///< Parallel projection: only has to be outside.
constexpr std::size_t partCount = 6;
constexpr double approach_m = 0.008;                        // drawn outside of the opening
constexpr double axisBelow_m = 0.002, axisAbove_m = 0.003;  // drawn beyond the cochlea

void addLight(vtkRenderer& renderer, double x, double y, double z, double intensity)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetIntensity(intensity);
  renderer.AddLight(light);
}

/// From W [m] to picture space [mm].
Eigen::Affine3d picturesOf(const PictureSpace& space)
{
  Eigen::Affine3d picture = Eigen::Affine3d::Identity();
  for (int axis = 0; axis < 3; ++axis)
    picture.linear().col(axis) = space.place(Eigen::Vector3d::Unit(axis));
  return picture;
}

/// From outside into the opening [m, W].
std::array<Eigen::Vector3d, 2> approachLine(const anatomy::Entry& entry,
                                            const anatomy::Approach& approach)
{
  return {entry.origin_W - approach_m * anatomy::directionOf(approach, entry), entry.origin_W};
}

}  // namespace

SceneLandmarks landmarksOf(const anatomy::ScalaTympani& scala, const anatomy::Approach& approach)
{
  SceneLandmarks landmarks;
  landmarks.roundWindow = scala.wall_W(0.0, 0.0);
  const double base = scala.center_W(0.0).z(), apex = scala.center_W(scala.lastAngle().si()).z();
  landmarks.axis = {Eigen::Vector3d(0.0, 0.0, base - axisBelow_m),
                    Eigen::Vector3d(0.0, 0.0, apex + axisAbove_m)};
  landmarks.approach = approachLine(scala.entry(), approach);
  return landmarks;
}

struct InsertionScene::Content {
  Content(const anatomy::ScalaTympani& scala, const electrode::ArrayDesign& array,
          anatomy::Side side, Quality quality, const SceneStyle& style);
  ~Content() { renderer->RemoveObserver(prepareObserver); }

  /// Where the surgeon's landmarks are: of the scala, and of the array as it lies.
  SceneLandmarks landmarks() const;
  void addActors(const QualityTraits& traits, const SceneColors& palette);
  void applyStereo();
  void applyVisibility();
  void placeCamera();
  void prepare();  ///< Before each picture: updates what depends on the view.
  Eigen::Vector3d tip() const;
  double aspect() const;       ///< Width of the picture over its height; 0 without a window.
  CameraPose presetPoseNow();  ///< Pose of the present preset, framed if it is to be.
  void frameAnew();            ///< After a change of the window or the area.

  PictureSpace space;
  ScalaParts scalaParts;
  ArrayParts arrayParts;
  ArrayPath path;
  ContactField field;
  ContactMarks marks;
  GhostArray ghost;
  Backdrop backdrop;
  CameraSubject subject;
  CameraPath camera;
  CameraPreset preset = CameraPreset::surgeon;
  std::optional<FreeArea> area;
  bool isFramed = false;  ///< The pose is the preset's, framed for the two below.
  FreeArea framedArea;
  double framedAspect = 0.0;

  vtkNew<vtkOpenGLRenderer> renderer;
  BoneLayer bone;
  anatomy::Entry entry;
  SceneLandmarks fixedLandmarks;
  vtkNew<vtkContextActor> overlay;
  vtkNew<ScaleBars> bars;
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<RestingPicture> resting;
  vtkNew<vtkCallbackCommand> prepareCommand;
  unsigned long prepareObserver = 0;

  std::array<bool, partCount> isVisible;
  bool hasForceScale;
  double pixelRatio = 1.0;
  ViewFrame preparedView{.pixel_mm = 0.0};
  Eigen::Vector3d preparedFocus = Eigen::Vector3d::Zero();
  int preparedWidth = 0;
  bool arrayMoved = true;
  Stereo stereo = Stereo::off;
  vtkRenderWindow* window = nullptr;  // owned with the renderer; outlives its use here
};

InsertionScene::Content::Content(const anatomy::ScalaTympani& scala,
                                 const electrode::ArrayDesign& array, anatomy::Side side,
                                 Quality quality, const SceneStyle& style)
    : space(side),
      scalaParts(scala, space, traitsOf(quality), sceneColorsOf(style.scheme)),
      arrayParts(array, sceneColorsOf(style.scheme)),
      path(arrayParts.design().length),
      field(arrayParts.design().length),
      marks(sceneColorsOf(style.scheme)),
      ghost(sceneColorsOf(style.scheme)),
      backdrop(sceneColorsOf(style.scheme)),
      bone(*renderer, picturesOf(space), style),
      entry(scala.entry()),
      fixedLandmarks(landmarksOf(scala)),
      hasForceScale(style.hasForceScale)
{
  subject = {scalaParts.low(),
             scalaParts.high(),
             space.place(entry.origin_W),
             space.direction(entry.out_W),
             space.direction(entry.outward_W),
             space.mirrors()};
  isVisible.fill(true);
  isVisible[static_cast<std::size_t>(Part::landmarks)] = false;
  bone.setLandmarks(fixedLandmarks);
  if (quality == Quality::gpu) bone.keepFine();
  bars->setStyle(style);
  addActors(traitsOf(quality), sceneColorsOf(style.scheme));
  applyVisibility();

  prepareCommand->SetClientData(this);
  prepareCommand->SetCallback([](vtkObject*, unsigned long, void* content, void*) {
    static_cast<Content*>(content)->prepare();
  });
  prepareObserver = renderer->AddObserver(vtkCommand::StartEvent, prepareCommand);
}

SceneLandmarks InsertionScene::Content::landmarks() const
{
  SceneLandmarks now = fixedLandmarks;
  if (path.isEmpty()) return now;
  const Eigen::Affine3d model = picturesOf(space).inverse();
  for (const Length fromTip : arrayParts.design().contactsFromTip)
    now.contacts.push_back(model * path.at(inMillimeters(fromTip)).place);
  return now;
}

void InsertionScene::Content::addActors(const QualityTraits& traits, const SceneColors& palette)
{
  renderer->SetBackground(palette.ground[0] / 255.0, palette.ground[1] / 255.0,
                          palette.ground[2] / 255.0);
  renderer->AddActor(&backdrop.actor());
  renderer->AutomaticLightCreationOff();
  addLight(*renderer, -0.5, 0.75, 1.0, 1.0);  // one key light, from above left
  renderer->GetCullers()->RemoveAllItems();   // a dozen actors, always visible

  vtkPropCollection& props = *renderer->GetViewProps();
  const auto addMoving = [&](const auto& add) {
    const int before = props.GetNumberOfItems();
    add();
    for (int i = before; i < props.GetNumberOfItems(); ++i)
      resting->addMoving(*vtkActor::SafeDownCast(props.GetItemAsObject(i)));
  };
  // Solid parts first, then translucent ones from far to near.
  addMoving([&] { arrayParts.addSolid(*renderer); });
  scalaParts.addFarWall(*renderer);
  addMoving([&] {
    if (traits.hasShadow) arrayParts.addShadow(*renderer);
  });
  scalaParts.addMembrane(*renderer);
  addMoving([&] { marks.addGlow(*renderer); });
  scalaParts.addNearWall(*renderer);
  addMoving([&] {
    arrayParts.addOutline(*renderer);
    ghost.addTo(*renderer);
    marks.addArrows(*renderer);
    bone.addLines();  // with the contacts' labels
  });

  overlay->GetScene()->SetRenderer(renderer);
  overlay->GetScene()->AddItem(bars);
  renderer->AddActor(overlay);

  steps->SetOpaquePass(resting);  // translucent actors, too: they blend in the order above
  steps->SetTranslucentPass(nullptr);
  renderer->SetPass(steps);
}

void InsertionScene::Content::applyVisibility()
{
  const auto shows = [this](Part part) { return isVisible[static_cast<std::size_t>(part)]; };
  scalaParts.setVisible(shows(Part::scala), shows(Part::membrane));
  arrayParts.setVisible(!path.isEmpty(), shows(Part::styletAndTweezers));
  marks.setVisible(shows(Part::wallForce), shows(Part::contactArrows));
  if (shows(Part::landmarks) && !bone.isVisible()) bone.setLandmarks(landmarks());
  if (shows(Part::landmarks) != bone.isVisible()) bone.setVisible(shows(Part::landmarks));
  bars->showsForce = hasForceScale && shows(Part::wallForce) && !path.isEmpty();
  bars->showsArrows = shows(Part::contactArrows) && !path.isEmpty();
  bars->Modified();
}

Eigen::Vector3d InsertionScene::Content::tip() const
{
  return path.isEmpty() ? subject.opening : path.at(0.0).place;
}

double InsertionScene::Content::aspect() const
{
  const int* const size = window == nullptr ? nullptr : renderer->GetSize();
  return size == nullptr || size[0] < 1 || size[1] < 1 ? 0.0 : double(size[0]) / size[1];
}

CameraPose InsertionScene::Content::presetPoseNow()
{
  const CameraPose pose = presetPose(preset, subject, tip());
  isFramed = area && showsAll(preset);
  framedAspect = aspect();
  if (!isFramed || framedAspect <= 0.0) return pose;
  framedArea = *area;
  return framed(pose, scalaParts.places(), framedAspect, framedArea, framedShare);
}

void InsertionScene::Content::frameAnew()
{
  if (!isFramed || (aspect() == framedAspect && *area == framedArea)) return;
  camera.aim(presetPoseNow());
  placeCamera();
}

void InsertionScene::Content::placeCamera()
{
  const CameraPose& pose = camera.pose();
  const Eigen::Matrix3d axes = pose.axes.toRotationMatrix();
  const Eigen::Vector3d eye = pose.focus + cameraDistance_mm * axes.col(2);
  vtkCamera& seen = *renderer->GetActiveCamera();
  seen.ParallelProjectionOn();
  seen.SetFocalPoint(pose.focus.x(), pose.focus.y(), pose.focus.z());
  seen.SetPosition(eye.x(), eye.y(), eye.z());
  seen.SetViewUp(axes(0, 1), axes(1, 1), axes(2, 1));
  seen.SetParallelScale(0.5 * fieldHeight_mm / pose.magnification);
  seen.SetClippingRange(1.0, 2.0 * cameraDistance_mm);
}

void InsertionScene::Content::prepare()
{
  // The camera is told about stereo only by Render(), which a custom pass never calls.
  vtkCamera& eyes = *renderer->GetActiveCamera();
  if (eyes.GetStereo() != renderer->GetRenderWindow()->GetStereoRender()) {
    eyes.Render(renderer);
    eyes.Modified();
  }

  frameAnew();
  const int height = std::max(1, renderer->GetSize()[1]);
  const Eigen::Matrix3d axes = camera.pose().axes.toRotationMatrix();
  const double pixel_mm = fieldHeight_mm / camera.pose().magnification / height;
  const ViewFrame view{axes.col(0), axes.col(1), axes.col(2), pixel_mm * pixelRatio};
  const Eigen::Vector3d focus = camera.pose().focus;
  const int width = renderer->GetSize()[0];
  if (arrayMoved && bone.isVisible()) bone.setLandmarks(landmarks());
  bone.lookFrom(view);
  const bool viewChanged =
      !(view == preparedView) || focus != preparedFocus || width != preparedWidth;
  if (!viewChanged && !arrayMoved) return;

  if (viewChanged) {
    scalaParts.lookFrom(view);
    backdrop.place(view, focus - 0.9 * cameraDistance_mm * view.back, pixel_mm * width,
                   pixel_mm * height);
  }
  if (!path.isEmpty()) {
    arrayParts.lookFrom(view);
    marks.build(field, arrayParts, path, view);
  }
  ghost.lookFrom(view);
  bars->pixel_mm = pixel_mm;
  bars->pixelRatio = pixelRatio;
  preparedView = view;
  preparedFocus = focus;
  preparedWidth = width;
  arrayMoved = false;
}

InsertionScene::InsertionScene(const anatomy::ScalaTympani& scala,
                               const electrode::ArrayDesign& array, anatomy::Side side,
                               Quality quality, const SceneStyle& style)
    : content_(std::make_unique<Content>(scala, array, side, quality, style))
{
  lookFrom(CameraPreset::surgeon);
}

InsertionScene::~InsertionScene() = default;

void InsertionScene::attachTo(vtkRenderWindow& window)
{
  window.SetMultiSamples(0);
  window.AddRenderer(content_->renderer);
  content_->window = &window;
  content_->applyStereo();
}

void InsertionScene::Content::applyStereo()
{
  if (window == nullptr) return;
  renderer->GetActiveCamera()->SetEyeAngle(eyeAngle_deg);
  window->SetStereoRender(stereo != Stereo::off);
  switch (stereo) {
    case Stereo::off:
      break;
    case Stereo::anaglyph:
      window->SetStereoTypeToAnaglyph();
      break;
    case Stereo::sideBySide:
      window->SetStereoTypeToSplitViewportHorizontal();
      break;
    case Stereo::interlaced:
      window->SetStereoTypeToInterlaced();
      break;
    case Stereo::quadBuffered:
      window->SetStereoTypeToCrystalEyes();
      break;
  }
  // at its distance its shading would have a large disparity
  backdrop.actor().SetVisibility(stereo == Stereo::off);
}

void InsertionScene::setStereo(Stereo stereo)
{
  content_->stereo = stereo;
  content_->applyStereo();
}

Stereo InsertionScene::stereo() const noexcept { return content_->stereo; }

bool InsertionScene::isVisible(Part part) const
{
  return content_->isVisible[static_cast<std::size_t>(part)];
}

vtkRenderer& InsertionScene::renderer() { return *content_->renderer; }

void InsertionScene::setApproach(const anatomy::Approach& approach)
{
  Content& c = *content_;
  c.fixedLandmarks.approach = approachLine(c.entry, approach);
  if (c.bone.isVisible()) c.bone.setLandmarks(c.landmarks());
}

BoneLayer& InsertionScene::bone() { return content_->bone; }

void InsertionScene::setRestingPartsKept(bool areKept) { content_->resting->setKept(areKept); }

double InsertionScene::drawnFraction() const { return content_->resting->drawnFraction(); }

void InsertionScene::show(const haptics::Snapshot& now)
{
  Content& scene = *content_;
  const bool wasEmpty = scene.path.isEmpty();
  scene.path.follow(now, scene.space);
  if (scene.path.isEmpty()) {
    scene.field.clear();
  } else {
    scene.arrayParts.show(scene.path, 1e3 * now.output.styletWithdrawal);
    scene.field.follow(now, scene.space, scene.path, scene.arrayParts);
  }
  if (scene.isVisible[static_cast<std::size_t>(Part::wallForce)])
    scene.scalaParts.color(scene.field);
  scene.scalaParts.tear(std::span(now.ruptured).first(now.ruptures));
  if (wasEmpty != scene.path.isEmpty()) scene.applyVisibility();
  scene.arrayMoved = true;
}

void InsertionScene::showGhost(const electrode::ArrayDesign& array,
                               std::span<const Eigen::Vector3d> nodes_W)
{
  content_->ghost.show(array, nodes_W, content_->space);
  content_->arrayMoved = true;
}

void InsertionScene::setVisible(Part part, bool visible)
{
  Content& scene = *content_;
  scene.isVisible[static_cast<std::size_t>(part)] = visible;
  if (part == Part::wallForce)
    scene.scalaParts.color(visible ? scene.field : ContactField{millimeters(0)});
  scene.applyVisibility();
}

void InsertionScene::showPartsOf(const InsertionScene& other)
{
  for (std::size_t part = 0; part < partCount; ++part)
    setVisible(static_cast<Part>(part), other.content_->isVisible[part]);
}

void InsertionScene::setScale(double pixelRatio) { content_->pixelRatio = pixelRatio; }

void InsertionScene::setScaleBarMargin(int pixels)
{
  if (pixels == content_->bars->bottom_px) return;
  content_->bars->bottom_px = pixels;
  content_->bars->Modified();
}

void InsertionScene::setFreeArea(const FreeArea& area) { content_->area = area; }

void InsertionScene::lookFrom(CameraPreset preset)
{
  content_->preset = preset;
  content_->camera.jump(content_->presetPoseNow());
  content_->placeCamera();
}

void InsertionScene::lookAs(const InsertionScene& other)
{
  content_->preset = other.content_->preset;
  content_->isFramed = false;
  content_->camera.jump(other.content_->camera.pose());
  content_->placeCamera();
}

void InsertionScene::keepViewOf(const InsertionScene& other)
{
  if (other.content_->area) content_->area = other.content_->area;
  lookFrom(other.preset());
  if (other.content_->isFramed) return;
  setMagnification(other.content_->camera.target().magnification);
}

void InsertionScene::glideTo(CameraPreset preset)
{
  content_->preset = preset;
  content_->camera.glide(content_->presetPoseNow());
}

bool InsertionScene::stepCamera(double seconds)
{
  Content& scene = *content_;
  bool moves = scene.camera.step(seconds);
  if (scene.preset == CameraPreset::followTip) {
    const Eigen::Vector3d before = scene.camera.pose().focus;
    scene.camera.follow(scene.tip(), seconds);
    moves = moves || (scene.camera.pose().focus - before).norm() > 0.1 * scene.bars->pixel_mm;
  }
  scene.placeCamera();
  return moves;
}

CameraPreset InsertionScene::preset() const noexcept { return content_->preset; }

void InsertionScene::setMagnification(double times)
{
  content_->isFramed = false;
  content_->camera.take().magnification = std::clamp(times, minMagnification, maxMagnification);
  content_->placeCamera();
}

double InsertionScene::magnification() const noexcept
{
  return content_->camera.pose().magnification;
}

void InsertionScene::rotateModel(double azimuth_deg, double elevation_deg, double roll_deg)
{
  using Turn = Eigen::AngleAxisd;
  content_->isFramed = false;
  CameraPose& pose = content_->camera.take();
  // Rotating the model one way is rotating the camera the other way.
  pose.axes = pose.axes * Turn(-degrees(azimuth_deg).si(), Eigen::Vector3d::UnitY()) *
              Turn(degrees(elevation_deg).si(), Eigen::Vector3d::UnitX()) *
              Turn(-degrees(roll_deg).si(), Eigen::Vector3d::UnitZ());
  pose.axes.normalize();
  content_->placeCamera();
}

void InsertionScene::moveModel(double right_mm, double up_mm)
{
  content_->isFramed = false;
  CameraPose& pose = content_->camera.take();
  pose.focus -= pose.axes * Eigen::Vector3d(right_mm, up_mm, 0.0);
  content_->placeCamera();
}

void InsertionScene::zoom(double factor)
{
  if (factor > 0.0) setMagnification(magnification() * factor);
}

double InsertionScene::scaleBarLength_mm() const { return content_->bars->barLength_mm(); }

}  // namespace perilymph::visualization
