// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes the SQLite file of a study with any bytes: read, shown as columns, reported.

#include "InputFile.h"

#include <stop_token>
#include "Seeds.h"
#include "perilymph/study/StudyColumns.h"
#include "perilymph/study/StudyReport.h"

namespace perilymph::fuzz {

namespace {

/// Every row of a file that is opened, as often as it is asked.
void use(const study::StudyFile& file)
{
  const study::StudyFileFacts& facts = file.facts();
  promise(facts.first <= facts.end && facts.end <= facts.cases && facts.cases <= study::maxCases,
          "a file is for cases of its study");
  promise((facts.seal == Seal::changed) == facts.fingerprint.empty() || facts.fingerprint.empty(),
          "a changed file has no number");
  std::size_t next = facts.first;
  const auto read = file.read([&](const study::StudyResult& result) -> Result<void> {
    promise(result.number == next++ && result.number < facts.end, "insertions are consecutive");
    return {};
  });
  if (!read) promise(!read.error().message.empty(), "a refusal has a sentence");
}

}  // namespace

std::vector<Bytes> seeds() { return corpusOf("study_file"); }

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  static fuzz::InputFile file("study.sqlite");
  const auto& place = file.holding({data, size});
  {
    const auto opened = study::StudyFile::open(place);
    if (opened)
      fuzz::use(*opened);
    else
      fuzz::promise(!opened.error().message.empty(), "a refusal has a sentence");
  }
  const auto columns = study::StudyColumns::read(place, {});
  if (columns) {
    for (const auto& quantity : columns->quantities())
      fuzz::promise(quantity.values.size() == columns->size(), "a column has every row");
    fuzz::promise(columns->rows({}).size() <= columns->size(), "a filter selects rows");
    fuzz::promise(!study::reportOf(*columns).text.empty(), "every study has a report");
  } else {
    fuzz::promise(!columns.error().message.empty(), "a refusal has a sentence");
  }
  fuzz::promise(file.strangers() == 0, "reading leaves nothing behind");
  return 0;
}
