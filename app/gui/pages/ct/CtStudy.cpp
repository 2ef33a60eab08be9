// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/CtStudy.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace perilymph::gui {

namespace {

constexpr double minPixel_mm = 0.005, maxPixel_mm = 2.0;
constexpr double largestPicture_px = 400.0;  // a larger view shows more around
constexpr double minPicture_px = 64.0;       // of a picture in which anything can be seen (choice)
constexpr double cochleaPicture_mm = 16.0;   // the basal turn with its surroundings
constexpr std::size_t maxUndo = 100;

}  // namespace

void CtStudy::removeAll()
{
  now_ = {};
  isChangeOpen_ = false;
  frame_ = PlaneFrame::patient;
  array_ = {};
  contacts_.clear();
  chosenContact_ = 0;
  undoStack_.clear();
  redoStack_.clear();
  isCrosshairPlaced_ = false;
}

void CtStudy::clear()
{
  if (!hasCt()) return;
  removeAll();
  volume_.reset();
  sampler_.reset();
  series_ = {};
  announceModel();
}

void CtStudy::setCt(imaging::LoadedCt ct)
{
  removeAll();
  volume_ = std::make_shared<const ct::CtVolume>(std::move(ct.volume));
  sampler_ = std::make_unique<imaging::PlaneSampler>(volume_);
  series_ = std::move(ct.series);
  crosshair_P_ = volume_->center_P();
  // cone-beam scanners have gray values of their own
  const imaging::GrayWindow whole = imaging::wholeWindow(*volume_);
  window_ = series_.modality == "CT" ? imaging::boneWindow : whole;
  Q_EMIT modelChanged();
  showWhole();
}

void CtStudy::setMeasures(ct::CochleaMeasures measures, const ct::Marks& atRequest)
{
  const ct::Marks byHand = marksByHand();
  keepForUndo();
  isChangeOpen_ = false;
  now_.marks = ct::marksOf(measures);
  for (std::size_t k = 0; k < ct::markCount; ++k) {
    const bool isChangedSince = byHand.points_P[k] != atRequest.points_P[k];
    const auto& placed = (isChangedSince ? byHand : measures.marksByHand).points_P[k];
    now_.isByHand[k] = placed.has_value();
    if (placed) now_.marks.points_P[k] = placed;
  }
  now_.former = std::move(now_.measures);
  showMeasured(std::move(measures));
}

void CtStudy::showMeasured(ct::CochleaMeasures measures)
{
  now_.measures = std::make_shared<const ct::CochleaMeasures>(std::move(measures));
  array_ = {};
  frame_ = PlaneFrame::cochlea;
  crosshair_P_ = ct::basalTurnCenter_P(*now_.measures);
  Q_EMIT modelChanged();
  showWhole();
}

bool CtStudy::isStale() const
{
  return now_.measures && marksByHand() != now_.measures->marksByHand;
}

void CtStudy::announceModel()
{
  Q_EMIT modelChanged();
  Q_EMIT changed();
}

void CtStudy::setFrame(PlaneFrame frame)
{
  if (frame == PlaneFrame::cochlea && !now_.measures) return;
  frame_ = frame;
  if (frame == PlaneFrame::cochlea) crosshair_P_ = ct::basalTurnCenter_P(*now_.measures);
  showWhole();
}

std::array<ct::ViewPlane, 3> CtStudy::planes() const
{
  auto planes = frame_ == PlaneFrame::cochlea && now_.measures
                    ? ct::cochlearPlanes(*now_.measures, center_P_)
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

void CtStudy::setPicture_px(double edge_px)
{
  if (edge_px < minPicture_px) return;  // not laid out yet: its scale would be cut at a limit
  const double before = std::exchange(picture_px_, std::min(edge_px, largestPicture_px));
  if (before != picture_px_) zoom(picture_px_ / before);
}

void CtStudy::showWhole()
{
  if (!hasCt()) return;
  if (frame_ == PlaneFrame::cochlea) {
    center_P_ = crosshair_P_;
    pixel_mm_ = cochleaPicture_mm / picture_px_;
  } else {
    center_P_ = volume_->center_P();
    const auto& size = volume_->size();
    const Eigen::Vector3d extent =
        volume_->spacing_mm().cwiseProduct(Eigen::Vector3d(size[0], size[1], size[2]));
    pixel_mm_ = std::clamp(extent.maxCoeff() / picture_px_, minPixel_mm, maxPixel_mm);
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

void CtStudy::showEar(ct::CochleaMeasures measures)
{
  now_ = {};
  undoStack_.clear();
  redoStack_.clear();
  showMeasured(std::move(measures));
}

void CtStudy::setContacts(std::vector<Contact> contacts)
{
  contacts_ = std::move(contacts);
  announceModel();
}

void CtStudy::moveContact(int number, const Eigen::Vector3d& point_P)
{
  if (!hasCt() || !volume_->contains(point_P)) return;
  for (Contact& each : contacts_)
    if (each.number == number) each.at_P = point_P;
  announceModel();
}

void CtStudy::chooseContact(int number)
{
  chosenContact_ = number;
  for (const Contact& each : contacts_)
    if (each.number == number) return moveCrosshair(each.at_P);
  Q_EMIT changed();
}

ct::MarkedMeasures CtStudy::marked() const
{
  return ct::measuresBetween(now_.marks, now_.measures
                                             ? std::optional<Eigen::Vector3d>(now_.measures->axis_P)
                                             : std::nullopt);
}

ct::Marks CtStudy::marksByHand() const
{
  ct::Marks placed;
  for (std::size_t k = 0; k < ct::markCount; ++k)
    if (now_.isByHand[k]) placed.points_P[k] = now_.marks.points_P[k];
  return placed;
}

void CtStudy::keepForUndo()
{
  undoStack_.push_back(now_);
  if (undoStack_.size() > maxUndo) undoStack_.erase(undoStack_.begin());
  redoStack_.clear();
}

void CtStudy::placeMark(ct::Mark mark, const Eigen::Vector3d& point_P)
{
  if (!hasCt() || !volume_->contains(point_P)) return;
  if (!isChangeOpen_) keepForUndo();
  isChangeOpen_ = true;
  now_.marks[mark] = point_P;
  now_.isByHand[static_cast<std::size_t>(mark)] = true;
  announceModel();
}

void CtStudy::setMarks(const ct::Marks& marks)
{
  keepForUndo();
  isChangeOpen_ = false;
  now_.marks = marks;
  for (std::size_t k = 0; k < ct::markCount; ++k) now_.isByHand[k] = marks.points_P[k].has_value();
  announceModel();
}

void CtStudy::restore(std::vector<Placement>& from, std::vector<Placement>& to)
{
  if (from.empty()) return;
  if (from.back().measures != now_.measures) array_ = {};  // it lies in the other cochlea
  to.push_back(std::exchange(now_, std::move(from.back())));
  from.pop_back();
  isChangeOpen_ = false;
  if (!now_.measures && frame_ == PlaneFrame::cochlea) {
    frame_ = PlaneFrame::patient;
    Q_EMIT modelChanged();
    return showWhole();
  }
  announceModel();
}

void CtStudy::undo() { restore(undoStack_, redoStack_); }

void CtStudy::redo() { restore(redoStack_, undoStack_); }

}  // namespace perilymph::gui
