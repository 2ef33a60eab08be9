// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Whether a CT after surgery is of the patient: asked where its ear differs from the patient's.

#include <QDialog>
#include <QStringList>
#include <optional>

#include "gui/setup/PatientLibrary.h"
#include "perilymph/ct/CtVolume.h"
#include "perilymph/outcome/FoundArray.h"

namespace perilymph::gui {

/// What speaks against a CT being of a patient, a sentence each: the side that it shows or states, A or B beyond
/// their errors, a CT before surgery that does not agree, a series that is another patient's. None if nothing does.
///
/// @param ct  Of the CT after surgery.
QStringList earDoubts(const SavedPatient& patient, const outcome::Ear& ear,
                      const ct::CtProvenance& ct);

/// States what differs. The answer is No unless the user presses the other button.
class EarQuestion : public QDialog {
  Q_OBJECT
public:
  /// @param otherSide  Side of the ear in the CT where it is not the patient's.
  EarQuestion(const QString& patient, const QStringList& doubts,
              std::optional<anatomy::Side> otherSide, QWidget* parent);
};

}  // namespace perilymph::gui
