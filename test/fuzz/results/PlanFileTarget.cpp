// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes a plan's file of draws with any bytes.

#include "InputFile.h"
#include "PlanFile.h"
#include "Seeds.h"

namespace perilymph::fuzz {

namespace {

void use(const session::InsertionTable& file)
{
  const auto read = planning::insertionsIn(file);
  if (!read) {
    promise(!read.error().message.empty(), "a refusal has a sentence");
    return;
  }
  if (read->empty()) return;
  const std::size_t arrays = read->back().array + 1;
  promise(read->size() % arrays == 0, "draws are whole");
  for (std::size_t i = 0; i < read->size(); ++i)
    promise((*read)[i].draw == 1 + i / arrays && (*read)[i].array == i % arrays,
            "insertions are in order");
}

}  // namespace

std::vector<Bytes> seeds() { return corpusOf("plan_file"); }

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  static fuzz::InputFile file("draws.sqlite");
  {
    const auto draws =
        session::InsertionTable::open(file.holding({data, size}), planning::planKind());
    if (draws)
      fuzz::use(*draws);
    else
      fuzz::promise(!draws.error().message.empty(), "a refusal has a sentence");
  }
  fuzz::promise(file.strangers() == 0, "reading leaves nothing behind");
  return 0;
}
