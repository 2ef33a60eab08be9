// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/sessions/ReportContent.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QFile>
#include <algorithm>

#include "gui/pages/sessions/SessionPicture.h"
#include "perilymph/session/Playback.h"
#include "perilymph/session/RecordedInsertion.h"

namespace perilymph::gui {

namespace {

constexpr int pictureWidth_px = 900, pictureHeight_px = 640;

QString sha256Of(const std::filesystem::path& path)
{
  QFile file(QString::fromStdString(path.string()));
  QCryptographicHash hash(QCryptographicHash::Sha256);
  if (!file.open(QIODevice::ReadOnly) || !hash.addData(&file)) return {};
  return QString::fromLatin1(hash.result().toHex());
}

/// The array at its maximum depth.
Result<QImage> pictureOf(session::Playback& playback, double& depth_mm)
{
  const auto& samples = playback.samples();
  const auto deepest = std::max_element(
      samples.begin(), samples.end(),
      [](const auto& one, const auto& other) { return one.output.depth < other.output.depth; });
  haptics::Snapshot now{};
  if (const auto done = playback.show(deepest->place, now); !done) return done.error();
  depth_mm = inMillimeters(meters(now.output.depth));
  const session::Scenario& scenario = playback.scenario();
  QImage image(pictureWidth_px, pictureHeight_px, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  paintInsertion(painter, image.rect(),
                 {*playback.anatomy(), scenario.array(), scenario.patient().side, &now},
                 printInks());
  painter.end();
  return image;
}

}  // namespace

Result<ReportContent> gatherReport(const std::filesystem::path& file,
                                   const std::atomic<bool>& isCanceled)
{
  ReportContent content;
  content.file = file;
  const auto recorded = session::RecordedInsertion::open(file);
  if (!recorded) return recorded.error();
  content.facts = recorded->facts();
  content.lostRecords = recorded->lostRecords();
  content.wasClosed = recorded->wasClosed();
  std::error_code ignored;
  content.bytes = std::filesystem::file_size(file, ignored);
  content.sha256 = sha256Of(file);
  auto insertion = analysis::readCompared(file, [&isCanceled] { return !isCanceled; });
  if (!insertion) return insertion.error();
  content.insertion = *std::move(insertion);
  if (const auto score = analysis::scoreOf(content.insertion)) content.score = *score;
  if (const auto published = analysis::shippedReference("todd-naghdy-experiment"))
    content.published = *published;

  const auto playback = session::Playback::open(file);
  if (!playback) return playback.error();
  content.scenario = (*playback)->scenario();
  const auto verification =
      (*playback)->compute([&isCanceled](std::uint64_t, std::uint64_t) { return !isCanceled; });
  if (!verification) return verification.error();
  content.verification = *verification;
  auto picture = pictureOf(**playback, content.depth_mm);
  if (!picture) return picture.error();
  content.picture = *std::move(picture);
  return content;
}

}  // namespace perilymph::gui
