// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// An input field for a number with name, unit and range.

#include <QWidget>

#include "perilymph/foundation/TomlReader.h"

class QLabel;

namespace perilymph::gui {

class ValueEdit;

/// A name, a field and a unit; below them the allowed range while the input is invalid.
class NumberField : public QWidget {
  Q_OBJECT
public:
  struct Form {
    QString title;
    const char* name;  ///< Object name, for tests.
    QString unit;
    int decimals = 1;
    QString tip;
  };

  NumberField(const Form& form, QWidget* parent);

  void setRange(Range allowed);
  /// Sets the current value.
  void setValue(double value);

  /// Commits the input. False if it is not a number within the range.
  bool commit();
  /// The input was edited and not committed.
  bool isPending() const;
  void takeBack();
  /// Error message of the input; empty if it is valid.
  QString error() const;

Q_SIGNALS:
  /// The user entered this value.
  void given(double value);

private:
  void showError();

  Form form_;
  Range allowed_;
  ValueEdit* edit_;
  QLabel* error_;
};

}  // namespace perilymph::gui
