// SPDX-License-Identifier: BSD-3-Clause
#include "gui/program/CrashRecovery.h"

#include <spdlog/spdlog.h>

#include <optional>
#include <stop_token>

#include "gui/run/Background.h"
#include "gui/shell/MainWindow.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/Notice.h"
#include "perilymph/session/Replay.h"

namespace perilymph::gui {

namespace {

constexpr std::uint64_t replayedTicks = 1000;

using LastRecording = std::optional<session::SessionSummary>;

/// The first recording of an insertion.
LastRecording firstKept(const std::vector<std::filesystem::path>& recordings,
                        const Summarize& summarize, const std::stop_token& stop)
{
  for (const std::filesystem::path& recording : recordings) {
    if (stop.stop_requested()) break;
    session::SessionSummary left = summarize(recording, stop);
    spdlog::warn("The program ended while it was writing {}; {} ticks of it are kept.",
                 recording.string(), left.highlights.ticks);
    if (session::isInsertion(left)) return left;
  }
  return std::nullopt;
}

void offer(MainWindow& window, const session::SessionSummary& left)
{
  const QString depth = numberText(inMillimeters(Length::fromSi(left.highlights.deepest)), 1);
  const QString sentence =
      MainWindow::tr(
          "The program closed unexpectedly. Your last insertion (depth %1 mm) was recovered: %2.")
          .arg(depth, QString::fromStdString(left.file.stem().string()));
  window.notice().offer(sentence, MainWindow::tr("Show recordings"),
                        [&window] { window.showPage(QStringLiteral("sessions")); });
}

}  // namespace

session::SessionSummary summarizeReplayable(const std::filesystem::path& file,
                                            const std::stop_token& stop)
{
  session::SessionSummary left = session::summarize(file, stop);
  if (!session::isInsertion(left)) return left;
  bool isEnough = false;
  std::stop_source end;
  const std::stop_callback forward(stop, [&end] { end.request_stop(); });
  const auto progress = [&](std::uint64_t done, std::uint64_t) {
    isEnough = done >= replayedTicks;
    if (isEnough) end.request_stop();
  };
  const auto replayed = session::verify(file, progress, end.get_token());
  const bool isSame = replayed && replayed->damage.empty() && !replayed->difference;
  if (isEnough || isSame) return left;
  spdlog::warn("{} cannot be replayed: {}", file.string(),
               replayed ? replayed->damage : replayed.error().message);
  left.highlights = {};
  return left;
}

void offerRecovery(MainWindow& window, const std::vector<std::filesystem::path>& recordings,
                   const Summarize& summarize)
{
  if (recordings.empty()) return;
  auto* reading = new Background(&window);
  const auto read = [reading, &window, recordings, summarize] {
    reading->run(
        "The interrupted insertion",
        [recordings, summarize](const std::stop_token& stop) -> Result<LastRecording> {
          return firstKept(recordings, summarize, stop);
        },
        [&window](const Result<LastRecording>& kept) {
          if (!kept) return spdlog::warn("{}", kept.error().message);
          if (*kept) offer(window, **kept);
        });
  };
  QObject::connect(&window, &MainWindow::firstFrameShown, reading, read);
}

}  // namespace perilymph::gui
