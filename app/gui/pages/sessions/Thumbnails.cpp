// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/sessions/Thumbnails.h"

#include <QImage>
#include <algorithm>
#include <stop_token>

#include "gui/report/InsertionPicture.h"
#include "gui/widgets/Theme.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/session/Playback.h"

namespace perilymph::gui {

namespace {

constexpr int fineness = 2;  // pixels per point, for high-resolution screens

// A shape is computed from the beginning: limit this to some seconds.
constexpr std::uint64_t maxTicks = 120'000;

// An array that rests at full depth moves by less.
constexpr Length atRest = millimeters(0.02);

QString keyOf(const session::SessionSummary& summary)
{
  // the colors, and a letter for the way of choosing the moment
  const bool isLight = shownColorScheme() == ColorScheme::light;
  return QStringLiteral("%1-%2-%3%4")
      .arg(QString::fromStdString(summary.file.stem().string()))
      .arg(summary.bytes)
      .arg(summary.modified_ns)
      .arg(isLight ? QStringLiteral("bl") : QStringLiteral("bd"));
}

std::filesystem::path fileOf(const session::SessionSummary& summary, const QString& key)
{
  return session::libraryCache(summary.file.parent_path()) / (key.toStdString() + ".png");
}

/// Saves a thumbnail in the library's cache. If that fails, it is painted again next time.
void keep(const QImage& image, const std::filesystem::path& file)
{
  std::error_code ignored;
  if (!session::makeLibraryCache(file.parent_path().parent_path()) ||
      std::filesystem::is_symlink(file, ignored))
    return;
  static_cast<void>(writeWhole(file, [&image](const std::filesystem::path& place) {
    return image.save(QString::fromStdString(place.string()), "PNG");
  }));
}

/// Null if the recording cannot be replayed.
QImage pictureOf(const std::filesystem::path& file, const PictureInks& inks)
{
  const auto playback = session::Playback::open(file);
  if (!playback) return {};
  const auto& samples = (*playback)->samples();
  const auto deepest = std::max_element(
      samples.begin(), samples.end(),
      [](const auto& one, const auto& other) { return one.output.depth < other.output.depth; });
  // the end of the insertion, not of the rest after it; of a long one what is soon computed
  const auto end = std::find_if(samples.begin(), samples.end(), [&](const auto& sample) {
    return sample.output.depth >= deepest->output.depth - atRest.si();
  });
  haptics::Snapshot now{};
  const bool hasShape = bool((*playback)->show(std::min(end->place, maxTicks), now));
  const session::Scenario& scenario = (*playback)->scenario();
  QImage image(fineness * Thumbnails::size, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  paintInsertion(painter, image.rect(),
                 {*(*playback)->anatomy(), scenario.array(), scenario.patient().side,
                  hasShape ? &now : nullptr},
                 inks);
  painter.end();
  return image;
}

}  // namespace

QPixmap Thumbnails::find(const session::SessionSummary& summary)
{
  const QString key = keyOf(summary);
  const auto found = known_.constFind(key);
  if (found != known_.constEnd()) return *found;
  QPixmap blank(fineness * size);
  blank.setDevicePixelRatio(fineness);
  blank.fill(Qt::transparent);
  const bool canBePainted = session::isInsertion(summary) && !impossible_.contains(key);
  if (!canBePainted || key == painting_) return blank;
  const auto wish = std::find_if(wishes_.begin(), wishes_.end(),
                                 [&key](const PendingRequest& each) { return each.key == key; });
  if (wish != wishes_.end()) {
    std::rotate(wish, wish + 1, wishes_.end());
    return blank;
  }
  QPixmap kept(QString::fromStdString(fileOf(summary, key).string()));
  if (!kept.isNull()) {
    kept.setDevicePixelRatio(fineness);
    return *known_.insert(key, kept);
  }
  wishes_.push_back({summary, key});
  if (wishes_.size() > maxRequests) wishes_.erase(wishes_.begin());
  if (painting_.isEmpty()) paintNext();
  return blank;
}

void Thumbnails::paintNext()
{
  painting_.clear();
  if (wishes_.empty()) return;
  const PendingRequest wish = std::move(wishes_.back());
  wishes_.pop_back();
  painting_ = wish.key;
  background_.run(
      "The picture",
      [wish, inks = screenInks()](const std::stop_token&) -> Result<QImage> {
        QImage image = pictureOf(wish.summary.file, inks);
        if (!image.isNull()) keep(image, fileOf(wish.summary, wish.key));
        return image;
      },
      [this, wish](const Result<QImage>& image) {
        if (!image || image->isNull()) {
          impossible_.insert(wish.key);
        } else {
          QPixmap pixmap = QPixmap::fromImage(*image);
          pixmap.setDevicePixelRatio(fineness);
          known_.insert(wish.key, pixmap);
        }
        paintNext();
        Q_EMIT painted(wish.summary.file);
      });
}

}  // namespace perilymph::gui
