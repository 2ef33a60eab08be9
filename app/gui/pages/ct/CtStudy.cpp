// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/CtStudy.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace perilymph::gui {

namespace {

constexpr double minPixel_mm = 0.005, maxPixel_mm = 2.0;
constexpr double wholePicture_px = 400.0;   // of a typical view, so that a whole volume fits
constexpr double cochleaPicture_mm = 16.0;  // the basal turn with its surroundings
constexpr std::size_t maxUndo = 100;

}  // namespace

void CtStudy::setCt(imaging::LoadedCt ct)
{
  volume_ = std::make_shared<const ct::CtVolume>(std::move(ct.volume));
  sampler_ = std::make_unique<imaging::PlaneSampler>(volume_);
  series_ = std::move(ct.series);
  measures_.reset();
  frame_ = PlaneFrame::patient;
  marks_ = {};
  isByHand_ = {};
  array_ = {};
  undoStack_.clear();
  redoStack_.clear();
  crosshair_P_ = volume_->center_P();
  isCrosshairPlaced_ = false;
  // cone-beam scanners have gray values of their own
  const imaging::GrayWindow whole = imaging::wholeWindow(*volume_);
  window_ = series_.modality == "CT" ? imaging::boneWindow : whole;
  Q_EMIT modelChanged();
  showWhole();
}

void CtStudy::setMeasures(ct::CochleaMeasures measures)
{
  beginChange();
  measures_ = std::move(measures);
  marks_ = ct::marksOf(*measures_);
  for (std::size_t k = 0; k < ct::markCount; ++k) {
    const auto& placed = measures_->marksByHand.points_P[k];
    isByHand_[k] = placed.has_value();
    if (placed) marks_.points_P[k] = placed;
  }
  array_ = {};
  frame_ = PlaneFrame::cochlea;
  crosshair_P_ = ct::basalTurnCenter_P(*measures_);
  Q_EMIT modelChanged();
  showWhole();
}

void CtStudy::announceModel()
{
  Q_EMIT modelChanged();
  Q_EMIT changed();
}

void CtStudy::setFrame(PlaneFrame frame)
{
  if (frame == PlaneFrame::cochlea && !measures_) return;
  frame_ = frame;
  if (frame == PlaneFrame::cochlea) crosshair_P_ = ct::basalTurnCenter_P(*measures_);
  showWhole();
}

std::array<ct::ViewPlane, 3> CtStudy::planes() const
{
  auto planes = frame_ == PlaneFrame::cochlea && measures_
                    ? ct::cochlearPlanes(*measures_, center_P_)
                    : ct::patientPlanes(center_P_);
  for (ct::ViewPlane& plane : planes) plane.center_P += plane.behind(crosshair_P_) * plane.away_P();
  return planes;
}

void CtStudy::moveCrosshair(const Eigen::Vector3d& point_P)
{
  if (!hasCt() || !volume_->contains(point_P)) return;
  crosshair_P_ = point_P;
  isCrosshairPlaced_ = true;
  Q_EMIT changed();
}

void CtStudy::pan(const Eigen::Vector3d& by_P)
{
  center_P_ += by_P;
  Q_EMIT changed();
}

void CtStudy::zoom(double factor)
{
  pixel_mm_ = std::clamp(pixel_mm_ / factor, minPixel_mm, maxPixel_mm);
  Q_EMIT changed();
}

void CtStudy::showWhole()
{
  if (!hasCt()) return;
  if (frame_ == PlaneFrame::cochlea) {
    center_P_ = crosshair_P_;
    pixel_mm_ = cochleaPicture_mm / wholePicture_px;
  } else {
    center_P_ = volume_->center_P();
    const auto& size = volume_->size();
    const Eigen::Vector3d extent =
        volume_->spacing_mm().cwiseProduct(Eigen::Vector3d(size[0], size[1], size[2]));
    pixel_mm_ = std::clamp(extent.maxCoeff() / wholePicture_px, minPixel_mm, maxPixel_mm);
  }
  Q_EMIT changed();
}

void CtStudy::setWindow(const imaging::GrayWindow& window)
{
  window_ = {window.center, std::max(1.0, window.width)};
  Q_EMIT changed();
}

void CtStudy::setSlab(double thickness_mm, imaging::Projection projection)
{
  thickness_mm_ = thickness_mm;
  projection_ = projection;
  Q_EMIT changed();
}

void CtStudy::setArray(InsertedArray array)
{
  if (array.nodes.empty() && array_.nodes.empty()) return;
  array_ = std::move(array);
  announceModel();
}

ct::MarkedMeasures CtStudy::marked() const
{
  return ct::measuresBetween(
      marks_, measures_ ? std::optional<Eigen::Vector3d>(measures_->axis_P) : std::nullopt);
}

ct::Marks CtStudy::marksByHand() const
{
  ct::Marks placed;
  for (std::size_t k = 0; k < ct::markCount; ++k)
    if (isByHand_[k]) placed.points_P[k] = marks_.points_P[k];
  return placed;
}

void CtStudy::beginChange()
{
  undoStack_.push_back({marks_, isByHand_});
  if (undoStack_.size() > maxUndo) undoStack_.erase(undoStack_.begin());
  redoStack_.clear();
}

void CtStudy::placeMark(ct::Mark mark, const Eigen::Vector3d& point_P)
{
  if (!hasCt() || !volume_->contains(point_P)) return;
  marks_[mark] = point_P;
  isByHand_[static_cast<std::size_t>(mark)] = true;
  announceModel();
}

void CtStudy::setMarks(const ct::Marks& marks)
{
  beginChange();
  marks_ = marks;
  for (std::size_t k = 0; k < ct::markCount; ++k) isByHand_[k] = marks.points_P[k].has_value();
  announceModel();
}

void CtStudy::restore(std::vector<Placement>& from, std::vector<Placement>& to)
{
  if (from.empty()) return;
  to.push_back({marks_, isByHand_});
  marks_ = from.back().marks;
  isByHand_ = from.back().isByHand;
  from.pop_back();
  announceModel();
}

void CtStudy::undo() { restore(undoStack_, redoStack_); }

void CtStudy::redo() { restore(redoStack_, undoStack_); }

}  // namespace perilymph::gui
