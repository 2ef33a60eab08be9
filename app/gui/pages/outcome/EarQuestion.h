// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Whether a CT after surgery is of the patient: asked where its ear differs from the patient's.

#include <QDialog>
#include <QStringList>
#include <string>

#include "gui/setup/PatientLibrary.h"
#include "perilymph/outcome/FoundArray.h"

namespace perilymph::gui {

/// What speaks against a CT being of a patient, a sentence each: the side, A or B beyond their errors, a
/// series that is another patient's. None if nothing does.
///
/// @param series  SHA-256 of the CT series after surgery.
QStringList earDoubts(const SavedPatient& patient, const outcome::Ear& ear,
                      const std::string& series);

/// States what differs. The answer is No unless the user presses the other button.
class EarQuestion : public QDialog {
  Q_OBJECT
public:
  EarQuestion(const QString& patient, const QStringList& doubts, QWidget* parent);
};

}  // namespace perilymph::gui
