#pragma once

// The panel at the left: what is inserted into whom, by which hand, and what the picture shows.

#include <QWidget>
#include <vector>

#include "gui/run/InsertionControl.h"
#include "gui/setup/Setup.h"
#include "perilymph/visualization/InsertionScene.h"

class QPushButton;
class QScrollArea;

namespace perilymph::gui {

class ArraySection;
class CheckBox;
class HandSection;
class PatientSection;
class ScenarioHead;
class Section;
class SetupHistory;

/// Shows a setup and asks for changes of it, for another hand or other parts of the picture.
/// Changes are possible before an insertion and after it, not during one.
class SidePanel : public QWidget {
  Q_OBJECT
public:
  explicit SidePanel(QWidget* parent);

  void showSetup(const SetupHistory& history);
  /// Sends off what is typed and not yet sent. A sentence where something typed cannot be.
  QString commit();
  void setChangeable(bool isChangeable);

  /// @param name  Of the hand.
  void setHand(InputSource hand, const QString& name);
  void setHeld(bool isHeld);
  void setHoldEnabled(bool isEnabled);
  void setStylet(const QString& text, bool canPull);

  /// A narrow strip, or the whole panel.
  void setCollapsed(bool isCollapsed);
  bool isCollapsed() const;
  /// Says again which parts of the picture are shown: for a picture that is new.
  void announceParts();

Q_SIGNALS:
  void changeAsked(const perilymph::gui::SetupChange& change);
  void undoAsked();
  void redoAsked();
  void restoreAsked();
  void handChosen(perilymph::gui::InputSource hand);
  void devicesAsked();
  void holdChanged(bool isHeld);
  void styletAsked();
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
  ScenarioHead* head_;
  PatientSection* patient_;
  ArraySection* array_;
  HandSection* hand_;
  std::vector<std::pair<visualization::Part, CheckBox*>> parts_;
  bool isChangeable_ = true;
  bool isHeld_ = false;
};

}  // namespace perilymph::gui
