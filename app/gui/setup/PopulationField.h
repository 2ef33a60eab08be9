// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// An input field for a patient measure, with its position in the population.

#include <QString>
#include <QWidget>
#include <optional>

#include "perilymph/foundation/Units.h"

class QLabel;

namespace perilymph::gui {

class ValueEdit;

/// Population statistics of a length.
struct Population {
  Length low, high;                         ///< Allowed range.
  std::optional<Length> mean;               ///< Empty if unpublished.
  std::optional<Length> standardDeviation;  ///< Empty if unpublished.
  QString source;
  QString measuring;  ///< How to measure it; may be empty.
  QString belowLow;   ///< Why smaller values are refused; may be empty.
};

/// A name, an input field for millimeters and a line that marks the value in the population.
class PopulationField : public QWidget {
  Q_OBJECT
public:
  /// Layout: for a form, or for a narrow panel.
  enum class Width { wide, narrow };

  /// @param name        Object name, for tests and style sheets.
  /// @param mayBeEmpty  The number is optional.
  PopulationField(const QString& title, const char* name, const Population& population,
                  bool mayBeEmpty, QWidget* parent, Width width = Width::wide);

  void setValue(std::optional<Length> value);
  /// Sets the error of the value as its measurement states it; empty for the assumed one.
  void setMeasuringError(std::optional<Length> error);
  /// Sets the current value, valid until another one is given(), and a text for its source.
  void setHeld(std::optional<Length> value, const QString& provenance);
  /// Empty if there is no number.
  std::optional<Length> value() const;
  /// True if the input is a number within the limits, or permissibly empty.
  bool isAcceptable() const;
  /// The input is two standard deviations or more from the mean.
  bool isUnusual() const;
  /// The field itself, for the tab order.
  QWidget* input() const;
  /// Error message of the input; empty if it is valid.
  QString error() const;

  /// Commits the input if it was edited since setHeld(). False if it is invalid.
  bool commit();
  bool isPending() const;
  void takeBack();

Q_SIGNALS:
  void changed();
  /// Return was pressed in the field.
  void submitted();
  /// The field received or lost the keyboard focus.
  void focused(bool isFocused);
  /// The user entered another value; empty if an optional number was removed.
  void given(std::optional<perilymph::Length> value);

protected:
  void paintEvent(QPaintEvent*) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void showPlace();
  QString placeOf(Length value) const;
  double fractionOf(Length value) const;
  QString emptyText() const;
  static QString textOf(std::optional<Length> value);

  Population population_;
  std::optional<Length> measuringError_;
  bool mayBeEmpty_;
  Width width_;
  ValueEdit* field_;
  QLabel* title_;
  QLabel* place_;
  QLabel* provenance_;
};

}  // namespace perilymph::gui
