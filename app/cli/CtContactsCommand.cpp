// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "Commands.h"
#include "PatientOption.h"
#include "Terminal.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/outcome/FoundArray.h"
#include "perilymph/outcome/OutcomeText.h"
#if PERILYMPH_HAS_TOOLKIT
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/imaging/MeasuredPicture.h"
#endif

namespace perilymph::cli {

#if PERILYMPH_HAS_TOOLKIT

namespace {

/// The ear in the CT after surgery, with the CT before it if one is given.
Result<outcome::Ear> earOf(const CtContactsOptions& options, const imaging::LoadedCt& after)
{
  const ct::CtVolume& postoperative = after.volume;
  ct::MeasureRequest request;
  if (options.at_mm)
    request.click_P =
        Eigen::Vector3d((*options.at_mm)[0], (*options.at_mm)[1], (*options.at_mm)[2]);
  request.side = valueIn(anatomy::sides, options.side);
  if (options.preop.empty()) {
    auto ear = outcome::measuredEar(postoperative, request);
    if (!ear)
      return Error{"%1: %2 Give the CT before surgery with --preop%3.", options.path,
                   ear.error().message,
                   options.at_mm ? "" : ", or a point inside the cochlea with --at X,Y,Z"};
    return ear;
  }
  const auto preoperative = imaging::readCt(options.preop, options.preopSeries);
  if (!preoperative) return preoperative.error();
  if (preoperative->series.key == after.series.key)
    return Error{
        "%1 and %2 are the same series; --preop is the CT before surgery. Give that one, or leave "
        "--preop out.",
        options.path, options.preop};
  const auto measured = ct::measureCochlea(preoperative->volume, request);
  if (!measured) return Error{options.preop + ": " + measured.error().message};
  if (measured->has(ct::Flag::metal))
    return Error{
        "%1 shows metal in the cochlea, so that it is no CT before surgery. Give that one, or "
        "leave --preop out.",
        options.preop};
  auto ear = outcome::registeredEar(postoperative, preoperative->volume, *measured);
  if (!ear) return Error{options.path + ": " + ear.error().message};
  return ear;
}

void printFound(const outcome::FoundArray& found, const electrode::ArrayDesign& array)
{
  const auto halfWidth = [](const outcome::Uncertain& value) { return fixed(1.96 * value.sd, 0); };
  print("{} in the {} ear\n", array.name, anatomy::nameOf(found.side));
  print("{:26} {} ± {} degrees (95 %)\n", "angular insertion depth",
        fixed(found.angularInsertionDepth_deg.value, 0),
        halfWidth(found.angularInsertionDepth_deg));
  print("{:26} {} mm\n", "inserted length", fixed(found.insertedLength_mm, 1));
  print("{:26} {} of {}\n", "contacts inside", found.contactsInside, found.contacts.size());
  print("{:>3} {:>5} {:>9} {:>6} {:>9} {:>9} {:>10} {:>9}\n", "no.", "maker", "angle [°]", "± 95 %",
        "modiolus", "error", "ganglion", "in ST");
  for (const outcome::FoundContact& each : found.contacts)
    if (each.isInside)
      print("{:>3} {:>5} {:>9} {:>6} {:>6} mm {:>6} mm {:>7} Hz {:>9}\n", each.number,
            each.makerElectrode ? "E" + std::to_string(*each.makerElectrode) : "",
            fixed(each.angle_deg.value, 0), halfWidth(each.angle_deg), fixed(each.modiolus_mm, 2),
            fixed(each.error_mm(), 2), fixed(each.spiralGanglion_Hz[0], 0),
            fixed(each.inScalaTympani, 2));
    else
      print("{:>3} outside the cochlea\n", each.number);
  for (const outcome::Flag flag : found.flags)
    print("{}: {}\n", outcome::nameOf(flag), outcome::sentenceOf(flag));
}

Result<void> writeFiles(const CtContactsOptions& options, const outcome::OutcomeContent& content,
                        const outcome::Ear& ear, const imaging::LoadedCt& loaded)
{
  if (!options.json.empty())
    if (const auto done = writeWhole(options.json, outcome::outcomeJson(content)); !done)
      return done.error();
  if (!options.csv.empty()) {
    if (const auto done = writeWhole(options.csv, outcome::outcomeCsv(content.found)); !done)
      return done.error();
    std::filesystem::path dictionary = options.csv;
    dictionary.replace_filename(dictionary.stem().string() + "-dictionary.csv");
    if (const auto done = writeWhole(dictionary, outcome::outcomeDictionaryCsv()); !done)
      return done.error();
  }
  if (!options.markups.empty())
    if (const auto done = writeWhole(options.markups, outcome::outcomeMarkups(content.found));
        !done)
      return done.error();
  if (options.picture.empty()) return {};
  std::vector<Eigen::Vector3d> contacts_P;
  for (const outcome::FoundContact& each : content.found.contacts)
    contacts_P.push_back(each.position_P);
  return imaging::writeMeasuredPicture(std::make_shared<const ct::CtVolume>(loaded.volume),
                                       ear.measures, options.picture, contacts_P);
}

}  // namespace

Result<void> ctContacts(const CtContactsOptions& options)
{
  const auto file = findByName("array", "plugins/electrodes", options.array);
  if (!file) return file.error();
  auto array = electrode::loadArray(*file);
  if (!array) return array.error();
  std::optional<anatomy::Patient> patient;
  if (!options.patient.empty()) {
    auto read = readPatient(options.patient);
    if (!read) return read.error();
    patient = *std::move(read);
  }
  const auto loaded = imaging::readCt(options.path, options.series);
  if (!loaded) return loaded.error();
  auto ear = earOf(options, *loaded);
  if (!ear) return ear.error();
  if (const auto side = valueIn(anatomy::sides, options.side); side && *side != ear->measures.side)
    return Error{
        "%1 shows a %2 ear, and --side is %3. Leave --side out, or give the CT of that ear.",
        options.preop.empty() ? options.path : options.preop, anatomy::nameOf(ear->measures.side),
        options.side};
  const auto difference = patient ? outcome::differenceFrom(*ear, *patient) : std::nullopt;
  if (difference) ear->flags.push_back(outcome::Flag::anotherEar);
  outcome::ContactsRequest request;
  request.array = *array;
  request.arrayName = options.array;
  auto found = outcome::findContacts(loaded->volume, *ear, request);
  if (!found) {
    const bool isPoor =
        std::ranges::find(ear->flags, outcome::Flag::registrationPoor) != ear->flags.end();
    return Error{"%1: %2%3", options.path,
                 isPoor ? "The CTs before and after surgery do not agree around the cochlea: check "
                          "that both are of the same patient and ear. "
                        : "",
                 found.error().message};
  }
  outcome::OutcomeContent content;
  content.found = *std::move(found);
  content.surgery.array = options.array;
  content.series = loaded->series.key;
  if (const auto done = writeFiles(options, content, *ear, *loaded); !done) return done.error();
  printFound(content.found, *array);
  if (difference) print("{}\n", *difference);
  if (const auto stated = loaded->volume.provenance().side; stated && *stated != content.found.side)
    print("The images state a {} ear (Laterality), and this is a {} one: check the side.\n",
          anatomy::nameOf(*stated), anatomy::nameOf(content.found.side));
  for (const std::string& warning : loaded->series.warnings) print("{}\n", warning);
  return {};
}

#else

Result<void> ctContacts(const CtContactsOptions&)
{
  return Error{"This build has no VTK, so it cannot read a CT; use a build of the preset release."};
}

#endif

}  // namespace perilymph::cli
