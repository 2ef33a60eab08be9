// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A page's message line, with the folder that was written into.

#include <QWidget>
#include <filesystem>

class QLabel;
class QPushButton;

namespace perilymph::gui {

/// Shows a sentence in a label, in the color of an error or quietly.
void showSentence(QLabel& label, const QString& sentence, bool isError);

/// A sentence, and after an export the button Open folder.
class StatusLine : public QWidget {
  Q_OBJECT
public:
  /// @param name  Object name of the label, for tests.
  StatusLine(const char* name, QWidget* parent);

  void showMessage(const QString& sentence, bool isError = false);
  /// Says that files were written, and offers to open their folder.
  void sayWritten(const QString& sentence, const std::filesystem::path& folder);

private:
  QLabel* label_;
  QPushButton* open_;
  std::filesystem::path folder_;
};

/// Where dialogs for exports begin: the user's folder for documents.
QString documentsFolder();

}  // namespace perilymph::gui
