#pragma once

// One number of a patient: what was measured, its unit, and where it lies among other people's.

#include <QString>
#include <QWidget>
#include <optional>

#include "perilymph/foundation/Units.h"

class QLabel;

namespace perilymph::gui {

class ValueEdit;

/// What is known of a length over the population.
struct Population {
  Length low, high;                         ///< Allowed.
  std::optional<Length> mean;               ///< None where no one has published it.
  std::optional<Length> standardDeviation;  ///< Likewise.
  QString source;
};

/// A name, a field for millimeters and a line that marks the value's place in the population.
class PopulationField : public QWidget {
  Q_OBJECT
public:
  /// How much room there is: a form's, or a narrow panel's.
  enum class Width { wide, narrow };

  /// @param name        Of the object: what tests and style sheets find it by.
  /// @param mayBeEmpty  The number may be left out.
  PopulationField(const QString& title, const char* name, const Population& population,
                  bool mayBeEmpty, QWidget* parent, Width width = Width::wide);

  void setValue(std::optional<Length> value);
  /// The value that holds until another one is given(), and a word for where it comes from.
  void setHeld(std::optional<Length> value, const QString& provenance);
  /// None if the field is empty or holds no number.
  std::optional<Length> value() const;
  /// True if what is typed is a number within the limits, or is rightly left out.
  bool isAcceptable() const;
  /// Why what is typed cannot be; empty where it can.
  QString error() const;

  /// Sends off what was typed since setHeld(). False where it is not acceptable.
  bool commit();
  bool isPending() const;
  void takeBack();

Q_SIGNALS:
  void changed();
  /// A person gave another value than the one that held; none where it may be left out.
  void given(std::optional<perilymph::Length> value);

protected:
  void paintEvent(QPaintEvent*) override;

private:
  void showPlace();
  QString placeOf(Length value) const;
  double fractionOf(Length value) const;

  Population population_;
  bool mayBeEmpty_;
  Width width_;
  ValueEdit* field_;
  QLabel* place_;
  QLabel* provenance_;
};

}  // namespace perilymph::gui
