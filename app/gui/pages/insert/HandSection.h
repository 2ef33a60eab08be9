#pragma once

// The hand in the panel: who moves the array, and how strongly a device shows the force.

#include "gui/run/InsertionControl.h"
#include "gui/setup/Section.h"
#include "gui/setup/Setup.h"

class QLabel;
class QPushButton;

namespace perilymph::gui {

class Choice;
class NumberField;

/// Shows the hand and asks for another one, for the array to be held, for the stylet to be pulled.
class HandSection : public Section {
  Q_OBJECT
public:
  explicit HandSection(QWidget* parent);

  void show(const Setup& setup);
  /// Sends off what is typed. A sentence where something typed cannot be.
  QString commit();

  /// @param name  Of the hand.
  void setHand(InputSource hand, const QString& name);
  void setChangeable(bool isChangeable);
  void setHeld(bool isHeld);
  void setHoldEnabled(bool isEnabled);
  void setStylet(const QString& text, bool canPull);

Q_SIGNALS:
  void changeAsked(const perilymph::gui::SetupChange& change);
  void handChosen(perilymph::gui::InputSource hand);
  void devicesAsked();
  void holdChanged(bool isHeld);
  void styletAsked();

private:
  void addChoices();
  void addButtons();

  Choice* scripted_;
  Choice* pointer_;
  Choice* device_;
  QPushButton* hold_;
  QPushButton* pullStylet_;
  QLabel* stylet_;
  QWidget* styletRow_;
  NumberField* force_;
};

}  // namespace perilymph::gui
