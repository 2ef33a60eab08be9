// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/CtKeyImages.h"

#include <QImageReader>
#include <algorithm>
#include <system_error>

#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::gui {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t keyDigits = 64, nameDigits = 32;  // of SHA-256, and of a file's name
constexpr int longestText = 400;                        // of a file that another program wrote
constexpr int numberDigits = 4;
constexpr int firstNumber = 1, lastNumber = 9999;

QString captionKey() { return QStringLiteral("Caption"); }
QString placeKey() { return QStringLiteral("Place"); }
QString seriesKeyKey() { return QStringLiteral("Series"); }

fs::path folder() { return patientFolder() / "key-images"; }

bool isKey(const std::string& text)
{
  return text.size() == keyDigits &&
         text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::string prefixOf(const std::string& seriesKey)
{
  return "ct-" + seriesKey.substr(0, nameDigits) + "-";
}

fs::path fileOf(const std::string& seriesKey, int number)
{
  const QString digits = QStringLiteral("%1").arg(number, numberDigits, 10, QLatin1Char('0'));
  return folder() / (prefixOf(seriesKey) + digits.toStdString() + ".png");
}

}  // namespace

std::vector<CtKeyImage> ctKeyImages(const std::string& seriesKey)
{
  std::vector<CtKeyImage> found;
  if (!isKey(seriesKey)) return found;
  std::error_code failure;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(folder(), failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with(prefixOf(seriesKey)) && entry->path().extension() == ".png")
      files.push_back(entry->path());
  }
  std::ranges::sort(files);
  for (const fs::path& file : files) {
    QImageReader reader(QString::fromStdString(file.string()), "png");
    const QSize size = reader.size();
    // the name has half of the hash; the file has all of it
    const bool isOfSeries = reader.text(seriesKeyKey()).toStdString() == seriesKey;
    if (!isOfSeries || size != QSize(keyImageWidth_px, keyImageHeight_px)) continue;
    found.push_back({file, reader.text(captionKey()).left(longestText).simplified(),
                     reader.text(placeKey()).left(longestText).simplified()});
    if (found.size() == maxKeyImages) break;
  }
  return found;
}

Result<void> keepCtKeyImage(const std::string& seriesKey, QImage picture, const QString& caption,
                            const QString& place)
{
  if (!isKey(seriesKey))
    return Error{
        "The CT has no series that a key image could be kept with. Open it from its files."};
  const auto known = ctKeyImages(seriesKey);
  if (known.size() >= maxKeyImages)
    return Error{"The CT has %1 key images; no more are kept. Remove one.", maxKeyImages};
  std::error_code failure;
  fs::create_directories(folder(), failure);  // an error is reported when the file is written
  int number = firstNumber;
  for (const CtKeyImage& each : known) {
    const std::string stem = each.file.stem().string();
    number = std::max(number, QString::fromStdString(stem.substr(stem.rfind('-') + 1)).toInt() + 1);
  }
  picture.setText(seriesKeyKey(), QString::fromStdString(seriesKey));
  picture.setText(captionKey(), caption);
  picture.setText(placeKey(), place);
  return writeWhole(fileOf(seriesKey, std::min(number, lastNumber)),
                    [&](const fs::path& file) {
                      return picture.save(QString::fromStdString(file.string()), "PNG");
                    },
                    {Links::refused, Audience::owner});
}

void removeCtKeyImage(const fs::path& file)
{
  std::error_code ignored;  // a file that is gone is removed
  fs::remove(file, ignored);
}

}  // namespace perilymph::gui
