#pragma once

// The patient in the panel: who, which ear, which model of a cochlea, and its numbers.

#include <vector>

#include "gui/setup/PopulationField.h"
#include "gui/setup/Section.h"
#include "gui/setup/Setup.h"

namespace perilymph::gui {

class Selector;
class ValueEdit;

/// Shows the patient of a setup and asks for changes of it.
class PatientSection : public Section {
  Q_OBJECT
public:
  explicit PatientSection(QWidget* parent);

  void show(const Setup& setup);
  /// Sends off what is typed. A sentence where something typed cannot be.
  QString commit();

Q_SIGNALS:
  void changeAsked(const perilymph::gui::SetupChange& change);

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

  ValueEdit* label_;
  Selector* ear_;
  Selector* kind_;
  QWidget* lengths_;
  QWidget* basalTurn_;
  std::vector<Number> numbers_;
  std::vector<Kind> kinds_;
  session::Overrides lastLengths_, lastBasalTurn_;  ///< As TOML, for coming back to a kind.
  QString heldKind_;
};

}  // namespace perilymph::gui
