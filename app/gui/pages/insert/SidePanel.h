// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The panel on the left: setup, input device, and view options.

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "gui/run/InsertionControl.h"
#include "gui/run/ReferenceInsertion.h"
#include "gui/setup/Setup.h"
#include "perilymph/visualization/InsertionScene.h"

class QPushButton;
class QScrollArea;

namespace perilymph::gui {

class ArraySection;
class CheckBox;
class InputSection;
class PatientSection;
class ReferenceRow;
class ScenarioHeader;
class Section;
class SetupHistory;

/// Shows a setup and requests changes of it, of the input device or of the view. The setup can be
/// changed before and after an insertion, not during one.
class SidePanel : public QWidget {
  Q_OBJECT
public:
  SidePanel(std::shared_ptr<CochleaStore> cochleae, QWidget* parent);

  /// Shows the reference insertion, if any.
  void setReference(const std::optional<ReferenceInsertion>& reference);
  void showSetup(const SetupHistory& history);
  /// Commits edited values. An error message if a value is invalid.
  QString commit();
  void setChangeable(bool isChangeable);

  /// @param name  Name of the device.
  void setInput(InputSource input, const QString& name);
  void setHeld(bool isHeld);
  void setHoldEnabled(bool isEnabled);
  void setStylet(const QString& text, bool canPull);

  /// Collapses the panel to a narrow strip, or expands it.
  void setCollapsed(bool isCollapsed);
  bool isCollapsed() const;
  /// Shows the timing of the haptic loop in the expert section.
  void setTiming(const QString& text);
  /// Enables the check box of the published experiment, or disables it with the reason.
  void setComparable(bool isComparable);
  /// Shows a part of the picture, or hides it.
  void togglePart(visualization::Part part);
  /// Emits the view options again, for a new view.
  void announceParts();

Q_SIGNALS:
  void changeRequested(const perilymph::gui::SetupChange& change);
  /// The user selected a saved patient, or requests a search of all of them or a new one.
  void patientChosen(const perilymph::anatomy::Patient& patient);
  void allPatientsRequested();
  void newPatientRequested();
  void removeReferenceRequested();
  void undoRequested();
  void redoRequested();
  void restoreRequested();
  void inputChosen(perilymph::gui::InputSource input);
  void devicesRequested();
  void holdChanged(bool isHeld);
  void styletRequested();
  void partShown(perilymph::visualization::Part part, bool isVisible);
  void experimentShown(bool isVisible);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

private:
  void connectSections();
  Section* showSection(QWidget* parent);

  QScrollArea* scroll_;
  QPushButton* expand_;
  ScenarioHeader* head_;
  PatientSection* patient_;
  ArraySection* array_;
  ReferenceRow* reference_ = nullptr;
  InputSection* input_;
  std::vector<std::pair<visualization::Part, CheckBox*>> parts_;
  CheckBox* experiment_ = nullptr;
  bool isChangeable_ = true;
  bool isHeld_ = false;
};

}  // namespace perilymph::gui
