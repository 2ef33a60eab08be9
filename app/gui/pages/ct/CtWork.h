// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Background tasks of the page CT: listing series, reading one, measuring the cochlea.

#include <QObject>
#include <QString>
#include <QTimer>
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "gui/run/Background.h"
#include "perilymph/ct/Measures.h"
#include "perilymph/imaging/CtSeries.h"

namespace perilymph::gui {

/// Runs one task at a time; a new one replaces it. Results arrive as signals in the window's thread.
class CtWork : public QObject {
  Q_OBJECT
public:
  using Measurement =
      std::function<Result<ct::CochleaMeasures>(const ct::CtVolume&, const ct::MeasureRequest&)>;

  explicit CtWork(QObject* parent);
  void setMeasurement(Measurement measurement) { measurement_ = std::move(measurement); }

  /// Lists the series of a folder or file, then reads one.
  ///
  /// @param series  Its SHA-256; empty for the one that suits a cochlea best.
  void open(const std::filesystem::path& path, const std::string& series = {});
  /// Reads a series of a list.
  void read(const imaging::CtSeriesList& list, const std::string& uid);
  /// Reads a small picture of each series of a list.
  void readThumbnails(const imaging::CtSeriesList& list);
  /// Measures the cochlea; `request` needs no hooks.
  void measure(std::shared_ptr<const ct::CtVolume> volume, ct::MeasureRequest request);
  void cancel();
  bool isBusy() const { return background_.isBusy(); }

Q_SIGNALS:
  void progressed(double fraction);
  void listed(const perilymph::imaging::CtSeriesList& list);
  /// The series that was asked for is not there.
  void seriesMissed();
  void ctRead(std::shared_ptr<perilymph::imaging::LoadedCt> ct);
  void measured(const perilymph::ct::CochleaMeasures& measures);
  void thumbnailsRead(const std::vector<perilymph::imaging::CtThumbnail>& pictures);
  /// A task ended without a result; empty if it was canceled.
  void failed(const QString& sentence);

private:
  static constexpr int thumbnail_px = 48;

  /// Progress of a task, shared with its thread.
  using Progress = std::shared_ptr<std::atomic<double>>;

  Progress begin();
  void end();
  void fail(const Sentence& sentence);

  Measurement measurement_ = ct::measureCochlea;
  Progress progress_;
  bool isCanceled_ = false;
  QTimer timer_;
  Background background_;
};

}  // namespace perilymph::gui
