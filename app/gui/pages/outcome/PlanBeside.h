// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Plan and outcome side by side: the band of each contact, and where in it the contact came.

#include <QTableWidget>
#include <optional>

#include "gui/pages/outcome/PlannedEar.h"
#include "perilymph/figures/Figure.h"
#include "perilymph/outcome/FoundArray.h"

namespace perilymph::gui {

/// The depth first, then a row per contact, 1 at the tip.
class PlanBeside : public QTableWidget {
  Q_OBJECT
public:
  explicit PlanBeside(QWidget* parent);

  /// @param ends  The plan's simulations as they ended; empty where they are not there.
  void show(const planning::ArrayPlan* plan, const outcome::PlannedOutcome& ends,
            const outcome::FoundArray& found);
};

/// Force over depth of the patient's insertion by hand, the plan's band, and a band at the length that was
/// inserted in the patient. Empty without plan and insertion.
std::optional<figures::Figure> forceBeside(const PlannedEar& ear, const outcome::FoundArray& found);

}  // namespace perilymph::gui
