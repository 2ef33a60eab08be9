// SPDX-License-Identifier: BSD-3-Clause
#include "gui/archive/ArchiveWork.h"

#include <stop_token>
#include <utility>

#include "gui/text/DataText.h"
#include "perilymph/archive/Echo.h"

namespace perilymph::gui {

namespace {

constexpr int report_ms = 100;

}  // namespace

ArchiveWork::ArchiveWork(QObject* parent) : QObject(parent), background_(this)
{
  timer_.setInterval(report_ms);
  connect(&timer_, &QTimer::timeout, this, [this] {
    if (progress_) Q_EMIT progressed(progress_->load());
  });
}

template <class Request, class Answer>
void ArchiveWork::start(Request request, Answer answer)
{
  progress_ = std::make_shared<std::atomic<double>>(0.0);
  timer_.start();
  background_.run(
      "The request to the archive",
      [request = std::move(request), progress = progress_](const std::stop_token& stop) {
        archive::Exchange exchange;
        exchange.stop = stop;
        exchange.onProgress = [progress](double done) { progress->store(done); };
        return request(exchange);
      },
      [this, answer = std::move(answer)](const auto& result) {
        timer_.stop();
        progress_.reset();
        if (!result) return failed(dataText(result.error().message));
        answer(result);
      });
}

void ArchiveWork::echo(const archive::Server& server)
{
  start([server](const archive::Exchange& exchange) { return archive::echo(server, exchange); },
        [this](const Result<void>&) { answered(); });
}

void ArchiveWork::findStudies(const archive::Server& server, const archive::StudyQuery& query)
{
  start(
      [server, query](const archive::Exchange& exchange) {
        return archive::findStudies(server, query, exchange);
      },
      [this](const auto& found) { studiesFound(*found); });
}

void ArchiveWork::findSeries(const archive::Server& server, const std::string& studyUid)
{
  start(
      [server, studyUid](const archive::Exchange& exchange) {
        return archive::findSeries(server, studyUid, exchange);
      },
      [this](const auto& found) { seriesFound(*found); });
}

void ArchiveWork::fetch(const archive::Server& server, const archive::SeriesAddress& series,
                        const std::filesystem::path& folder)
{
  start(
      [server, series, folder](const archive::Exchange& exchange) {
        return archive::fetchSeries(server, series, folder, exchange);
      },
      [this, folder](const auto&) { fetched(folder); });
}

void ArchiveWork::run(std::function<Result<Sentence>(const archive::Exchange&)> request)
{
  start([request =
             std::move(request)](const archive::Exchange& exchange) { return request(exchange); },
        [this](const auto& sentence) { done(dataText(*sentence)); });
}

void ArchiveWork::cancel()
{
  if (!isBusy()) return;
  background_.cancel();
  timer_.stop();
  progress_.reset();
  Q_EMIT failed({});
}

}  // namespace perilymph::gui
