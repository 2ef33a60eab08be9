// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <sstream>
#include <stop_token>
#include <string>

#include "CommandFiles.h"
#include "Commands.h"
#include "Interruption.h"
#include "OutputFolder.h"
#include "Terminal.h"
#include "perilymph/figures/Figure.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/outcome/ClinicLibrary.h"
#include "perilymph/outcome/ClinicOutcomes.h"
#include "perilymph/planning/PatientRegistry.h"
#include "perilymph/planning/ResistanceGrid.h"

namespace perilymph::cli {

namespace {

/// The folders of a library: `patients` and `plans` in it, else the user's own.
planning::RegistryFolders foldersOf(const std::string& library)
{
  if (library.empty()) return planning::ownRegistryFolders();
  const std::filesystem::path folder(library);
  return {folder / "patients", folder / "plans", folder / "sessions"};
}

}  // namespace

Result<void> outcomes(const OutcomesOptions& options, const CommandFiles& files)
{
  const planning::RegistryFolders folders = foldersOf(options.library);
  if (!options.library.empty() && !std::filesystem::is_directory(folders.patients))
    return Error{options.library +
                 " has no folder 'patients'. Give --library the folder that has it."};
  if (!options.library.empty() && !std::filesystem::is_directory(folders.plans))
    printError(
        "{} has no folder 'plans', so that no outcome has a prediction there. The user's own plans "
        "are "
        "in {}.\n",
        options.library, planning::ownRegistryFolders().plans.string());
  if (const auto done = checkFolder(options.out); !done) return done.error();
  const std::stop_token stop = watchForInterruption();
  const auto library = outcome::readOutcomes(
      folders, [](std::size_t done, std::size_t all) { showProgress("simulation", done, all); },
      stop);
  if (isInterrupted())
    return Error{"Interrupted; what was computed is kept. The same command continues."};
  if (!library) return library.error();
  for (const Sentence& note : library->notes) printError("{}\n", note);
  const auto clinic = outcome::compareOutcomes(library->outcomes, library->leftOut);
  if (!clinic) return clinic.error();
  if (!options.resistance.empty() && !(clinic->resistance.isOffered() && clinic->friction))
    return Error{"The clinic's resistance is not offered, and " + options.resistance +
                 " was not written: " + outcome::resistanceSentence(*clinic)};
  FolderContent content;
  content.texts = {{"outcomes.json", outcome::outcomesJson(*clinic)},
                   {"outcomes.csv", outcome::outcomesCsv(*clinic)},
                   {"outcomes-dictionary.csv", outcome::outcomesDictionaryCsv()},
                   {"outcomes.md", outcome::outcomesText(*clinic)}};
  for (const auto& [name, figure] : outcome::outcomesFigures(*clinic))
    content.figures.emplace_back(name, figures::draw(figure));
  if (const auto done = writeFolder(files, options.out, content); !done) return done.error();
  if (!options.resistance.empty()) {
    const auto written =
        writeWhole(options.resistance,
                   planning::clinicResistanceText(clinic->resistance.resistance(*clinic->friction)),
                   {Links::followed, Audience::owner});
    if (!written) return written;
    print("{}\n", options.resistance);
  }
  std::istringstream lines(outcome::outcomesText(*clinic));
  for (std::string line; std::getline(lines, line);) print("{}\n", line);
  return {};
}

}  // namespace perilymph::cli
