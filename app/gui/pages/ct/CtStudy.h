// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The CT that is looked at: volume, planes, crosshair, measures and landmarks.

#include <QObject>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/anatomy/Approach.h"
#include "perilymph/ct/ApproachLine.h"
#include "perilymph/ct/Marks.h"
#include "perilymph/ct/Markups.h"
#include "perilymph/ct/Measures.h"
#include "perilymph/ct/ViewPlane.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/imaging/PlaneSampler.h"

namespace perilymph::gui {

/// The directions of the three linked planes.
enum class PlaneFrame { patient, cochlea };

/// Magnification by a notch of the wheel.
inline constexpr double zoomPerNotch = 1.2;

/// State of the page CT. All positions are in P, the patient's LPS [mm].
class CtStudy : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;

  /// Shows a volume; removes measures and landmarks of the previous one.
  void setCt(imaging::LoadedCt ct);
  /// Shows no volume.
  void clear();
  bool hasCt() const { return volume_ != nullptr; }
  const std::shared_ptr<const ct::CtVolume>& volume() const { return volume_; }
  const imaging::CtSeries& series() const { return series_; }
  imaging::PlaneSampler& sampler() { return *sampler_; }

  /// Shows measures: the planes become those of the cochlea, landmarks are proposed except for those
  /// that steered the fit, which stay where they were placed. One step for undo.
  ///
  /// @param atRequest  marksByHand() when the measurement began: what the user changed since stays.
  void setMeasures(ct::CochleaMeasures measures, const ct::Marks& atRequest);
  void setMeasures(ct::CochleaMeasures measures)
  {
    setMeasures(std::move(measures), marksByHand());
  }
  /// The fit; null without one. It belongs to the landmarks unless isStale().
  const std::shared_ptr<const ct::CochleaMeasures>& measures() const { return now_.measures; }
  /// The fit before this one in the same CT; null without one.
  const std::shared_ptr<const ct::CochleaMeasures>& former() const { return now_.former; }
  /// Whether landmarks by hand are others than those that steered the fit.
  bool isStale() const;

  PlaneFrame frame() const { return frame_; }
  /// Turns the planes; those of the cochlea need measures.
  void setFrame(PlaneFrame frame);
  /// The planes through the crosshair, centered where the pictures are.
  std::array<ct::ViewPlane, 3> planes() const;

  const Eigen::Vector3d& crosshair_P() const { return crosshair_P_; }
  /// Moves the crosshair, within the volume.
  void moveCrosshair(const Eigen::Vector3d& point_P);
  /// Whether the user placed the crosshair in this volume.
  bool isCrosshairPlaced() const { return isCrosshairPlaced_; }
  /// Moves the pictures' center.
  void pan(const Eigen::Vector3d& by_P);
  double pixel_mm() const { return pixel_mm_; }
  /// Values above 1 enlarge.
  void zoom(double factor);
  /// Fits what is shown into pictures of this width and height, whichever is less [pixels].
  void setPicture_px(double edge_px);
  /// Shows the whole volume in patient planes, the basal turn in those of the cochlea.
  void showWhole();

  const imaging::GrayWindow& window() const { return window_; }
  void setWindow(const imaging::GrayWindow& window);
  double thickness_mm() const { return thickness_mm_; }
  imaging::Projection projection() const { return projection_; }
  void setSlab(double thickness_mm, imaging::Projection projection);

  /// One place along an array.
  struct ArrayNode {
    Eigen::Vector3d center_P;  ///< [mm]
    double radius_mm;          ///< Half its width toward the modiolus.
  };
  /// An array that was inserted into the measured cochlea.
  struct InsertedArray {
    std::vector<ArrayNode> nodes;             ///< From base to tip; none if nothing was inserted.
    std::vector<Eigen::Vector3d> contacts_P;  ///< Number 1 at the tip [mm].
    std::array<Eigen::Vector3d, 2> approach_P{
        Eigen::Vector3d::Zero(),
        Eigen::Vector3d::Zero()};  ///< Insertion line, into the opening [mm].
  };
  /// Shows an array; none if it has no nodes.
  void setArray(InsertedArray array);
  const InsertedArray& array() const { return array_; }

  /// The opening of the anatomy that is built from the measures, in its frame W; empty without measures,
  /// or where none can be built.
  const std::optional<anatomy::Entry>& opening() const { return now_.opening; }
  /// The line of approach; empty without an opening. It stays in the patient when the cochlea is measured
  /// again: its angles are then others. Along the axis of the opening unless it was turned.
  std::optional<ct::ApproachLine> approachLine() const;
  /// The same as a scenario has it.
  std::optional<anatomy::Approach> approach() const;
  /// Its angles to the basal turn.
  std::optional<anatomy::BasalTurnAngles> approachAngles() const;
  /// Whether it is not along the axis of the opening.
  bool isApproachTurned() const { return !pointsOf(ct::MarkupKind::approach).empty(); }
  /// Whether it is at a limit of what a scenario has.
  bool isApproachAtLimit() const;
  /// Turns the line outward along a direction of P, within the limits and to a tenth of a degree of its
  /// angles. Emits approachMoved() only, until endChange().
  void turnApproach(const Eigen::Vector3d& outward_P);
  /// The same by its angles.
  void turnApproach(const anatomy::BasalTurnAngles& angles);
  /// Puts the line back along the axis of the opening.
  void resetApproach();
  /// Shows the approach of an insertion; no step for undo.
  void showApproach(const anatomy::Approach& approach);

  /// The points of a structure; none if it is not marked.
  std::vector<Eigen::Vector3d> pointsOf(ct::MarkupKind structure) const;
  /// Adds a point at the end of a structure; removes a structure. One step for undo each.
  void addPoint(ct::MarkupKind structure, const Eigen::Vector3d& point_P);
  void removeStructure(ct::MarkupKind structure);
  /// Its distance from the line of approach; empty without either.
  std::optional<ct::DistanceToLine> distanceFromApproach(ct::MarkupKind structure) const;

  /// A contact of an implanted array that was found in this CT.
  struct Contact {
    int number = 0;                                  ///< 1 at the tip.
    Eigen::Vector3d at_P = Eigen::Vector3d::Zero();  ///< [mm]
    bool isByHand = false;
    bool isSeenSingly = true;
  };
  /// Shows the planes of a measured cochlea without landmarks, for its contacts.
  void showEar(ct::CochleaMeasures measures);
  /// Shows contacts; none if empty.
  void setContacts(std::vector<Contact> contacts);
  const std::vector<Contact>& contacts() const { return contacts_; }
  void moveContact(int number, const Eigen::Vector3d& point_P);
  /// The contact that keys move; 0 for none. The crosshair goes to it.
  void chooseContact(int number);
  int chosenContact() const { return chosenContact_; }

  const ct::Marks& marks() const { return now_.marks; }
  /// Measures between the landmarks [mm].
  ct::MarkedMeasures marked() const;
  /// The landmarks that the user placed or moved; the others are proposed.
  ct::Marks marksByHand() const;
  bool isCorrected() const { return !marksByHand().isEmpty(); }
  /// Begins a change of landmarks that undo() takes back as one; without a placement it is not recorded.
  void beginChange() { isChangeOpen_ = false; }
  /// Ends a turn of the line of approach, which is given onward.
  void endChange();
  void placeMark(ct::Mark mark, const Eigen::Vector3d& point_P);
  /// Shows landmarks placed by a person, as from a file.
  void setMarks(const ct::Marks& marks);

  /// What a person marked in this CT: distances, angles, notes, structures, and the line of approach where it was
  /// turned.
  const std::vector<ct::Markup>& markups() const { return now_.markups; }
  /// The same with series and voxels.
  ct::CtMarkups ctMarkups() const;
  /// Shows markups that were kept of this CT; no step for undo.
  void showMarkups(std::vector<ct::Markup> markups);
  /// Adds markups, or none where one is impossible or has a point outside the volume. One step for undo; the last one is
  /// chosen.
  Result<void> addMarkups(const std::vector<ct::Markup>& markups);
  /// A point of a markup, by its places in the lists.
  struct MarkupPoint {
    std::size_t markup, point;
    friend bool operator==(const MarkupPoint&, const MarkupPoint&) = default;
  };
  /// Moves a point within the volume; it stays where the markup would be impossible. Calls after one beginChange() are
  /// one step for undo.
  void moveMarkupPoint(const MarkupPoint& which, const Eigen::Vector3d& point_P);
  /// Writes a text beside a markup; the error says why it cannot be kept.
  Result<void> setMarkupText(std::size_t which, const std::string& text);
  void removeMarkup(std::size_t which);
  /// The markup that Del removes; the crosshair stays.
  void chooseMarkup(std::optional<std::size_t> which);
  std::optional<std::size_t> chosenMarkup() const { return chosenMarkup_; }

  /// The kind of markup that clicks place; empty: none. Points that were placed and are no markup yet are dropped.
  void setTool(std::optional<ct::MarkupKind> tool);
  std::optional<ct::MarkupKind> tool() const { return tool_; }
  /// Points of the markup that is placed now.
  const std::vector<Eigen::Vector3d>& toolPoints_P() const { return toolPoints_P_; }
  /// Adds a point of it, in any plane; with its last point it becomes a markup. The tool stays. A note needs a text:
  /// addMarkups().
  void placeToolPoint(const Eigen::Vector3d& point_P);

  bool canUndo() const { return !undoStack_.empty(); }
  bool canRedo() const { return !redoStack_.empty(); }
  /// Brings back landmarks and markups before a change, and the fit that was shown with them; the last point of a
  /// markup that is placed now first.
  void undo();
  void redo();

Q_SIGNALS:
  /// The line of approach moved, and may move further.
  void approachMoved();
  /// The user turned the line of approach, or took that back.
  void approachGiven();
  /// Something that is drawn or written changed.
  void changed();
  /// Measures, landmarks or array changed, not only what is looked at; followed by changed().
  void modelChanged();
  /// Markups were added, moved, removed, or are others; followed by changed().
  void markupsChanged();
  /// Markups stand at other places of their list: a point that is dragged is dropped.
  void markupsRenumbered();

private:
  /// Keeps measures, with the cochlear views on them.
  void showMeasured(ct::CochleaMeasures measures);
  /// Landmarks, who placed them, the fit and markups: what undo() brings back.
  struct Placement {
    ct::Marks marks;
    std::array<bool, ct::markCount> isByHand{};
    std::shared_ptr<const ct::CochleaMeasures> measures, former;
    std::optional<anatomy::Entry> opening;
    std::vector<ct::Markup> markups;
  };

  void removeAll();
  void announceModel();
  void announceMarkups();
  void keepForUndo();
  void keepChange();
  /// Keeps the line of approach among the markups; none along the axis of the opening.
  void keepLine(const anatomy::Approach& approach);
  void restore(std::vector<Placement>& from, std::vector<Placement>& to);

  std::shared_ptr<const ct::CtVolume> volume_;
  std::unique_ptr<imaging::PlaneSampler> sampler_;
  imaging::CtSeries series_;
  PlaneFrame frame_ = PlaneFrame::patient;
  Eigen::Vector3d crosshair_P_ = Eigen::Vector3d::Zero(), center_P_ = Eigen::Vector3d::Zero();
  bool isCrosshairPlaced_ = false;
  double pixel_mm_ = 0.1,
         picture_px_ = 400.0;  ///< Edge of a picture, until the views are laid out.
  imaging::GrayWindow window_ = imaging::boneWindow;
  double thickness_mm_ = 0.0;
  imaging::Projection projection_ = imaging::Projection::mean;
  InsertedArray array_;
  std::vector<Contact> contacts_;
  int chosenContact_ = 0;
  Placement now_;
  std::vector<Placement> undoStack_, redoStack_;
  std::optional<std::size_t> chosenMarkup_;
  std::optional<ct::MarkupKind> tool_;
  std::vector<Eigen::Vector3d> toolPoints_P_;
  bool isChangeOpen_ = false;  ///< Whether further placements belong to the same step.
};

}  // namespace perilymph::gui
