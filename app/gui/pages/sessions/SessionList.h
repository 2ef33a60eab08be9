// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The view of the table of recordings.

#include <QTableView>

class QSortFilterProxyModel;

namespace perilymph::gui {

class SessionTable;

/// A list with a thumbnail in each row, the newest recording first. Ear, array and technique are
/// whole in the smallest window; the name has the remaining width.
class SessionList : public QTableView {
  Q_OBJECT
public:
  SessionList(SessionTable& table, QSortFilterProxyModel& sorted, QWidget* parent);

protected:
  void resizeEvent(QResizeEvent* event) override;
};

}  // namespace perilymph::gui
