// SPDX-License-Identifier: BSD-3-Clause
#include "Thumbnail.h"

#include <algorithm>
#include <cmath>
#include <stop_token>

#include "FrameDecoder.h"
#include "perilymph/foundation/Quantile.h"

namespace perilymph::imaging {

Result<CtThumbnail> thumbnailOf(const DicomSeries& series, int edge, const std::stop_token& stop)
{
  if (!series.stack || !series.summary.obstacle.empty()) return Error{series.summary.obstacle};
  const auto& places = series.stack->places;
  const SliceSource& slice = series.slices[places[places.size() / 2].front()];
  const DicomHeader& header = series.headers[slice.header];
  const auto frames = decodeFrames(header, stop);
  if (!frames) return frames.error();
  const int rows = header.rows, columns = header.columns;
  const auto first = frames->voxels.begin() + static_cast<std::ptrdiff_t>(slice.frame) *
                                                  static_cast<std::ptrdiff_t>(rows) * columns;
  const int step = std::max(1, (std::max(rows, columns) + edge - 1) / edge);
  CtThumbnail picture{series.summary.uid, columns / step, rows / step, {}};
  std::vector<double> means;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      double sum = 0.0;
      for (int dy = 0; dy < step; ++dy)
        for (int dx = 0; dx < step; ++dx)
          sum += ct::asAir(
              first[static_cast<std::ptrdiff_t>(y * step + dy) * columns + x * step + dx]);
      means.push_back(sum / (step * step));
    }
  if (means.empty()) return Error{"The series' slices are too small for a picture."};
  const double black = quantile(means, 0.01), white = quantile(means, 0.99);
  for (const double mean : means)
    picture.gray.push_back(static_cast<std::uint8_t>(std::lround(
        std::clamp(255.0 * (mean - black) / std::max(1.0, white - black), 0.0, 255.0))));
  return picture;
}

}  // namespace perilymph::imaging
