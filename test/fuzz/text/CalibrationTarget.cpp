// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes the calibration of an array with any text.

#include "InputFile.h"
#include "Seeds.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/session/Calibration.h"

namespace perilymph::fuzz {

namespace {

void checkValue(const session::FittedValue& fitted)
{
  promise(fitted.low <= fitted.value && fitted.value <= fitted.high, "a value within its bounds");
}

}  // namespace

std::vector<Bytes> seeds()
{
  std::vector<Bytes> texts;
  addFiles(resource("resources/calibration"), ".toml", texts);
  addCorpus("calibration", texts);
  return texts;
}

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  static fuzz::InputFile file("calibration.toml");
  const auto calibration = session::loadCalibration(file.holding({data, size}));
  if (!calibration) {
    fuzz::promise(!calibration.error().message.empty(), "a refusal has a sentence");
    return 0;
  }
  fuzz::checkValue(calibration->stiffnessScale);
  fuzz::checkValue(calibration->residualCurvature);

  // An accepted calibration is unchanged after it was written and read.
  const std::string text = session::calibrationText(*calibration);
  const fuzz::Bytes bytes(text.begin(), text.end());
  const auto again = session::loadCalibration(file.holding(bytes));
  fuzz::promise(static_cast<bool>(again), "a written calibration can be read");
  fuzz::promise(session::calibrationText(*again) == text, "nothing changes by writing and reading");
  return 0;
}
