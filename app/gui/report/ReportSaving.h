// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Saving a report from the window: the dialog, and the file.

#include <QObject>
#include <QString>
#include <optional>

#include "gui/report/ReportFile.h"
#include "gui/run/Background.h"

class QWidget;

namespace perilymph::gui {

/// Asks where to save a report: as PDF, as DICOM with the patient's code, or as DICOM in the study of
/// the patient's CT, whose folder is asked for, too. Empty if the user cancels.
///
/// @param name  Proposed name without an ending, beside the user's documents.
std::optional<ReportPlace> askReportPlace(const QString& title, const QString& name,
                                          QWidget* parent);

/// Writes reports one at a time; a CT is read off the window's thread.
class ReportSaving : public QObject {
  Q_OBJECT
public:
  explicit ReportSaving(QObject* parent) : QObject(parent), background_(this) {}

  /// UI thread.
  void save(const PdfWriting& writing, const ReportIdentity& identity, const ReportPlace& place);

Q_SIGNALS:
  /// @param sentence  Where it is, and what it names.
  void saved(const std::filesystem::path& file, const QString& sentence);
  void failed(const QString& sentence);

private:
  Background background_;
};

}  // namespace perilymph::gui
