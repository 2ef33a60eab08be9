// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/anatomy/EarWords.h"
#include "perilymph/anatomy/Patient.h"

namespace perilymph::anatomy {

namespace {

constexpr Phrase changedMeasures{
    "The measures of %1 were changed by hand after the program wrote them. Do not use them as "
    "measured in a CT."};
constexpr Phrase unsealedMeasures{
    "The measures of %1 carry no seal: their file is of an earlier version or of another program."};

}  // namespace

Sentence noteOn(const Patient& patient)
{
  if (patient.seal == Seal::changed) return Sentence(changedMeasures, {patient.label});
  if (patient.seal == Seal::intact || patient.origin.software.empty()) return {};
  return Sentence(unsealedMeasures, {patient.label});
}

Sentence earOf(Side side)
{
  return side == Side::left ? Sentence{"left ear"} : Sentence{"right ear"};
}

Sentence storedNote(const std::string& text)
{
  static constexpr Phrase notes[] = {changedMeasures, unsealedMeasures};
  return recognized(text, notes);
}

}  // namespace perilymph::anatomy
