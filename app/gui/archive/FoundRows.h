// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What an archive found, in two tables: studies, and the series of one of them.

#include <QTableWidget>
#include <optional>
#include <vector>

#include "perilymph/archive/Query.h"

namespace perilymph::gui {

/// A table of rows that are chosen one at a time. Return and a double click open a row.
class FoundTable : public QTableWidget {
  Q_OBJECT
public:
  FoundTable(const char* name, const QString& accessibleName, const QStringList& headings,
             QWidget* parent);

Q_SIGNALS:
  /// Another row was chosen; -1 for none.
  void rowChosen(int row);
  void rowOpened(int row);

protected:
  void fill(const std::vector<QStringList>& rows);
  void keyPressEvent(QKeyEvent* event) override;
};

class StudyRows : public FoundTable {
  Q_OBJECT
public:
  explicit StudyRows(QWidget* parent);
  void show(std::vector<archive::FoundStudy> studies);
  const archive::FoundStudy* chosen() const;

private:
  std::vector<archive::FoundStudy> studies_;
};

class SeriesRows : public FoundTable {
  Q_OBJECT
public:
  explicit SeriesRows(QWidget* parent);
  void show(std::vector<archive::FoundSeries> series);
  const archive::FoundSeries* chosen() const;

private:
  std::vector<archive::FoundSeries> series_;
};

}  // namespace perilymph::gui
