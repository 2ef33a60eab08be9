// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The patient section of the panel: patient, ear, anatomy and its measures.

#include <memory>
#include <vector>

#include "gui/setup/PopulationField.h"
#include "gui/setup/Section.h"
#include "gui/setup/Setup.h"

class QLabel;

namespace perilymph::gui {

class CochleaStore;
class DerivedMeasures;
class SavedPatientRow;
class Selector;
class ValueEdit;

/// Shows the patient of a setup and requests changes.
class PatientSection : public Section {
  Q_OBJECT
public:
  PatientSection(std::shared_ptr<CochleaStore> cochleae, QWidget* parent);

  void show(const Setup& setup);
  /// Commits edited values. An error message if a value is invalid.
  QString commit();

Q_SIGNALS:
  void changeRequested(const perilymph::gui::SetupChange& change);
  /// The user selected a saved patient, or requests a search of all of them or a new one.
  void patientChosen(const perilymph::anatomy::Patient& patient);
  void allPatientsRequested();
  void newPatientRequested();

private:
  struct Number {
    SetupField field;
    const char* key;  ///< Key of `patient_numbers`.
    QString title;
    PopulationField* shown;
    QWidget* page;
  };

  struct Kind {
    QString id;
    anatomy::AnatomySource source;
    anatomy::PatientMeasures measures;  ///< Measures that scale it.
  };

  void addKind(const anatomy::AnatomySourceTraits& traits, anatomy::PatientMeasures measures);
  QWidget* addPage(std::vector<Number> numbers);
  void askNumber(const Number& number, std::optional<Length> value);
  void askKind(const QString& kind);
  void askLabel();
  void addWho();
  void addNumbers();
  /// Error message of the edited code; empty if there is none.
  QString codeError() const;

  SavedPatientRow* saved_;
  ValueEdit* label_;
  QLabel* labelError_;
  Selector* ear_;
  Selector* kind_;
  QWidget* lengths_;
  QWidget* basalTurn_;
  std::vector<Number> numbers_;
  std::vector<Kind> kinds_;
  session::Overrides lastLengths_, lastBasalTurn_;  ///< As TOML, to restore them when a kind is
                                                    ///< selected again.
  QString heldKind_;
  DerivedMeasures* derived_;
  QLabel* change_;        ///< What the measures were before.
  std::string changeOf_;  ///< Patient of that text.
};

}  // namespace perilymph::gui
