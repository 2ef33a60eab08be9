// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The list of what belongs to one patient.

#include <QTableWidget>
#include <optional>
#include <vector>

#include "gui/setup/PatientHistory.h"

namespace perilymph::gui {

/// Scans, plans, insertions and outcomes, newest first. A click or Enter opens one.
class PatientHistoryList : public QTableWidget {
  Q_OBJECT
public:
  explicit PatientHistoryList(QWidget* parent);

  void show(std::vector<HistoryEntry> entries);

Q_SIGNALS:
  void opened(const perilymph::gui::HistoryEntry& entry);

protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;

private:
  void open(int row);

  std::vector<HistoryEntry> entries_;
};

}  // namespace perilymph::gui
