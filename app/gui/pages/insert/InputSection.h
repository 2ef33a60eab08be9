// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The device section of the panel: input device and force scale.

#include "gui/run/InsertionControl.h"
#include "gui/setup/Section.h"
#include "gui/setup/Setup.h"

class QLabel;
class QPushButton;

namespace perilymph::gui {

class Choice;
class NumberField;

/// Shows the input device and requests another one, grasping of the array, or withdrawal of the
/// stylet.
class InputSection : public Section {
  Q_OBJECT
public:
  explicit InputSection(QWidget* parent);

  void show(const Setup& setup);
  /// Commits edited values. An error message if a value is invalid.
  QString commit();

  /// @param name  Name of the device.
  void setInput(InputSource input, const QString& name);
  void setChangeable(bool isChangeable);
  void setHeld(bool isHeld);
  void setHoldEnabled(bool isEnabled);
  void setStylet(const QString& text, bool canPull);

Q_SIGNALS:
  void changeRequested(const perilymph::gui::SetupChange& change);
  void inputChosen(perilymph::gui::InputSource input);
  void devicesRequested();
  void holdChanged(bool isHeld);
  void styletRequested();

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
