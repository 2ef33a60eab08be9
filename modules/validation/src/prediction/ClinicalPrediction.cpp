// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/validation/ClinicalPrediction.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <stop_token>
#include <utility>

#include "perilymph/analysis/ArrayTaper.h"
#include "perilymph/analysis/InsertionByHand.h"
#include "perilymph/analysis/PackingRange.h"
#include "perilymph/analysis/RunProgress.h"
#include "perilymph/electrode/WirePacking.h"
#include "perilymph/foundation/InParallel.h"
#include "prediction/PhantomRows.h"
#include "prediction/VirtualInsertion.h"

namespace perilymph::validation {

namespace {

constexpr Length startInside = millimeters(1);
/// A period of the tremor is 123 ms; see the convergence in the page of mechanics (choice, high).
constexpr Duration timeStep = milliseconds(1);

std::vector<std::string> arraysOf(const ClinicalRequest& request)
{
  if (!request.arrays.empty()) return request.arrays;
  return {std::begin(clinicalArrays), std::end(clinicalArrays)};
}

}  // namespace

std::size_t insertionsOf(const ClinicalRequest& request)
{
  return request.seeds.size() * static_cast<std::size_t>(request.patients) *
             arraysOf(request).size() +
         (request.arrays.empty() ? phantomInsertions : 0);
}

Result<ClinicalResult> predictClinic(const ClinicalRequest& request,
                                     const analysis::RunProgress& progress,
                                     const std::stop_token& stop)
{
  const auto hand = analysis::shippedHand();
  if (!hand) return hand.error();
  for (auto each = request.seeds.begin(); each != request.seeds.end(); ++each)
    if (std::find(request.seeds.begin(), each, *each) != each)
      return Error{"Seed %1 is given twice: its cochleae would count double. Give it once.", *each};
  const auto packing = analysis::shippedPackingRange();
  if (!packing) return packing.error();
  const std::vector<std::string> names = arraysOf(request);
  const std::size_t arrays = names.size();
  std::vector<session::InsertionParameters> nominal;
  for (const std::string& array : names) {
    auto scenario = fullInsertionOf("surgery-flex28", array, startInside, timeStep,
                                    {{"friction", request.friction}});
    if (!scenario) return scenario.error();
    nominal.push_back(scenario->parameters());
  }

  // One piece per cochlea, and the phantom as the last, unless arrays are named.
  const auto patients = static_cast<std::size_t>(request.patients);
  const std::size_t cochleae = request.seeds.size() * patients;
  ClinicalResult result;
  result.insertions.resize(cochleae * arrays);
  std::vector<ClinicalRow> phantom;
  const auto work = [&](std::size_t piece, const std::stop_token& ending) -> Result<void> {
    if (piece == cochleae) {
      auto rows = phantomRows(ending);
      if (!rows) return rows.error();
      phantom = *std::move(rows);
      return {};
    }
    const std::uint64_t seed = request.seeds[piece / patients];
    const std::uint64_t patient = piece % patients + 1;
    const analysis::Surgeon surgeon =
        analysis::drawSurgeon(*hand, seed, patient, nominal.front().frictionSpread);
    std::shared_ptr<const anatomy::ScalaTympani> anatomy;
    for (std::size_t i = 0; i < arrays && !ending.stop_requested(); ++i) {
      auto parameters = withCochlea(nominal[i], seed, patient);
      if (!parameters) return parameters.error();
      parameters->array = electrode::withTaper(
          electrode::withWirePacking(std::move(parameters->array),
                                     analysis::drawPacking(*packing, seed, patient)),
          analysis::drawTaper(seed, patient));
      if (!anatomy) {
        auto built = session::buildAnatomy(*parameters);
        if (!built) return built.error();
        anatomy = *built;
      }
      analysis::ClinicalInsertion& place = result.insertions[piece * arrays + i];
      place = analysis::insertByHand(*parameters, anatomy, *hand, surgeon, Length{}, ending);
      place.array = names[i];
      place.seed = seed;
      place.patient = patient;
    }
    return {};
  };
  const std::size_t all = insertionsOf(request);
  const auto done = doInParallel(
      cochleae + (request.arrays.empty() ? 1 : 0), request.jobs, work,
      [&](std::size_t count) {
        if (progress) progress(count > cochleae ? all : count * arrays, all);
      },
      stop);
  if (!done) return done.error();

  auto rows = clinicalRows(result.insertions);
  if (!rows) return rows.error();
  result.rows = *std::move(rows);
  result.rows.insert(result.rows.end(), phantom.begin(), phantom.end());
  auto perfect = perfectModel(result.insertions);
  if (!perfect) return perfect.error();
  result.perfect = *std::move(perfect);
  return result;
}

}  // namespace perilymph::validation
