// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The reference insertion in the panel: whether it is shown, what differs, and its removal.

#include <QWidget>
#include <optional>

#include "gui/run/ReferenceInsertion.h"

class QLabel;
class QPushButton;

namespace perilymph::gui {

/// Hidden while there is no reference.
class ReferenceRow : public QWidget {
  Q_OBJECT
public:
  explicit ReferenceRow(QWidget* parent);

  void setReference(const std::optional<ReferenceInsertion>& reference);
  /// Compares the reference with what is inserted now.
  void showCurrent(const session::ScenarioSubject& current);

Q_SIGNALS:
  void removeRequested();

private:
  void showState();

  std::optional<ReferenceInsertion> reference_;
  session::ScenarioSubject current_;
  QLabel *name_, *warning_;
  QPushButton* remove_;
};

}  // namespace perilymph::gui
