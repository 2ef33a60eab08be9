// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/CochleaMeasures.h"

#include "perilymph/analysis/ClinicalEstimates.h"
#include "perilymph/analysis/ErrorBand.h"
#include "perilymph/analysis/ExpectedInsertion.h"

namespace perilymph::gui {

namespace {

using analysis::Measure;

std::vector<Measure> summaryOf(const anatomy::ScalaTympani& scala, const anatomy::Cochlea& cochlea,
                               const electrode::ArrayDesign& array)
{
  const auto [a, b] = analysis::basalDiameters(scala, cochlea);
  const bool isByLength = cochlea.source == anatomy::AnatomySource::published;
  const Measure duct =
      isByLength
          ? Measure{CochleaMeasures::ductLength, inMillimeters(analysis::organOfCortiLength(scala)),
                    Sentence{"path of the organ of Corti in the plan, round window to apex"},
                    Sentence{"measured in this model, defined as in Todd and Naghdy"}}
          : analysis::ductLength(CochleaMeasures::ductLength, a, b);
  std::vector<Measure> measures = {duct};
  for (Measure& each : analysis::expectedInsertion(scala, array))
    measures.push_back(std::move(each));
  return measures;
}

Result<CochleaMeasures> computed(const anatomy::Cochlea& cochlea,
                                 const electrode::ArrayDesign& array)
{
  const auto measuring = [&](const anatomy::ScalaTympani& scala, const anatomy::Cochlea& built) {
    return summaryOf(scala, built, array);
  };
  const auto scala = anatomy::buildAnatomy(cochlea, cochlea.patient.label);
  if (!scala) return scala.error();
  CochleaMeasures content;
  content.measures = measuring(**scala, cochlea);
  auto bands = analysis::errorBands(cochlea, content.measures, analysis::measuringError, measuring);
  if (!bands) return bands.error();
  content.bands = *std::move(bands);
  return content;
}

}  // namespace

std::string MeasureStore::keyOf(const anatomy::Cochlea& cochlea,
                                const electrode::ArrayDesign& array)
{
  std::string key = std::string(nameOf(cochlea.source)) + '\n' + array.name + '\n' +
                    std::to_string(inMillimeters(array.insertable));
  if (isScaledBy(cochlea.source, cochlea.patient))
    key += '\n' + anatomy::patientText(cochlea.patient);
  return key;
}

Result<CochleaMeasures> MeasureStore::of(const anatomy::Cochlea& cochlea,
                                         const electrode::ArrayDesign& array)
{
  const std::string key = keyOf(cochlea, array);
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = kept_.find(key); known != kept_.end()) return known->second;
  }
  // Without the lock: no thread waits for another's cochleae.
  auto found = computed(cochlea, array);
  if (!found) return found;
  const std::lock_guard lock(mutex_);
  if (kept_.size() == capacity) kept_.clear();
  kept_.emplace(key, *found);
  return found;
}

}  // namespace perilymph::gui
