// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Pictures that a person took of a CT for the reports of its patient, each a file with its caption.

#include <QImage>
#include <QString>
#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// Size of a key image [px]: 120 mm at 254 dots per inch on paper.
inline constexpr int keyImageWidth_px = 1200, keyImageHeight_px = 900;

struct CtKeyImage {
  std::filesystem::path file;
  QString caption;  ///< Words of the person who took it; it may be empty.
  QString place;    ///< Plane, position and thickness.
};

/// At most this many of a series are kept, and written into a report.
inline constexpr std::size_t maxKeyImages = 24;

/// The key images of a CT series, in the order in which they were taken; none without a series.
///
/// @param seriesKey  SHA-256 of the series.
std::vector<CtKeyImage> ctKeyImages(const std::string& seriesKey);

/// Keeps a picture for its owner only, in `key-images` beside the patients; its name has the series' hash, no word of a
/// person. Refuses one more than maxKeyImages.
Result<void> keepCtKeyImage(const std::string& seriesKey, QImage picture, const QString& caption,
                            const QString& place);

void removeCtKeyImage(const std::filesystem::path& file);

}  // namespace perilymph::gui
