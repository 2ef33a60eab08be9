// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/CtStudy.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "gui/run/ScenarioApproach.h"
#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/imaging/MeasuredPatient.h"

namespace perilymph::gui {

namespace {

constexpr double minPixel_mm = 0.005, maxPixel_mm = 2.0;
constexpr double largestPicture_px = 400.0;  // a larger view shows more around
constexpr double minPicture_px = 64.0;       // of a picture in which anything can be seen (choice)
constexpr double cochleaPicture_mm = 16.0;   // the basal turn with its surroundings
constexpr std::size_t maxUndo = 100;
constexpr double keptApproach_mm = 20.0;  // of the line, outside: no angle depends on it

/// The opening of the anatomy that is built from measures.
std::optional<anatomy::Entry> openingOf(const ct::CochleaMeasures& measures)
{
  const auto scala = anatomy::buildAnatomy(
      {anatomy::AnatomySource::mean, imaging::measuredPatient(measures)}, "the measured cochlea");
  if (!scala) return std::nullopt;
  return (*scala)->entry();
}

Angle toTenths(Angle angle) { return degrees(std::round(10.0 * inDegrees(angle)) / 10.0); }

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
  chosenMarkup_.reset();
  tool_.reset();
  toolPoints_P_.clear();
}

void CtStudy::clear()
{
  if (!hasCt()) return;
  removeAll();
  volume_.reset();
  sampler_.reset();
  series_ = {};
  Q_EMIT markupsChanged();
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
  Q_EMIT markupsChanged();
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
  const auto outward = pointsOf(ct::MarkupKind::approach);
  now_.opening = openingOf(*now_.measures);
  // the line keeps its direction in the patient, through the opening as it is now
  if (now_.opening && outward.size() == 2)
    keepLine(anatomy::withinLimits(
        ct::approachAlong(*now_.measures, *now_.opening, outward[0] - outward[1])));
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

std::optional<anatomy::Approach> CtStudy::approach() const
{
  if (!now_.opening) return std::nullopt;
  const std::vector<Eigen::Vector3d> line = pointsOf(ct::MarkupKind::approach);
  if (line.size() != 2) return anatomy::Approach{};
  return anatomy::withinLimits(ct::approachAlong(*now_.measures, *now_.opening, line[0] - line[1]));
}

std::optional<ct::ApproachLine> CtStudy::approachLine() const
{
  const auto shown = approach();
  if (!shown) return std::nullopt;
  return ct::approachLine(*now_.measures, *now_.opening, *shown);
}

std::optional<anatomy::BasalTurnAngles> CtStudy::approachAngles() const
{
  const auto shown = approach();
  if (!shown) return std::nullopt;
  return anatomy::anglesToBasalTurn(*shown, *now_.opening);
}

bool CtStudy::isApproachAtLimit() const
{
  const auto shown = approach();
  const auto isSteepest = [](Angle angle) {
    return std::fabs(inDegrees(angle)) > anatomy::steepestApproach_deg - 1e-6;
  };
  return shown && (isSteepest(shown->tilt) || isSteepest(shown->turn));
}

void CtStudy::turnApproach(const Eigen::Vector3d& outward_P)
{
  if (!now_.opening) return;
  const anatomy::Approach wanted =
      anatomy::withinLimits(ct::approachAlong(*now_.measures, *now_.opening, outward_P));
  turnApproach(anatomy::anglesToBasalTurn(wanted, *now_.opening));
}

void CtStudy::turnApproach(const anatomy::BasalTurnAngles& angles)
{
  if (!now_.opening) return;
  keepChange();
  const anatomy::Approach turned = anatomy::withinLimits(
      anatomy::approachAt({toTenths(angles.inPlane), toTenths(angles.outOfPlane)}, *now_.opening));
  keepLine(turned);
  Q_EMIT approachMoved();
}

void CtStudy::keepLine(const anatomy::Approach& approach)
{
  std::erase_if(now_.markups,
                [](const ct::Markup& each) { return each.kind == ct::MarkupKind::approach; });
  chosenMarkup_.reset();  // others may have another place now
  Q_EMIT markupsRenumbered();
  if (isAlongAxis(approach)) return;
  const ct::ApproachLine line = ct::approachLine(*now_.measures, *now_.opening, approach);
  now_.markups.push_back({ct::MarkupKind::approach, {line.at(keptApproach_mm), line.opening_P}});
}

void CtStudy::endChange()
{
  isChangeOpen_ = false;
  Q_EMIT markupsChanged();
  announceModel();
  Q_EMIT approachGiven();
}

void CtStudy::resetApproach()
{
  if (!isApproachTurned()) return;
  beginChange();
  keepChange();
  keepLine({});
  endChange();
}

void CtStudy::showApproach(const anatomy::Approach& approach)
{
  if (!now_.opening || areSame(*this->approach(), approach)) return;
  keepLine(approach);
  announceMarkups();
}

std::vector<Eigen::Vector3d> CtStudy::pointsOf(ct::MarkupKind structure) const
{
  const auto found = std::ranges::find(now_.markups, structure, &ct::Markup::kind);
  return found == now_.markups.end() ? std::vector<Eigen::Vector3d>() : found->points_P;
}

void CtStudy::addPoint(ct::MarkupKind structure, const Eigen::Vector3d& point_P)
{
  if (!hasCt() || !volume_->contains(point_P)) return;
  const auto found = std::ranges::find(now_.markups, structure, &ct::Markup::kind);
  const bool isNew = found == now_.markups.end();
  if (!isNew && found->points_P.size() >= ct::pointCountOf(structure).most) return;
  const auto place = found - now_.markups.begin();
  beginChange();
  keepChange();
  if (isNew)
    now_.markups.push_back({structure, {point_P}});
  else
    now_.markups[std::size_t(place)].points_P.push_back(point_P);
  announceMarkups();
}

void CtStudy::removeStructure(ct::MarkupKind structure)
{
  if (pointsOf(structure).empty()) return;
  beginChange();
  keepChange();
  std::erase_if(now_.markups,
                [structure](const ct::Markup& each) { return each.kind == structure; });
  isChangeOpen_ = false;
  Q_EMIT markupsRenumbered();
  announceMarkups();
}

std::optional<ct::DistanceToLine> CtStudy::distanceFromApproach(ct::MarkupKind structure) const
{
  const auto line = approachLine();
  const std::vector<Eigen::Vector3d> points = pointsOf(structure);
  if (!line || points.empty()) return std::nullopt;
  return ct::distanceToLine(points, *line, ct::markupsOf(*volume_).voxelEdges_P);
}

void CtStudy::keepChange()
{
  if (!isChangeOpen_) keepForUndo();
  isChangeOpen_ = true;
}

void CtStudy::placeMark(ct::Mark mark, const Eigen::Vector3d& point_P)
{
  if (!hasCt() || !volume_->contains(point_P)) return;
  keepChange();
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

ct::CtMarkups CtStudy::ctMarkups() const
{
  if (!hasCt()) return {};
  ct::CtMarkups markups = ct::markupsOf(*volume_);
  markups.seriesKey = series_.key;
  markups.markups = now_.markups;
  return markups;
}

void CtStudy::announceMarkups()
{
  Q_EMIT markupsChanged();
  Q_EMIT changed();
}

void CtStudy::showMarkups(std::vector<ct::Markup> markups)
{
  now_.markups = std::move(markups);
  chosenMarkup_.reset();
  Q_EMIT markupsRenumbered();
  announceMarkups();
}

Result<void> CtStudy::addMarkups(const std::vector<ct::Markup>& markups)
{
  if (!hasCt() || markups.empty()) return {};
  ct::CtMarkups whole = ctMarkups();
  for (whole.markups.clear(); const ct::Markup& each : markups)
    if (std::ranges::find(now_.markups, each) == now_.markups.end()) whole.markups.push_back(each);
  if (whole.markups.empty()) return {};  // all are there
  if (const auto note = ct::outsideNote(whole, *volume_)) return Error(*note);
  const auto isApproach = [](const ct::Markup& each) {
    return each.kind == ct::MarkupKind::approach;
  };
  const bool isTurned = std::ranges::any_of(markups, isApproach);
  whole.markups.insert(whole.markups.begin(), now_.markups.begin(), now_.markups.end());
  if (isTurned) {  // there is one line of approach: the last one
    const ct::Markup line = *std::find_if(whole.markups.rbegin(), whole.markups.rend(), isApproach);
    std::erase_if(whole.markups, isApproach);
    whole.markups.push_back(line);
  }
  if (const auto possible = ct::checkMarkups(whole); !possible) return possible;
  keepForUndo();
  isChangeOpen_ = false;
  now_.markups = std::move(whole.markups);
  chosenMarkup_ = now_.markups.size() - 1;
  announceMarkups();
  if (isTurned) Q_EMIT approachGiven();
  return {};
}

void CtStudy::moveMarkupPoint(const MarkupPoint& which, const Eigen::Vector3d& point_P)
{
  if (!hasCt() || !volume_->contains(point_P) || which.markup >= now_.markups.size()) return;
  ct::Markup moved = now_.markups[which.markup];
  if (which.point >= moved.points_P.size()) return;
  moved.points_P[which.point] = point_P;
  if (!ct::checkMarkup(moved)) return;
  if (!isChangeOpen_) keepForUndo();
  isChangeOpen_ = true;
  now_.markups[which.markup] = std::move(moved);
  announceMarkups();
}

Result<void> CtStudy::setMarkupText(std::size_t which, const std::string& text)
{
  if (which >= now_.markups.size() || now_.markups[which].text == text) return {};
  ct::Markup named = now_.markups[which];
  named.text = text;
  if (const auto possible = ct::checkMarkup(named); !possible) return possible;
  keepForUndo();
  isChangeOpen_ = false;
  now_.markups[which] = std::move(named);
  announceMarkups();
  return {};
}

void CtStudy::removeMarkup(std::size_t which)
{
  if (which >= now_.markups.size()) return;
  keepForUndo();
  isChangeOpen_ = false;
  now_.markups.erase(now_.markups.begin() + static_cast<std::ptrdiff_t>(which));
  chosenMarkup_.reset();
  Q_EMIT markupsRenumbered();
  announceMarkups();
}

void CtStudy::chooseMarkup(std::optional<std::size_t> which)
{
  chosenMarkup_ = which && *which < now_.markups.size() ? which : std::nullopt;
  Q_EMIT changed();
}

void CtStudy::setTool(std::optional<ct::MarkupKind> tool)
{
  tool_ = hasCt() ? tool : std::nullopt;
  toolPoints_P_.clear();
  Q_EMIT changed();
}

void CtStudy::placeToolPoint(const Eigen::Vector3d& point_P)
{
  if (!tool_ || !hasCt() || !volume_->contains(point_P)) return;
  toolPoints_P_.push_back(point_P);
  if (toolPoints_P_.size() == ct::pointCountOf(*tool_).least) {
    const ct::Markup whole{*tool_, std::exchange(toolPoints_P_, {})};
    if (addMarkups({whole})) return;
  }
  Q_EMIT changed();  // also where two points at one place are no markup: it is begun again
}

void CtStudy::restore(std::vector<Placement>& from, std::vector<Placement>& to)
{
  if (from.empty()) return;
  if (from.back().measures != now_.measures) array_ = {};  // it lies in the other cochlea
  to.push_back(std::exchange(now_, std::move(from.back())));
  from.pop_back();
  isChangeOpen_ = false;
  chosenMarkup_.reset();
  Q_EMIT markupsRenumbered();
  Q_EMIT markupsChanged();
  if (!now_.measures && frame_ == PlaneFrame::cochlea) {
    frame_ = PlaneFrame::patient;
    Q_EMIT modelChanged();
    return showWhole();
  }
  announceMarkups();
  Q_EMIT approachGiven();
}

void CtStudy::undo()
{
  if (toolPoints_P_.empty()) return restore(undoStack_, redoStack_);
  toolPoints_P_.pop_back();
  Q_EMIT changed();
}

void CtStudy::redo() { restore(redoStack_, undoStack_); }

}  // namespace perilymph::gui
