// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The studies that were made here before.

#include <QWidget>
#include <vector>

#include "gui/pages/studies/StudyStore.h"
#include "gui/run/Background.h"

class QPushButton;

namespace perilymph::gui {

class Selector;

/// A list of studies with how far they are, and a button that opens or continues one.
class StoredStudies : public QWidget {
  Q_OBJECT
public:
  explicit StoredStudies(QWidget* parent);

  /// Reads them from the disk again, in the background.
  void refresh();
  /// While a study runs, none can be continued.
  void setBusy(bool isBusy);

Q_SIGNALS:
  void asked(const perilymph::gui::StoredStudy& study);

private:
  void list(std::vector<StoredStudy> studies);
  const StoredStudy* chosen() const;
  void showState();

  Selector* list_;
  QPushButton* take_;
  std::vector<StoredStudy> studies_;
  bool isBusy_ = false;
  Background reading_;
};

}  // namespace perilymph::gui
