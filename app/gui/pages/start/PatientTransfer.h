// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Exports and imports patients in the background, because recordings may have gigabytes.

#include <QObject>
#include <QTimer>
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <stop_token>

#include "gui/run/Background.h"
#include "perilymph/session/PatientRecord.h"

namespace perilymph::gui {

/// Copies one patient at a time in a separate thread. A copy that is canceled leaves nothing.
class PatientTransfer : public QObject {
  Q_OBJECT
public:
  /// Copies a patient and returns the new folder or file.
  using Copy = std::function<Result<std::filesystem::path>(const session::CopyProgress&,
                                                           const std::stop_token&)>;

  explicit PatientTransfer(QObject* parent);

  /// Does nothing while another copy runs.
  void start(Copy copy);
  /// Ends the copy; failed() follows.
  void cancel();
  bool isBusy() const { return background_.isBusy(); }

Q_SIGNALS:
  /// Emitted several times a second. @param percent  Of the bytes of all recordings.
  void progressed(int percent);
  void copied(const QString& place);
  void failed(const QString& sentence);

private:
  std::shared_ptr<std::atomic<int>> percent_;  ///< Shared with the thread.
  QTimer timer_;
  Background background_;
};

}  // namespace perilymph::gui
