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
#if PERILYMPH_HAS_TOOLKIT
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/imaging/Landmarks.h"
#include "perilymph/imaging/MeasuredPatient.h"
#include "perilymph/imaging/MeasuredPicture.h"
#include "perilymph/imaging/MeasuredSurface.h"
#endif

namespace perilymph::cli {

#if PERILYMPH_HAS_TOOLKIT

namespace {

Result<ct::MeasureRequest> requestOf(const CtMeasureOptions& options)
{
  ct::MeasureRequest request;
  if (options.at_mm)
    request.click_P =
        Eigen::Vector3d((*options.at_mm)[0], (*options.at_mm)[1], (*options.at_mm)[2]);
  if (!options.landmarks.empty()) {
    const auto marks = imaging::readLandmarks(options.landmarks);
    if (!marks) return marks.error();
    request.click_P = marks->inside_P();
    request.marks = *marks;
  }
  if (!options.side.empty())
    request.side = options.side == "left" ? anatomy::Side::left : anatomy::Side::right;
  return request;
}

void printMeasure(const char* name, const ct::Measure& measure)
{
  const auto interval = measure.interval95();
  print("{:12} {} mm, standard deviation {}, 95 % within {} to {}\n", name, fixed(measure.value, 2),
        fixed(measure.sd(), 2), fixed(interval[0], 2), fixed(interval[1], 2));
}

void printPoint(const char* name, const Eigen::Vector3d& point)
{
  print("{:12} {}, {}, {} mm (LPS)\n", name, fixed(point.x(), 2), fixed(point.y(), 2),
        fixed(point.z(), 2));
}

void printMeasures(const ct::CochleaMeasures& measures, const imaging::CtSeries& series)
{
  print("{} ear\n", measures.side == anatomy::Side::left ? "left" : "right");
  printMeasure("A", measures.a);
  printMeasure("B", measures.b);
  printMeasure("H", measures.h);
  printMeasure("CDL (OC)", measures.cdlOc);
  printPoint("round window", measures.roundWindow_P);
  printPoint("center", measures.center_P);
  for (const ct::Flag flag : measures.flags)
    print("{}: {}\n", ct::nameOf(flag), ct::sentenceOf(flag));
  for (const std::string& warning : series.warnings) print("{}\n", warning);
}

Result<Done> writeFiles(const CtMeasureOptions& options, const ct::CochleaMeasures& measures,
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
  if (options.surface.empty()) return Done{};
  return anatomy::writeSurface(imaging::measuredSurface(measures), imaging::measuredSurfaceTitle,
                               options.surface);
}

}  // namespace

Result<Done> ctMeasure(const CtMeasureOptions& options)
{
  const auto request = requestOf(options);
  if (!request) return request.error();
  const auto start = std::chrono::steady_clock::now();
  const auto loaded = imaging::readCt(options.path, options.series);
  if (!loaded) return loaded.error();
  const auto measures = ct::measureCochlea(loaded->volume, *request);
  if (!measures) return Error{options.path + ": " + measures.error().message};
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  if (const auto done = writeFiles(options, *measures, *loaded, took.count()); !done)
    return done.error();
  printMeasures(*measures, loaded->series);
  return Done{};
}

#else

Result<Done> ctMeasure(const CtMeasureOptions&)
{
  return Error{"This build has no VTK, so it cannot read a CT; use a build of the preset release."};
}

#endif

}  // namespace perilymph::cli
