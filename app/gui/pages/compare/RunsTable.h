// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The compared insertions, one a row.

#include <QTableWidget>
#include <vector>

#include "perilymph/analysis/Comparison.h"
#include "perilymph/analysis/Score.h"

class QPixmap;

namespace perilymph::gui {

/// "standard", "advance off-stylet".
QString techniqueText(const std::string& name);
/// The line of a run or a group, for tables.
QPixmap swatchOf(std::size_t number);

/// Results of each insertion, and its force at the cursor.
class RunsTable : public QTableWidget {
  Q_OBJECT
public:
  explicit RunsTable(QWidget* parent);

  void show(const std::vector<analysis::ComparedInsertion>& runs,
            const std::vector<Result<analysis::InsertionScore>>& scores);
  /// @param shown  Place of the cursor, in mm or degrees.
  void showCursor(const std::vector<analysis::ComparedInsertion>& runs, analysis::CurveAxis axis,
                  double shown);
};

}  // namespace perilymph::gui
