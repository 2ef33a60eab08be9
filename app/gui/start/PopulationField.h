#pragma once

// One number of a patient: what was measured, its unit, and where it lies among other people's.

#include <QString>
#include <QWidget>
#include <optional>

#include "perilymph/foundation/Units.h"

class QLabel;
class QLineEdit;

namespace perilymph::gui {

/// What is known of a length over the population.
struct Population {
  Length low, high;                 ///< Allowed.
  std::optional<Length> mean;       ///< None where no one has published it.
  std::optional<Length> deviation;  ///< Likewise.
  QString source;
};

/// A name, a field for millimeters and a line that marks the value's place in the population.
class PopulationField : public QWidget {
  Q_OBJECT
public:
  /// @param name        Of the object: what tests and style sheets find it by.
  /// @param mayBeEmpty  The number may be left out.
  PopulationField(const QString& title, const char* name, const Population& population,
                  bool mayBeEmpty, QWidget* parent);

  void setValue(std::optional<Length> value);
  /// None if the field is empty or holds no number.
  std::optional<Length> value() const;
  /// True if what is typed is a number within the limits, or is rightly left out.
  bool isAcceptable() const;

Q_SIGNALS:
  void changed();

protected:
  void paintEvent(QPaintEvent*) override;

private:
  void showPlace();
  double shareOf(Length value) const;

  Population population_;
  bool mayBeEmpty_;
  QLineEdit* field_;
  QLabel* place_;
};

}  // namespace perilymph::gui
