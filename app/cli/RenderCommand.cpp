// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"

#if PERILYMPH_HAS_TOOLKIT

#include <array>
#include <utility>

#include "CommandFiles.h"
#include "PatientOption.h"
#include "Terminal.h"
#include "perilymph/charts/FigurePicture.h"
#include "perilymph/charts/UnrolledScala.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/visualization/Picture.h"

namespace perilymph::cli {

namespace {

using visualization::CameraPreset;

constexpr auto unrolledView = "unrolled";

Result<CameraPreset> presetOf(const std::string& view)
{
  if (view == unrolledView) return CameraPreset::surgeon;  // not used: the view is flat
  constexpr std::array<std::pair<const char*, CameraPreset>, 4> views = {
      {{"surgeon", CameraPreset::surgeon},
       {"microscope", CameraPreset::microscope},
       {"overview", CameraPreset::overview},
       {"section", CameraPreset::section}}};
  for (const auto& [name, preset] : views)
    if (view == name) return preset;
  return Error{"--view " + view +
               " is not known; use surgeon, microscope, overview, section or unrolled."};
}

/// The unrolled scala, which needs no display.
Result<void> drawUnrolled(const visualization::PictureRequest& request)
{
  constexpr double width = 480.0, height = 320.0;  // at three pixels a point 1440 x 960
  if (request.file.extension() != ".png")
    return Error{"The picture " + request.file.string() + " must end in .png."};
  charts::ArrayInScala array(*request.scala, request.array.value_or(electrode::ArrayDesign{}));
  if (request.now != nullptr) array.follow(*request.now);
  return charts::writePicture(charts::UnrolledScala(*request.scala).drawPage(array, width, height),
                              request.file);
}

Result<void> draw(const RenderOptions& options, const visualization::PictureRequest& request)
{
  const auto done =
      options.view == unrolledView ? drawUnrolled(request) : visualization::renderPicture(request);
  if (done) print("Wrote {}\n", request.file);
  return done;
}

/// The cochlea without an array.
Result<void> drawAnatomy(const RenderOptions& options, visualization::PictureRequest request)
{
  anatomy::Cochlea cochlea;
  if (const auto preset = anatomy::anatomySourceNamed(options.preset)) {
    cochlea.source = *preset;
    cochlea.patient.label = options.preset;
  }
  if (!options.patient.empty()) {
    const auto patient = readPatient(options.patient);
    if (!patient) return patient.error();
    cochlea.patient = *patient;
    cochlea.source = sourceScaledBy(measuresOf(*patient));
  }
  const auto scala = anatomy::buildAnatomy(cochlea, cochlea.patient.label);
  if (!scala) return scala.error();
  request.scala = *scala;
  request.side = cochlea.patient.side;
  return draw(options, request);
}

/// The array in its cochlea, inserted to a travel in virtual time.
Result<void> drawInsertion(const RenderOptions& options, const CommandFiles& files,
                           visualization::PictureRequest request)
{
  session::Overrides overrides;
  if (!options.patient.empty()) overrides.emplace_back("patient", options.patient);
  if (!options.array.empty()) overrides.emplace_back("array", options.array);
  const auto scenario = session::loadScenario(options.scenario, overrides);
  if (!scenario) return scenario.error();
  if (const auto done = files.checkScenarioFiles(scenario->files()); !done) return done.error();
  printNoteOn(scenario->patient());
  const Length wanted = options.at_mm ? millimeters(*options.at_mm) : scenario->stopTravel();
  if (wanted < Length() || wanted > scenario->stopTravel())
    return Error{"--at-mm is " + fixed(inMillimeters(wanted), 2) + "; it must be between 0 and " +
                 fixed(inMillimeters(scenario->stopTravel()), 2) +
                 ", the scenario's stop_travel_mm."};

  auto device =
      std::make_unique<device::ScriptedDevice>(scenario->speed().si(), scenario->timeStep().si());
  auto insertion = session::Insertion::prepare(*scenario, std::move(device), std::nullopt);
  if (!insertion) return insertion.error();
  // an array that yielded leaves the cochlea bent
  const bool toItsEnd = scenario->withdraws() && !options.at_mm;
  const auto ran = (*insertion)->runToEnd([&](const haptics::TickRecord& record) {
    return toItsEnd || record.output.travel < wanted.si();
  });
  if (!ran) return ran.error();
  (*insertion)->refresh();
  request.scala = (*insertion)->sharedAnatomy();
  request.side = scenario->patient().side;
  request.array = scenario->array();
  request.now = &(*insertion)->latest();
  return draw(options, request);
}

}  // namespace

Result<void> render(const RenderOptions& options, const CommandFiles& files)
{
  const auto view = presetOf(options.view);
  if (!view) return view.error();
  visualization::PictureRequest request;
  request.view = *view;
  request.file = options.out;
  if (options.scenario.empty()) return drawAnatomy(options, std::move(request));
  return drawInsertion(options, files, std::move(request));
}

}  // namespace perilymph::cli

#else

namespace perilymph::cli {

Result<void> render(const RenderOptions&, const CommandFiles&)
{
  return Error{"This build has no VTK, so it cannot draw; use a build of the preset release."};
}

}  // namespace perilymph::cli

#endif
