// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/study/StudyCaseRun.h"

#include <optional>
#include <stop_token>

#include "perilymph/foundation/InParallel.h"

namespace perilymph::study {

Result<Study> studyIn(const StudyFileFacts& facts, const std::filesystem::path& file)
{
  if (facts.seal == Seal::changed)
    return Error{
        "%1 was changed by hand after the program wrote it; its insertions are not run again. Use "
        "another copy of it.",
        file};
  auto study = parseStudy(facts.text, file);
  if (!study)
    return Error{"The study in %1 cannot be read again: %2 Put the files it names beside it.", file,
                 study.error().message};
  if (study->fingerprint() != facts.fingerprint)
    return Error{
        "The study in %1 names files that differ from those it was run with. Put those beside it.",
        file};
  return study;
}

Result<StudyResult> recordCase(const Study& study, std::size_t number,
                               const std::filesystem::path& recording, const std::stop_token& stop)
{
  if (number >= study.size())
    return Error{"Insertion %1 is not in the study, which has %2 of them, counted from 0.", number,
                 study.size()};
  const StudyCase one = study.caseAt(number);
  const auto scenario = study.scenarioOf(one);
  if (!scenario) return scenario.error();
  const auto anatomy = session::buildAnatomy(*scenario);
  if (!anatomy) return anatomy.error();
  // in a thread that may compute whole insertions, whatever the caller's is
  std::optional<Result<analysis::InsertionRun>> ran;
  const auto done = doInParallel(
      1, 1,
      [&](std::size_t, const std::stop_token& ending) -> Result<void> {
        ran = analysis::runInsertion(*scenario, *anatomy, recording, ending);
        return *ran ? Result<void>() : Result<void>(ran->error());
      },
      {}, stop);
  if (!done) return done.error();
  StudyResult result;
  result.number = number;
  result.cochlea = study.cochleae()[one.cochlea].name;
  result.settings = one.overrides;
  result.insertion = **std::move(ran);
  return result;
}

}  // namespace perilymph::study
