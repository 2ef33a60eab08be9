// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "Commands.h"
#include "CtMeasuresJson.h"
#include "Terminal.h"
#include "perilymph/anatomy/Surface.h"
#include "perilymph/ct/Measures.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Version.h"
#if PERILYMPH_HAS_TOOLKIT
#include "perilymph/archive/MeasuredObjects.h"
#include "perilymph/archive/SecondaryCapture.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/imaging/Landmarks.h"
#include "perilymph/imaging/MeasuredPatient.h"
#include "perilymph/imaging/MeasuredPicture.h"
#include "perilymph/imaging/MeasuredSurface.h"
#endif

namespace perilymph::cli {

#if PERILYMPH_HAS_TOOLKIT

namespace {

Result<ct::MeasureRequest> requestOf(const CtMeasureOptions& options, const std::string& seriesKey)
{
  ct::MeasureRequest request;
  if (options.at_mm)
    request.click_P =
        Eigen::Vector3d((*options.at_mm)[0], (*options.at_mm)[1], (*options.at_mm)[2]);
  if (!options.landmarks.empty()) {
    const auto marks = imaging::readLandmarks(options.landmarks, seriesKey);
    if (!marks) return marks.error();
    request.click_P = marks->inside_P();
    request.marks = *marks;
  }
  request.side = valueIn(anatomy::sides, options.side);  // none of them: either
  return request;
}

void printMeasure(const char* name, const ct::Measure& measure, int decimals = 2)
{
  const double halfWidth = 0.5 * (measure.interval95()[1] - measure.interval95()[0]);
  print("{:12} {} ± {} mm (95 %)\n", name, fixed(measure.value, decimals),
        fixed(halfWidth, decimals));
}

void printPoint(const char* name, const Eigen::Vector3d& point)
{
  print("{:12} {}, {}, {} mm (LPS)\n", name, fixed(point.x(), 2), fixed(point.y(), 2),
        fixed(point.z(), 2));
}

void printMeasures(const ct::CochleaMeasures& measures)
{
  print("{} ear\n", anatomy::nameOf(measures.side));
  printMeasure("A", measures.a);
  printMeasure("B", measures.b);
  printMeasure("H", measures.h);
  if (measures.cdlOc)
    printMeasure("CDL (OC)", *measures.cdlOc, 1);
  else if (measures.has(ct::Flag::fewTurns))
    print("{:12} not given: {} turns of the lumen were seen\n", "CDL (OC)",
          fixed(measures.turnsSeen, 1));
  else
    print("{:12} not given: no modiolus was seen within the middle turn\n", "CDL (OC)");
  printPoint("round window", measures.roundWindow_P);
  printPoint("center", measures.center_P);
  for (const ct::Flag flag : measures.flags)
    print("{}: {}\n", ct::nameOf(flag), ct::sentenceOf(flag));
  for (const Sentence& sentence : ct::landmarkContradictions(measures)) print("{}\n", sentence);
  if (const auto note = imaging::heightNote(measures)) print("{}\n", *note);
  if (measures.otherCochlea_P)
    print("A second cochlea lies at {},{},{} mm (LPS): give --side or --at.\n",
          fixed(measures.otherCochlea_P->x(), 1), fixed(measures.otherCochlea_P->y(), 1),
          fixed(measures.otherCochlea_P->z(), 1));
}

void printWarnings(const imaging::CtSeries& series)
{
  for (const std::string& warning : series.warnings) print("{}\n", warning);
}

Result<void> writeFiles(const CtMeasureOptions& options, const ct::CochleaMeasures& measures,
                        const imaging::LoadedCt& loaded, double seconds)
{
  if (!options.json.empty())
    if (const auto done =
            writeWhole(options.json, measuresJson(measures, loaded.series.warnings, seconds));
        !done)
      return done.error();
  if (!options.patient.empty()) {
    const std::filesystem::path file = options.patient;
    if (const auto done =
            imaging::writeMeasuredPatient(measures, file.stem().string(), options.patient);
        !done)
      return done.error();
  }
  if (!options.picture.empty())
    if (const auto done = imaging::writeMeasuredPicture(
            std::make_shared<const ct::CtVolume>(loaded.volume), measures, options.picture);
        !done)
      return done.error();
  if (!options.structuredReport.empty())
    if (const auto done = archive::writeMeasurementReport(archive::reportOf(measures), options.path,
                                                          options.structuredReport);
        !done)
      return done.error();
  if (!options.segmentation.empty())
    if (const auto done = archive::writeSegmentation(archive::lumenOf(measures), options.path,
                                                     options.segmentation);
        !done)
      return done.error();
  if (!options.keyImage.empty()) {
    auto picture =
        imaging::measuredPicture(std::make_shared<const ct::CtVolume>(loaded.volume), measures);
    const archive::SecondaryCapture image{picture.width,
                                          picture.height,
                                          std::move(picture.rgb),
                                          picture.pixel_mm,
                                          measures.side == anatomy::Side::right,
                                          archive::pictureDescription(measures),
                                          archive::reportOf(measures).software,
                                          measures.provenance.seriesKey};
    if (const auto done = archive::writeSecondaryCapture(image, options.path, options.keyImage);
        !done)
      return done.error();
  }
  if (options.surface.empty()) return {};
  return anatomy::writeSurface(imaging::measuredSurface(measures), imaging::measuredSurfaceTitle,
                               options.surface);
}

double elapsed_s(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Both ears of a volume: a point, landmarks and files of one ear are refused.
Result<void> measureBoth(const CtMeasureOptions& options)
{
  if (options.at_mm || !options.landmarks.empty())
    return Error{
        "--side both searches for both ears, so --at and --landmarks are not used. Leave them out, "
        "or give --side left or right."};
  if (!options.patient.empty() || !options.surface.empty() || !options.picture.empty() ||
      !options.structuredReport.empty() || !options.segmentation.empty() ||
      !options.keyImage.empty())
    return Error{
        "--patient, --surface, --picture, --structured-report, --segmentation and --key-image hold "
        "one ear, and --side both measures two. Measure each ear by --side left and right for its "
        "files."};
  const auto start = std::chrono::steady_clock::now();
  const auto loaded = imaging::readCt(options.path, options.series);
  if (!loaded) return loaded.error();
  const auto ears = ct::measureBothCochleae(loaded->volume, {});
  if (!ears) return Error{options.path + ": " + ears.error().message};
  if (!options.json.empty())
    if (const auto done = writeWhole(
            options.json, measuresJson(*ears, loaded->series.warnings, elapsed_s(start)));
        !done)
      return done.error();
  for (const ct::CochleaMeasures& ear : *ears) printMeasures(ear);
  printWarnings(loaded->series);
  return {};
}

}  // namespace

Result<void> ctMeasure(const CtMeasureOptions& options)
{
  if (options.side == "both") return measureBoth(options);
  const auto start = std::chrono::steady_clock::now();
  const auto loaded = imaging::readCt(options.path, options.series);
  if (!loaded) return loaded.error();
  const auto request = requestOf(options, loaded->series.key);
  if (!request) return request.error();
  const auto measures = ct::measureCochlea(loaded->volume, *request);
  if (!measures) return Error{options.path + ": " + measures.error().message};
  if (const auto done = writeFiles(options, *measures, *loaded, elapsed_s(start)); !done)
    return done.error();
  printMeasures(*measures);
  printWarnings(loaded->series);
  return {};
}

#else

Result<void> ctMeasure(const CtMeasureOptions&)
{
  return Error{"This build has no VTK, so it cannot read a CT; use a build of the preset release."};
}

#endif

}  // namespace perilymph::cli
