// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Reads results of studies, and runs single insertions of them again, off the window's thread.

#include <QObject>
#include <filesystem>
#include <memory>

#include "gui/run/Background.h"
#include "perilymph/study/StudyColumns.h"

namespace perilymph::gui {

/// One piece of work at a time; the last request is answered.
class StudyWork : public QObject {
  Q_OBJECT
public:
  using Columns = std::shared_ptr<const study::StudyColumns>;

  explicit StudyWork(QObject* parent) : QObject(parent), background_(this) {}

  /// Reads a merged file or a shard.
  void open(const std::filesystem::path& file);
  /// Runs the insertion in a row of an opened file again, with a recording in the folder of the
  /// sessions. One that is there from before is used.
  void runAgain(const Columns& columns, const std::filesystem::path& file, std::size_t row);
  /// Ends the work without an answer.
  void cancel() { background_.cancel(); }
  bool isBusy() const { return background_.isBusy(); }

Q_SIGNALS:
  void opened(const perilymph::gui::StudyWork::Columns& columns, const std::filesystem::path& file);
  /// @param sentence  Compares the values of the run with those of the study.
  void recorded(const std::filesystem::path& recording, const QString& sentence);
  void failed(const QString& sentence);

private:
  Background background_;
};

}  // namespace perilymph::gui
