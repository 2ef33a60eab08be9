// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/CtBone.h"

#include <algorithm>
#include <cmath>
#include <stop_token>
#include <utility>

#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/ct/ViewPlane.h"
#include "perilymph/imaging/BoneSurface.h"
#include "perilymph/imaging/MeasuredPatient.h"
#include "perilymph/visualization/InsertionScene.h"

namespace perilymph::gui {

namespace {

using visualization::BoneModel;

constexpr double m = 1e-3;  // in a millimeter
constexpr double reach_mm =
    9.5;  // of the bone about a cochlea: its basal turn with the round window
// Edges of the triangles, at rest and while the picture turns: 15 frames a second on a CPU.
constexpr double fine_mm = 0.28, coarseTimes = 2.0;

/// Bone in P [m], by a request for its fine surface.
std::shared_ptr<BoneModel> boneIn(const std::shared_ptr<const ct::CtVolume>& volume,
                                  imaging::BoneRequest request)
{
  auto bone = std::make_shared<BoneModel>();
  bone->fine = imaging::boneSurface(*volume, request);
  request.step_mm *= coarseTimes;
  bone->coarse = imaging::boneSurface(*volume, request);
  bone->intensity = [volume](const Eigen::Vector3d& point) { return volume->sample(point / m); };
  bone->level = request.level;
  bone->contrast = request.contrast;
  bone->center = m * request.center_P;
  bone->radius = m * request.radius_mm;
  // seen from the feet, as radiologists look at axial slices
  bone->cut = {bone->center, -Eigen::Vector3d::UnitZ()};
  return bone;
}

/// The same surface in the frame of the anatomy [m].
anatomy::Surface inFrameW(const anatomy::Surface& surface, const ct::CochleaMeasures& measures)
{
  anatomy::Surface moved = surface;
  for (auto& point : moved.points) {
    const Eigen::Vector3d at_W =
        measures.anatomyAxes_PW.transpose() *
        (Eigen::Vector3d(point[0], point[1], point[2]) - m * measures.anatomyOrigin_P);
    point = {at_W.x(), at_W.y(), at_W.z()};
  }
  if (measures.anatomyAxes_PW.determinant() < 0.0)
    for (auto& corners : moved.triangles) std::swap(corners[1], corners[2]);
  return moved;
}

}  // namespace

CtBone::CtBone(CtStudy& study, QObject* parent) : QObject(parent), study_(study), background_(this)
{
  connect(&study_, &CtStudy::modelChanged, this, &CtBone::follow);
}

CtBone::Made CtBone::make(const std::shared_ptr<const ct::CtVolume>& volume,
                          const std::shared_ptr<const ct::CochleaMeasures>& measures,
                          const std::stop_token& stop)
{
  imaging::BoneRequest request = imaging::wholeBone(*volume);
  request.stop = stop;
  Made made;
  if (!measures) {
    made.inPatient = boneIn(volume, request);
    return made;
  }
  const double contrast = std::fabs(measures->boneLevel - measures->lumenLevel);
  request.center_P = ct::basalTurnCenter_P(*measures);
  request.radius_mm = reach_mm;
  request.level = 0.5 * (measures->boneLevel + measures->lumenLevel);  // as its wall is measured
  request.contrast = std::max(1.0, contrast);
  request.step_mm = fine_mm;
  const auto bone = boneIn(volume, request);
  bone->cut.removed = measures->axis_P;  // the cochlear view
  const auto inAnatomy = std::make_shared<BoneModel>(*bone);
  inAnatomy->fine = inFrameW(bone->fine, *measures);
  inAnatomy->coarse = inFrameW(bone->coarse, *measures);
  inAnatomy->intensity = [volume, measures](const Eigen::Vector3d& point_W) {
    return volume->sample(measures->fromAnatomy(point_W));
  };
  inAnatomy->center =
      measures->anatomyAxes_PW.transpose() * (bone->center - m * measures->anatomyOrigin_P);
  inAnatomy->cut = {inAnatomy->center, measures->anatomyAxes_PW.transpose() * bone->cut.removed};
  made.inPatient = bone;
  made.inAnatomy = inAnatomy;

  const auto place = [&measures](const Eigen::Vector3d& point_W) -> Eigen::Vector3d {
    return m * measures->fromAnatomy(point_W);
  };
  made.landmarks.roundWindow = m * measures->roundWindow_P;
  const auto scala = anatomy::buildAnatomy(
      {anatomy::AnatomySource::mean, imaging::measuredPatient(*measures)}, "the measured cochlea");
  if (!scala) return made;  // the bone is shown without lines
  const visualization::SceneLandmarks lines = visualization::landmarksOf(**scala);
  made.landmarks.axis = {place((*lines.axis)[0]), place((*lines.axis)[1])};
  made.landmarks.approach = {place((*lines.approach)[0]), place((*lines.approach)[1])};
  return made;
}

void CtBone::follow()
{
  if (study_.volume() == volume_ && study_.measures() == measures_) return;
  const bool isSameCt = study_.volume() == volume_;
  volume_ = study_.volume();
  measures_ = study_.measures();
  background_.cancel();
  // around another fit the bone of the whole CT is as right as before
  const auto whole = isSameCt ? made_.inPatient : nullptr;
  made_ = {};
  made_.inPatient = whole;
  Q_EMIT changed();
  if (!volume_) return;
  background_.run(
      "The bone of the CT",
      [volume = volume_, measures = measures_](const std::stop_token& stop) -> Result<Made> {
        return make(volume, measures, stop);
      },
      [this](const Result<Made>& made) {
        if (!made) return;  // the planes show the CT
        made_ = *made;
        Q_EMIT changed();
      });
}

visualization::SceneLandmarks CtBone::landmarks() const
{
  visualization::SceneLandmarks landmarks = made_.landmarks;
  for (const Eigen::Vector3d& contact : study_.array().contacts_P)
    landmarks.contacts.push_back(m * contact);
  return landmarks;
}

}  // namespace perilymph::gui
