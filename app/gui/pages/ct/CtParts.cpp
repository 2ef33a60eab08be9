// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/CtParts.h"

#include <QCoreApplication>
#include <utility>

#include "perilymph/archive/MeasuredObjects.h"
#include "perilymph/archive/SecondaryCapture.h"
#include "perilymph/imaging/MeasuredPicture.h"

namespace perilymph::gui {

namespace {

namespace fs = std::filesystem;

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

}  // namespace

std::vector<SentPart> ctParts(const CtStudy& study)
{
  const auto measures = study.measures();
  const auto volume = study.volume();
  return {{tr("A, B, H and duct length with their errors (structured report)"),
           [measures](const fs::path& ct, const fs::path& file) {
             return archive::writeMeasurementReport(archive::reportOf(*measures), ct, file);
           }},
          {tr("The fitted lumen (segmentation)"),
           [measures](const fs::path& ct, const fs::path& file) {
             return archive::writeSegmentation(archive::lumenOf(*measures), ct, file);
           }},
          {tr("The cochlear view with A and B (picture)"),
           [measures, volume](const fs::path& ct, const fs::path& file) {
             auto picture = imaging::measuredPicture(volume, *measures);
             return archive::writeSecondaryCapture(
                 {picture.width, picture.height, std::move(picture.rgb), picture.pixel_mm,
                  measures->side == anatomy::Side::right, archive::pictureDescription(*measures),
                  archive::reportOf(*measures).software, measures->provenance.seriesKey},
                 ct, file);
           }}};
}

}  // namespace perilymph::gui
