// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Groups of insertions: a column for each group, and for its difference from the first.

#include <QTableWidget>
#include <vector>

#include "perilymph/analysis/ComparisonGroups.h"

namespace perilymph::gui {

/// The values of a group in the language of the window.
QString groupText(const analysis::InsertionGroup& group,
                  const std::vector<analysis::GroupKey>& keys);

/// Mean ± SD of each quantity, and differences with their 95 % intervals. The first row is the force at
/// the cursor.
class GroupsTable : public QTableWidget {
  Q_OBJECT
public:
  explicit GroupsTable(QWidget* parent);

  /// @param keys  Those of the groups: values of techniques are shown in the window's language.
  void show(const std::vector<analysis::ComparedInsertion>& runs,
            const std::vector<analysis::InsertionGroup>& groups,
            const std::vector<analysis::GroupKey>& keys);
  /// @param shown  Place of the cursor, in mm or degrees.
  void showCursor(const std::vector<analysis::ComparedInsertion>& runs,
                  const std::vector<analysis::InsertionGroup>& groups, analysis::CurveAxis axis,
                  double shown);

private:
  void fillRow(int row, const std::vector<std::vector<double>>& values, double factor, int decimals,
               const QString& unit);
};

}  // namespace perilymph::gui
