// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The notes on a plan.

#include <filesystem>

#include "gui/widgets/NotesField.h"

namespace perilymph::gui {

/// A field whose text is kept in the plan's folder with every change.
class PlanNotes : public NotesField {
  Q_OBJECT
public:
  explicit PlanNotes(QWidget* parent);

  /// Shows the notes of a plan; none can be written without a folder.
  void show(const std::filesystem::path& folder);

Q_SIGNALS:
  void failed(const QString& sentence);

private:
  void keep();

  std::filesystem::path folder_;
};

}  // namespace perilymph::gui
