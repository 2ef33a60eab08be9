// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes the patient file with any text.

#include <cmath>

#include "InputFile.h"
#include "Seeds.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::fuzz {

namespace {

bool isNear(Length one, Length other) { return std::fabs(one.si() - other.si()) < 2e-12; }

/// An accepted patient is within the limits, and unchanged after it was written and read.
void checkPatient(const anatomy::Patient& patient, InputFile& file)
{
  promise(static_cast<bool>(anatomy::checkPatient(patient)),
          "an accepted patient is within limits");
  anatomy::unusualMeasures(patient);
  const auto copy = file.folder() / "copy.toml";
  promise(static_cast<bool>(anatomy::savePatient(patient, copy)), "a patient can be kept");
  const auto again = anatomy::loadPatient(copy);
  promise(static_cast<bool>(again), "a kept patient can be read");
  promise(again->side == patient.side, "the side is kept");
  promise(again->basalTurn.has_value() == patient.basalTurn.has_value(), "the kind is kept");
  if (patient.basalTurn) {
    promise(isNear(again->basalTurn->a, patient.basalTurn->a), "A is kept");
    promise(isNear(again->basalTurn->b, patient.basalTurn->b), "B is kept");
    return;
  }
  promise(isNear(again->scalaTympaniLength, patient.scalaTympaniLength), "the length is kept");
  promise(isNear(again->roundWindowWidth, patient.roundWindowWidth), "the width is kept");
  promise(isNear(again->roundWindowHeight, patient.roundWindowHeight), "the height is kept");
}

}  // namespace

std::vector<Bytes> seeds()
{
  std::vector<Bytes> texts;
  addFiles(resource("resources/patients"), ".toml", texts);
  addCorpus("patient", texts);
  return texts;
}

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  static fuzz::InputFile file("patient.toml");
  const auto patient = anatomy::loadPatient(file.holding({data, size}));
  if (patient)
    fuzz::checkPatient(*patient, file);
  else
    fuzz::promise(!patient.error().message.empty(), "a refusal has a sentence");
  return 0;
}
