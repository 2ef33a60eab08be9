// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The setting that lets navigation programs receive the insertion.

#include <QWidget>

class QLabel;
class QLineEdit;

namespace perilymph::gui {

class Choice;
class Navigation;

/// Off or on, the coordinates, the port, and the state below them. It may be changed at any time.
class NavigationSection : public QWidget {
  Q_OBJECT
public:
  NavigationSection(Navigation& navigation, QWidget* parent);

private:
  void apply();
  void show();

  Navigation& navigation_;
  Choice* off_;
  Choice* on_;
  Choice* cochlea_;
  Choice* patient_;
  QLineEdit* port_;
  QLabel* status_;
};

}  // namespace perilymph::gui
