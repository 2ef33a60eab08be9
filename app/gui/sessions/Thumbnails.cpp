#include "Thumbnails.h"

#include <QImage>
#include <algorithm>

#include "SessionPicture.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/RealTime.h"
#include "perilymph/session/Playback.h"

namespace perilymph::gui {

namespace {

constexpr int fineness = 2;  // pixels a point, for dense screens

// The shape at the deepest place is computed from the beginning: some seconds at most.
constexpr std::uint64_t mostTicks = 60'000;

QString keyOf(const session::SessionSummary& summary)
{
  return QStringLiteral("%1-%2-%3")
      .arg(QString::fromStdString(summary.file.stem().string()))
      .arg(summary.bytes)
      .arg(summary.modified_ns);
}

std::filesystem::path fileOf(const session::SessionSummary& summary, const QString& key)
{
  return session::libraryCache(summary.file.parent_path()) / (key.toStdString() + ".png");
}

/// Nothing where the recording cannot be replayed.
QImage pictureOf(const std::filesystem::path& file)
{
  const auto playback = session::Playback::open(file);
  if (!playback) return {};
  const auto& samples = (*playback)->samples();
  const auto deepest = std::max_element(
      samples.begin(), samples.end(),
      [](const auto& one, const auto& other) { return one.output.depth < other.output.depth; });
  haptics::Snapshot now{};
  const bool hasShape = deepest->place < mostTicks && bool((*playback)->show(deepest->place, now));
  const session::Scenario& scenario = (*playback)->scenario();
  QImage image(fineness * Thumbnails::size, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  paintInsertion(
      painter, image.rect(),
      {*(*playback)->anatomy(), scenario.array, scenario.patient.side, hasShape ? &now : nullptr},
      screenInks());
  painter.end();
  return image;
}

}  // namespace

Thumbnails::Thumbnails(QObject* parent)
    : QObject(parent), isEnding_(std::make_shared<std::atomic<bool>>(false))
{
  thread_.setMaxThreadCount(1);
}

Thumbnails::~Thumbnails()
{
  *isEnding_ = true;
  thread_.waitForDone();
}

QPixmap Thumbnails::find(const session::SessionSummary& summary)
{
  const QString key = keyOf(summary);
  const auto found = known_.constFind(key);
  if (found != known_.constEnd()) return *found;
  QPixmap blank(fineness * size);
  blank.setDevicePixelRatio(fineness);
  blank.fill(Qt::transparent);
  const bool canBePainted =
      !summary.isBeingRecorded && summary.highlights.ticks > 0 && !asked_.contains(key);
  if (!canBePainted) return blank;
  QPixmap kept(QString::fromStdString(fileOf(summary, key).string()));
  if (!kept.isNull()) {
    kept.setDevicePixelRatio(fineness);
    return *known_.insert(key, kept);
  }
  asked_.insert(key);
  paint(summary, key);
  return blank;
}

void Thumbnails::paint(const session::SessionSummary& summary, const QString& key)
{
  thread_.start([this, summary, key, isEnding = isEnding_] {
    if (*isEnding) return;
    registerThreadRole(ThreadRole::worker);
    const QImage image = pictureOf(summary.file);
    if (image.isNull()) return;
    // What cannot be kept is painted again next time.
    static_cast<void>(writeWhole(fileOf(summary, key), [&](const std::filesystem::path& place) {
      return image.save(QString::fromStdString(place.string()), "PNG");
    }));
    QMetaObject::invokeMethod(
        this,
        [this, key, image] {
          QPixmap pixmap = QPixmap::fromImage(image);
          pixmap.setDevicePixelRatio(fineness);
          known_.insert(key, pixmap);
          Q_EMIT painted();
        },
        Qt::QueuedConnection);
  });
}

}  // namespace perilymph::gui
