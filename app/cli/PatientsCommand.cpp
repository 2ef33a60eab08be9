// SPDX-License-Identifier: BSD-3-Clause
#include <stop_token>
#include <string>

#include "Commands.h"
#include "Interruption.h"
#include "OutputFolder.h"
#include "Terminal.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/planning/PatientRegistry.h"
#include "perilymph/session/SavedPatients.h"

namespace perilymph::cli {

namespace {

std::string measuresText(const anatomy::Patient& patient)
{
  const auto text = [](Length length) { return fixed(inMillimeters(length), 2); };
  if (const auto& turn = patient.basalTurn)
    return "A " + text(turn->a) + ", B " + text(turn->b) +
           (turn->h ? ", H " + text(*turn->h) : std::string()) + " mm";
  return "scala " + text(patient.scalaTympaniLength) + " mm, section " +
         text(patient.roundWindowWidth) + " x " + text(patient.roundWindowHeight) + " mm";
}

void printNotes(const std::vector<Sentence>& notes)
{
  for (const Sentence& note : notes) printError("{}\n", note);
}

void listPatients()
{
  const session::SavedPatients read = session::readPatients(patientFolder());
  printNotes(read.unreadable);
  print("{} patients in {}\n", read.patients.size(), patientFolder());
  for (const session::SavedPatient& each : read.patients)
    print("{}, {} ear: {}{}\n", each.patient.label, anatomy::nameOf(each.patient.side),
          measuresText(each.patient), each.record.isArchived ? ", archived" : "");
}

Result<void> writeRegistry(const std::string& file)
{
  const std::stop_token stop = watchForInterruption();
  const auto registry = planning::patientRegistry(
      planning::ownRegistryFolders(),
      [](std::size_t done, std::size_t all) { showProgress("patient", done, all); }, stop);
  if (isInterrupted()) return Error{"Interrupted; nothing was written."};
  if (!registry) return registry.error();
  printNotes(registry->notes);
  if (const auto written = writeWhole(file, registry->csv, {Links::followed, Audience::owner});
      !written)
    return written;
  print("{} patients in {}\n", registry->patients, file);
  return {};
}

}  // namespace

Result<void> patients(const PatientsOptions& options)
{
  if (options.registry.empty() && options.dictionary.empty()) listPatients();
  if (!options.registry.empty())
    if (const auto written = writeRegistry(options.registry); !written) return written;
  if (options.dictionary.empty()) return {};
  return writeWhole(options.dictionary, planning::registryDictionaryCsv());
}

}  // namespace perilymph::cli
