// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Groups of a study's insertions and their differences as tables.

#include <QWidget>

#include "perilymph/study/StudySummary.h"

class QLabel;
class QTableWidget;

namespace perilymph::gui {

/// A row for each group, and one for each pair of groups; under them how they were computed.
class SummaryTables : public QWidget {
  Q_OBJECT
public:
  explicit SummaryTables(QWidget* parent);

  /// @param selection  Which insertions medians, means, differences and slopes are of.
  void show(const study::StudySummary& summary, study::StudySelection selection);

private:
  void showGroups(const study::StudySummary& summary, study::StudySelection selection);
  void showDifferences(const study::StudySummary& summary, study::StudySelection selection);

  QTableWidget* groups_;
  QTableWidget* differences_;
  QLabel* method_;
};

}  // namespace perilymph::gui
