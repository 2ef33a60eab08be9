#pragma once

// The panel at the left: what is inserted into whom, by which hand, and what the picture shows.

#include <QWidget>
#include <vector>

#include "InsertionControl.h"
#include "perilymph/visualization/InsertionScene.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace perilymph::gui {

class CheckBox;
class Choice;

/// Shows a scenario, and asks for another hand or other parts of the picture.
class SidePanel : public QWidget {
  Q_OBJECT
public:
  explicit SidePanel(QWidget* parent);

  /// What is inserted into whom from now on, with everything shown.
  void setScenario(const session::Scenario& scenario);

  /// @param name  Of the hand.
  void setHand(Hand hand, const QString& name);
  /// The hand can be changed before an insertion and after it, not during one.
  void setHandChangeable(bool isChangeable);
  void setHeld(bool isHeld);
  void setHoldEnabled(bool isEnabled);
  void setStylet(const QString& words, bool canPull);

Q_SIGNALS:
  void handChosen(perilymph::gui::Hand hand);
  void devicesAsked();
  void holdChanged(bool isHeld);
  void styletAsked();
  void partShown(perilymph::visualization::Part part, bool isVisible);
  void experimentShown(bool isVisible);

private:
  void addTitle(QVBoxLayout& column, const QString& title, const QString& note = {});
  QLabel* addRow(QVBoxLayout& column, const QString& name, const QString& value,
                 const QString& tip = {});
  void addLine(QVBoxLayout& column);
  void addPatient(QVBoxLayout& column, const session::Scenario& scenario);
  void addArray(QVBoxLayout& column, const session::Scenario& scenario);
  void addHand(QVBoxLayout& column, const session::Scenario& scenario);
  void addShow(QVBoxLayout& column);

  QWidget* content_ = nullptr;
  Choice* scripted_ = nullptr;
  Choice* pointer_ = nullptr;
  Choice* device_ = nullptr;
  QPushButton* hold_ = nullptr;
  QPushButton* pullStylet_ = nullptr;
  QLabel* stylet_ = nullptr;
};

}  // namespace perilymph::gui
