// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Recent patients and insertions on the start page.

#include <QWidget>
#include <filesystem>
#include <optional>
#include <vector>

#include "gui/run/Background.h"
#include "gui/setup/PatientLibrary.h"
#include "perilymph/session/SessionLibrary.h"

class QVBoxLayout;

namespace perilymph::gui {

/// Two columns of links: the last used patients; the current setup and the last recordings.
class RecentWork : public QWidget {
  Q_OBJECT
public:
  explicit RecentWork(QWidget* parent);

  /// Reads both folders again, recordings in the background.
  /// @param current        Title of the setup on the insertion page; empty if it was not used yet.
  /// @param beingRecorded  Not listed.
  void refresh(const QString& current, const std::optional<std::filesystem::path>& beingRecorded);

Q_SIGNALS:
  void patientRequested(const perilymph::gui::SavedPatient& patient);
  void allPatientsRequested();
  void continueRequested();
  void replayRequested(const std::filesystem::path& recording);
  void allRecordingsRequested();

private:
  void showInsertions();

  QString current_;
  std::vector<session::SessionSummary> insertions_;  ///< As last read, the newest first.
  Background background_;
  QVBoxLayout *patients_, *recordings_;
};

}  // namespace perilymph::gui
