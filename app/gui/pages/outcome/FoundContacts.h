// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The contacts that were found: angle, distance to the modiolus, scala, frequencies.

#include <QTableWidget>

#include "perilymph/outcome/FoundArray.h"

namespace perilymph::gui {

/// One row per contact, 1 at the tip.
class FoundContacts : public QTableWidget {
  Q_OBJECT
public:
  explicit FoundContacts(QWidget* parent);

  void show(const std::vector<outcome::FoundContact>& contacts);

Q_SIGNALS:
  /// The row of this contact was chosen.
  void contactChosen(int number);
};

}  // namespace perilymph::gui
