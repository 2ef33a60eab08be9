// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The contacts of a planned array: place, distance to the modiolus, frequencies.

#include <QTableWidget>
#include <vector>

#include "perilymph/planning/PlanResult.h"

namespace perilymph::gui {

/// One row per contact, 1 at the tip.
class ContactTable : public QTableWidget {
  Q_OBJECT
public:
  explicit ContactTable(QWidget* parent);

  /// @param draws  All of the array.
  void show(const std::vector<planning::ContactBand>& contacts, std::size_t draws);
};

}  // namespace perilymph::gui
