// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The patient of a plan: code, ear, and the measures with their errors.

#include <QWidget>
#include <optional>

#include "perilymph/anatomy/Approach.h"
#include "perilymph/anatomy/Patient.h"

class QLabel;

namespace perilymph::gui {

/// A line over the plan.
class PlanHeader : public QWidget {
  Q_OBJECT
public:
  explicit PlanHeader(QWidget* parent);

  void show(const anatomy::Patient& patient);
  /// Shows the approach of a plan of a patient; nothing along the axis of the opening.
  /// @param now  Another one, of which the next plan is; empty if it is the same.
  void showApproach(const anatomy::Patient& patient,
                    const std::optional<anatomy::Approach>& approach,
                    const std::optional<anatomy::Approach>& now);
  /// Text at the right end: "64 draws · 320 insertions".
  void setNote(const QString& note);

private:
  QLabel* name_;
  QLabel* measures_;
  QLabel* superseded_;  ///< That other measures are in use now.
  QLabel *approach_, *otherApproach_;
  QLabel* change_;  ///< What the measures were before.
  QLabel* note_;
};

}  // namespace perilymph::gui
