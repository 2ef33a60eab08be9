#pragma once

// A named number with its unit and the range it may have.

#include <QWidget>

#include "perilymph/foundation/TomlReader.h"

class QLabel;

namespace perilymph::gui {

class ValueEdit;

/// A name, a field and a unit; below them, while it is wrong, what is allowed.
class NumberField : public QWidget {
  Q_OBJECT
public:
  struct Form {
    QString title;
    const char* name;  ///< Name of the field, by which tests find it.
    QString unit;
    int decimals = 1;
    QString tip;
  };

  NumberField(const Form& form, QWidget* parent);

  void setRange(Range allowed);
  /// Shows the value that holds.
  void setValue(double value);

  /// Sends off what is typed. False where it is no number within the range.
  bool commit();
  /// Something was typed and not sent off.
  bool isPending() const;
  void takeBack();
  /// Why what is typed cannot be; empty where it can.
  QString error() const;

Q_SIGNALS:
  /// A person gave this value.
  void given(double value);

private:
  void showError();

  Form form_;
  Range allowed_;
  ValueEdit* edit_;
  QLabel* error_;
};

}  // namespace perilymph::gui
