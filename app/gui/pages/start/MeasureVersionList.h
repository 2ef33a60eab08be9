// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The measures of one ear, as they were saved one after the other.

#include <QTableWidget>
#include <vector>

#include "gui/setup/MeasureVersions.h"

namespace perilymph::gui {

/// A row for each version, the newest first, with intervals: when, how, A, B, H and duct length. A measure
/// beyond the interval of its difference from the used one is marked, and its tooltip states the difference.
class MeasureVersionList : public QTableWidget {
  Q_OBJECT
public:
  explicit MeasureVersionList(QWidget* parent);

  void show(const std::vector<MeasureVersion>& versions);
};

}  // namespace perilymph::gui
