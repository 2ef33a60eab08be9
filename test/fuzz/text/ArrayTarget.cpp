// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes the electrode array with any text and inserts the array into a wide tube.

#include <cmath>
#include <stdexcept>

#include "InputFile.h"
#include "Seeds.h"
#include "lumen/PlainLumens.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "perilymph/mechanics/advance.h"

namespace perilymph::fuzz {

namespace {

void checkSections(const electrode::ArrayDesign& array)
{
  promise(array.insertable <= array.length, "no deeper than it is long");
  promise(array.tipRadius().si() > 0.0, "a tip has a radius");
  for (int i = 0; i <= 40; ++i) {
    const Length place = (i / 40.0) * array.length;
    const electrode::Section section = array.sectionAt(place);
    promise(section.across.si() > 0.0 && section.across <= millimeters(2.0), "a width in range");
    promise(section.within.si() > 0.0 && section.within <= millimeters(2.0),
            "a thickness in range");
    promise(array.bending.at(place).si() > 0.0, "an array resists bending");
    promise(array.bendingAcrossAt(place).si() > 0.0, "an array resists bending across");
    promise(array.twistingAt(place).si() > 0.0, "an array resists twisting");
    promise(std::isfinite(array.restCurvature.at(place).si()), "a finite curvature");
  }
}

/// Its model is built or refused with a message, and its first ticks are finite.
void push(const electrode::ArrayDesign& array)
{
  mechanics::ModelParts parts;
  parts.lumen = std::make_shared<anatomy::StraightTube>(20e-3);
  parts.array = array;
  parts.nodes = 16;
  std::shared_ptr<const mechanics::InsertionModel> model;
  try {
    model = mechanics::InsertionModel::build(std::move(parts));
  } catch (const std::invalid_argument& refusal) {
    promise(*refusal.what() != '\0', "a refusal has a sentence");
    return;
  }
  mechanics::InsertionState state(*model);
  mechanics::Drive drive;
  drive.handPosition_W = model->startBase_W;
  drive.handAxis_W = model->startAxis_W;
  drive.handCurl_W = model->startCurl_W;
  drive.coupling = mechanics::Coupling::rigid;
  drive.handVelocity_W = 2e-3 * model->startAxis_W;
  for (int i = 0; i < 3; ++i) {
    drive.handPosition_W += model->timeStep * drive.handVelocity_W;
    mechanics::advance(*model, state, drive);
    promise(state.readings.isFinite, "a finite state");
  }
}

}  // namespace

std::vector<Bytes> seeds()
{
  std::vector<Bytes> texts;
  addFiles(resource("plugins/electrodes"), ".toml", texts);
  addCorpus("array", texts);
  return texts;
}

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  static fuzz::InputFile file("array.toml");
  const auto array = electrode::loadArray(file.holding({data, size}));
  if (!array) {
    fuzz::promise(!array.error().message.empty(), "a refusal has a sentence");
    return 0;
  }
  fuzz::checkSections(*array);
  fuzz::push(*array);
  return 0;
}
