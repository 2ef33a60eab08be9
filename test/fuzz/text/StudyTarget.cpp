// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes the file of a study with any text, and asks for some of its cases.

#include <algorithm>

#include "Seeds.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/study/Study.h"
#include "perilymph/study/StudyRun.h"

namespace perilymph::fuzz {

namespace {

/// The cases of a cochlea are consecutive, and a case depends on its number alone.
void checkCase(const study::Study& study, std::size_t number)
{
  const study::StudyCase one = study.caseAt(number), again = study.caseAt(number);
  promise(one.number == number, "a case has its number");
  promise(one.cochlea == number / study.casesPerCochlea(), "cases of a cochlea are consecutive");
  promise(one.cochlea < study.cochleae().size(), "a cochlea of the study");
  promise(one.overrides == again.overrides, "a case depends on its number alone");
  const auto parameters = study.parametersOf(one);
  if (!parameters) {
    promise(!parameters.error().message.empty(), "a refusal has a sentence");
    return;
  }
  promise(parameters->stopTravel.si() > 0.0, "an array that moves");
  promise(!parameters->withdraws, "an insertion without withdrawal");
}

/// The shards have every case once, in order.
void checkShards(const study::Study& study, std::size_t count)
{
  std::size_t next = 0;
  for (std::size_t i = 1; i <= count; ++i) {
    const study::Shard shard = study::shardOf(study.size(), i, count);
    promise(shard.first == next && shard.end >= shard.first, "shards are consecutive");
    next = shard.end;
  }
  promise(next == study.size(), "shards have every case");
}

}  // namespace

std::vector<Bytes> seeds()
{
  std::vector<Bytes> texts;
  addFiles(resource("resources/studies"), ".toml", texts);
  addCorpus("study", texts);
  return texts;
}

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto study = study::parseStudy(text, "study.toml");
  if (!study) {
    fuzz::promise(!study.error().message.empty(), "a refusal has a sentence");
    return 0;
  }
  fuzz::promise(study->text() == text, "a study keeps its text");
  fuzz::promise(study->size() > 0 && study->size() <= study::maxCases,
                "a number of cases in range");
  for (const std::size_t part : {0u, 1u, 2u, 3u})
    fuzz::checkCase(*study, (study->size() - 1) * part / 3);
  fuzz::checkShards(*study, std::min<std::size_t>(study->size(), 7));
  return 0;
}
