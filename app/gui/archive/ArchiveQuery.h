// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The conditions of a query, typed.

#include <QWidget>
#include <array>
#include <optional>
#include <string>

#include "perilymph/archive/Query.h"
#include "perilymph/foundation/Result.h"

class QLineEdit;

namespace perilymph::gui {

class CheckBox;

/// Fields for a patient, a birth date and a range of study dates. Nothing typed is kept.
class ArchiveQuery : public QWidget {
  Q_OBJECT
public:
  explicit ArchiveQuery(QWidget* parent);

  /// The typed fields. An error for an invalid date, or if all fields are empty.
  Result<archive::StudyQuery> query() const;
  /// Empties all fields.
  void clear();
  void focusFirst();

Q_SIGNALS:
  /// Return was pressed in a field.
  void submitted();

private:
  QLineEdit* add(const char* name, const QString& caption, const QString& hint);

  QLineEdit *number_, *name_, *birth_, *from_, *until_;
  CheckBox* isCt_;
};

/// A typed date as YYYYMMDD: 1970-01-31, 31.1.1970 or 19700131. Empty if invalid.
std::optional<std::string> dicomDate(const QString& typed);

/// A date YYYYMMDD for users, 1970-01-31; a dash without one, another text as it is.
QString dateText(const std::string& dicom);

}  // namespace perilymph::gui
