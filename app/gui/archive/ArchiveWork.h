// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Requests to DICOM archives in the background. No socket is opened but by them.

#include <QObject>
#include <QString>
#include <QTimer>
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>

#include "gui/run/Background.h"
#include "perilymph/archive/Fetch.h"
#include "perilymph/archive/Query.h"
#include "perilymph/archive/Servers.h"

namespace perilymph::gui {

/// Runs one request at a time; a new one replaces it. Results arrive as signals in the window's
/// thread. The end of this object cancels its request.
class ArchiveWork : public QObject {
  Q_OBJECT
public:
  explicit ArchiveWork(QObject* parent);

  void echo(const archive::Server& server);
  void findStudies(const archive::Server& server, const archive::StudyQuery& query);
  void findSeries(const archive::Server& server, const std::string& studyUid);
  /// @param folder  Does not exist; what an earlier request left of the series is completed.
  void fetch(const archive::Server& server, const archive::SeriesAddress& series,
             const std::filesystem::path& folder);
  /// Runs a request of several steps, which answers with a sentence.
  void run(std::function<Result<Sentence>(const archive::Exchange&)> request);
  /// Ends the request without an answer; failed() is emitted at once, with an empty sentence.
  void cancel();
  /// Asks the request to end; what it came to is still answered.
  void requestStop() { background_.requestStop(); }
  bool isBusy() const { return background_.isBusy(); }

Q_SIGNALS:
  void progressed(double fraction);
  /// The server answers.
  void answered();
  void studiesFound(const perilymph::archive::Found<perilymph::archive::FoundStudy>& studies);
  void seriesFound(const perilymph::archive::Found<perilymph::archive::FoundSeries>& series);
  void fetched(const std::filesystem::path& folder);
  /// A request of several steps ended.
  void done(const QString& sentence);
  /// A request ended without a result; empty if it was canceled.
  void failed(const QString& sentence);

private:
  template <class Request, class Answer>
  void start(Request request, Answer answer);

  std::shared_ptr<std::atomic<double>> progress_;
  QTimer timer_;
  Background background_;
};

}  // namespace perilymph::gui
