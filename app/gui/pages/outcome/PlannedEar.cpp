// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/outcome/PlannedEar.h"

#include <algorithm>
#include <utility>

#include "gui/setup/Catalog.h"
#include "gui/setup/PlanStore.h"
#include "perilymph/analysis/Comparison.h"
#include "perilymph/outcome/ClinicLibrary.h"
#include "perilymph/planning/Plan.h"
#include "perilymph/planning/PlanFolder.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

namespace {

bool isOf(const session::SessionSummary& session, const anatomy::Patient& patient)
{
  return session.patient == patient.label && session.side == anatomy::nameOf(patient.side) &&
         session::isInsertion(session);
}

/// The newest plan of an array that has its number, or any; of those made before surgery if a day is given.
void addPlan(PlannedEar& ear, const std::vector<StoredPlan>& plans, const anatomy::Patient& patient,
             const std::string& number, const std::string& surgeryDay)
{
  for (const StoredPlan& each : plans) {
    const auto& arrays = each.request.arrays;
    if (each.shownDraws == 0 || each.request.patient.label != patient.label ||
        each.request.patient.side != patient.side ||
        std::ranges::find(arrays, ear.array) == arrays.end() ||
        !(surgeryDay.empty() || outcome::isPrediction(each.madeUtc, surgeryDay)))
      continue;
    auto read = planning::readPlan(each.folder / planJsonFile);
    if (!read || (!number.empty() && read->plan.fingerprint != number)) continue;
    const auto place = std::ranges::find(read->plan.arrays, ear.array, &planning::ArrayPlan::array);
    if (place == read->plan.arrays.end()) continue;
    ear.place = std::size_t(place - read->plan.arrays.begin());
    ear.planMadeUtc = each.madeUtc;
    read->plan.request = each.request;
    planning::PlanRequest request = each.request;
    request.draws = each.shownDraws;
    const auto inRequest = std::size_t(std::ranges::find(arrays, ear.array) - arrays.begin());
    if (const auto viewed = planning::viewPlan(request, each.folder / planning::planDrawsFile))
      ear.ends = outcome::endsOf(*viewed, inRequest);
    ear.plan = std::make_shared<const planning::StoredPlan>(*std::move(read));
    return;
  }
}

/// The shipped name of a recording's array: its list has the title, or that name where its scenario cannot be read.
/// Empty if it is in no catalog.
std::string arrayOf(const session::SessionSummary& session,
                    const std::vector<CatalogArray>& catalog)
{
  for (const CatalogArray& each : catalog)
    if (each.title.toStdString() == session.array || each.name.toStdString() == session.array)
      return each.name.toStdString();
  return {};
}

/// The array that was inserted or planned last.
std::string newestArray(const std::vector<session::SessionSummary>& sessions,
                        const std::vector<StoredPlan>& plans, const anatomy::Patient& patient,
                        const std::vector<CatalogArray>& catalog)
{
  std::string array, utc;
  for (const session::SessionSummary& each : sessions)
    if (isOf(each, patient) && each.startedUtc > utc)
      if (const std::string own = arrayOf(each, catalog); !own.empty())
        utc = each.startedUtc, array = own;
  if (!array.empty()) return array;
  for (const StoredPlan& each : plans)
    if (each.request.patient.label == patient.label && each.request.patient.side == patient.side &&
        !each.request.arrays.empty())
      return each.request.arrays.front();
  return {};
}

}  // namespace

Result<PlannedEar> plannedEar(const anatomy::Patient& patient, const std::string& array,
                              const std::string& plan, const std::string& surgeryDay,
                              const std::filesystem::path& beingRecorded,
                              const std::stop_token& stop)
{
  const PatientWork work = readPatientWork(beingRecorded, stop);
  const std::vector<CatalogArray> catalog = catalogArrays();
  PlannedEar ear;
  ear.array = array.empty() ? newestArray(work.sessions, work.plans, patient, catalog) : array;
  addPlan(ear, work.plans, patient, plan, surgeryDay);
  if (!ear.plan && !surgeryDay.empty()) addPlan(ear, work.plans, patient, plan, {});
  const session::SessionSummary* newest = nullptr;
  for (const session::SessionSummary& each : work.sessions)
    if (isOf(each, patient) && arrayOf(each, catalog) == ear.array &&
        (newest == nullptr || each.startedUtc > newest->startedUtc))
      newest = &each;
  if (newest != nullptr)
    if (auto read = analysis::readCompared(newest->file, stop)) ear.insertion = *std::move(read);
  const auto scenario = session::loadScenario(planning::PlanRequest{}.scenario);
  if (!scenario) return scenario.error();
  anatomy::Cochlea cochlea = scenario->parameters().cochlea;
  cochlea.source = anatomy::AnatomySource::mean;
  cochlea.patient = patient;
  auto built = anatomy::buildAnatomy(cochlea, patient.label);
  if (!built) return built.error();
  ear.scala = *std::move(built);
  return ear;
}

}  // namespace perilymph::gui
