// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The list of keys, shown over the page on request.

#include <QFrame>

class QBoxLayout;

namespace perilymph::gui {

class KeyActions;

/// An overlay with the functions of keys and mouse, generated from the actions.
class KeyList : public QFrame {
  Q_OBJECT
public:
  KeyList(const KeyActions& actions, QWidget* parent);

  /// Takes the size of its content, in one column where two are too wide, at most the window's.
  void fit();

Q_SIGNALS:
  void guideRequested();

private:
  QBoxLayout* columns_;
};

}  // namespace perilymph::gui
