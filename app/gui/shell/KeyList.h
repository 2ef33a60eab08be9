// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The list of keys, shown over the page on request.

#include <QFrame>

namespace perilymph::gui {

class KeyActions;

/// An overlay with the functions of keys and mouse, generated from the actions.
class KeyList : public QFrame {
  Q_OBJECT
public:
  KeyList(const KeyActions& actions, QWidget* parent);

Q_SIGNALS:
  void guideAsked();
};

}  // namespace perilymph::gui
