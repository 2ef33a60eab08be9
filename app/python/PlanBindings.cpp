// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include <algorithm>
#include <limits>
#include <stop_token>

#include "Bindings.h"
#include "NumberArrays.h"
#include "ObjectText.h"
#include "perilymph/figures/Strings.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/planning/Plan.h"
#include "perilymph/planning/PlanReading.h"
#include "perilymph/planning/PlanReport.h"
#include "perilymph/planning/PlanWords.h"
#include "perilymph/planning/ResistanceGrid.h"

namespace perilymph::python {

namespace {

using planning::ArrayPlan;
using planning::Band;
using planning::StoredPlan;

/// A plan as Python sees it. Its plan.json and its insertions are what it is compared and pickled by.
struct Plan {
  StoredPlan stored;
  py::dict insertions;
  anatomy::Patient patient;  ///< To all digits, where it is known.
};

/// One array of a plan.
struct PlannedArray {
  std::shared_ptr<Plan> plan;
  std::size_t index = 0;

  const ArrayPlan& operator*() const { return plan->stored.plan.arrays[index]; }
};

constexpr unsigned maxJobs = 256;

/// Quantiles of bands, a row each: shape (n, 5).
template <class Row>
py::array bandsOf(const std::vector<Row>& rows, Band Row::*band)
{
  std::vector<double> values;
  values.reserve(5 * rows.size());
  for (const Row& row : rows) {
    const Band& each = row.*band;
    values.insert(values.end(),
                  {each.low, each.lowerQuartile, each.median, each.upperQuartile, each.high});
  }
  return arrayOf(std::move(values), {static_cast<py::ssize_t>(rows.size()), 5});
}

py::array bandOf(const Band& band)
{
  return arrayOf(std::vector<double>{band.low, band.lowerQuartile, band.median, band.upperQuartile,
                                     band.high});
}

template <class Row, class Value>
py::array columnOf(const std::vector<Row>& rows, const Value& value)
{
  std::vector<double> values;
  values.reserve(rows.size());
  for (const Row& row : rows) values.push_back(value(row));
  return arrayOf(std::move(values));
}

py::dict bands(const ArrayPlan& plan)
{
  py::dict found;
  for (const planning::PlanQuantity& each : planning::planQuantities())
    found[each.key] = bandOf(plan.*each.band);
  return found;
}

py::dict probabilities(const ArrayPlan& plan)
{
  py::dict found = dictOfRenamed();
  for (const planning::PlanProbability& each : planning::planProbabilities()) {
    const analysis::Estimate& estimate = plan.*each.estimate;
    found[each.key] = arrayOf(std::vector<double>{estimate.value, estimate.low, estimate.high});
  }
  return found;
}

py::dict atMedianFriction(const ArrayPlan& plan)
{
  py::dict found;
  if (plan.atMedianFriction)
    for (const planning::FrictionQuantity& each : planning::frictionQuantities)
      found[each.key] = bandOf(*plan.atMedianFriction.*each.band);
  return found;
}

py::dict inClinic(const Plan& plan, const ArrayPlan& array)
{
  py::dict found;
  if (!plan.stored.plan.clinic) return found;
  if (!array.inClinic)
    throw EngineError("With the clinic's resistance the " + std::to_string(array.draws) +
                      " simulations of " + array.name + " amount to fewer than " +
                      figures::fixed(planning::fewestEffective, 0) +
                      ", and no depth is given. Plan with more 'samples', " +
                      std::to_string(planning::maxDraws) + " at most.");
  found["depth_mm"] = bandOf(array.inClinic->depth_mm);
  found["effective_simulations"] = array.inClinic->effective;
  return found;
}

py::dict differences(const StoredPlan& stored)
{
  using Row = planning::ArrayDifference;
  const std::vector<Row>& rows = stored.plan.differences;
  const auto names = [&](std::size_t Row::*array) {
    std::vector<std::string> found;
    for (const Row& row : rows) found.push_back(stored.plan.arrays[row.*array].array);
    return found;
  };
  py::dict found;
  found["first"] = arrayOf(names(&Row::first));
  found["second"] = arrayOf(names(&Row::second));
  found["draws"] = columnOf(rows, [](const Row& row) { return static_cast<double>(row.draws); });
  for (const planning::DifferenceQuantity& each : planning::differenceQuantities)
    found[each.key] = bandsOf(rows, each.band);
  for (const planning::DifferenceProbability& each : planning::differenceProbabilities) {
    std::vector<double> values;
    for (const Row& row : rows) {
      const analysis::Estimate& estimate = row.*each.estimate;
      values.insert(values.end(), {estimate.value, estimate.low, estimate.high});
    }
    found[each.key] = arrayOf(std::move(values), {static_cast<py::ssize_t>(rows.size()), 3});
  }
  return found;
}

py::dict force(const ArrayPlan& plan)
{
  using Row = planning::ForceBand;
  py::dict found;
  found["depth_mm"] = columnOf(plan.force, [](const Row& row) { return row.depth_mm; });
  found["draws"] =
      columnOf(plan.force, [](const Row& row) { return static_cast<double>(row.draws); });
  found["force_mN"] = bandsOf(plan.force, &Row::force_mN);
  return found;
}

py::dict contacts(const ArrayPlan& plan)
{
  using Row = planning::ContactBand;
  py::dict found;
  found["number"] = columnOf(plan.contacts, [](const Row& row) { return double(row.number); });
  found["draws"] =
      columnOf(plan.contacts, [](const Row& row) { return static_cast<double>(row.draws); });
  found["angle_deg"] = bandsOf(plan.contacts, &Row::angle_deg);
  found["to_modiolus_mm"] = bandsOf(plan.contacts, &Row::toModiolus_mm);
  found["greenwood_Hz"] = columnOf(plan.contacts, [](const Row& row) { return row.greenwood_Hz; });
  found["spiral_ganglion_Hz"] =
      columnOf(plan.contacts, [](const Row& row) { return row.spiralGanglion_Hz; });
  found["filter_Hz"] = columnOf(plan.contacts, [](const Row& row) { return row.filter_Hz; });
  found["mismatch_semitones"] = bandsOf(plan.contacts, &Row::mismatch_semitones);
  return found;
}

py::dict influence(const ArrayPlan& plan)
{
  using Row = planning::Influence;
  std::vector<std::string> inputs;
  for (const Row& row : plan.influences) inputs.push_back(row.input);
  py::dict found;
  found["input"] = arrayOf(inputs);
  found["on_angle"] = columnOf(plan.influences, [](const Row& row) { return row.onAngle; });
  found["on_peak_force"] = columnOf(plan.influences, [](const Row& row) { return row.onPeak; });
  found["angle_width_if_known_deg"] =
      columnOf(plan.influences, [](const Row& row) { return row.angleWidth_deg; });
  found["peak_width_if_known_mN"] =
      columnOf(plan.influences, [](const Row& row) { return row.peakWidth_mN; });
  return found;
}

py::dict insertions(const planning::Plan& plan)
{
  using Row = planning::PlannedInsertion;
  const std::vector<Row>& rows = plan.insertions;
  py::dict found;
  if (rows.empty()) return found;
  std::vector<std::string> arrays, ends;
  for (const Row& row : rows) {
    arrays.push_back(plan.request.arrays[row.array]);
    ends.push_back(haptics::nameOf(row.insertion.end));
  }
  const auto add = [&](const char* name, const auto& value) {
    found[name] = columnOf(rows, value);
  };
  add("draw", [](const Row& row) { return static_cast<double>(row.draw); });
  found["array"] = arrayOf(arrays);
  add("A_mm", [](const Row& row) { return row.a_mm; });
  add("B_mm", [](const Row& row) { return row.b_mm; });
  add("tilt_deg", [](const Row& row) { return row.tilt_deg; });
  add("turn_deg", [](const Row& row) { return row.turn_deg; });
  add("stiffness", [](const Row& row) { return row.stiffness; });
  add("packing", [](const Row& row) { return row.packing; });
  add("last_contact_mm", [](const Row& row) { return row.lastContact_mm; });
  add("friction", [](const Row& row) { return row.friction; });
  add("speed_mm_s", [](const Row& row) { return row.speed_mm_s; });
  add("stop_mN", [](const Row& row) { return row.stop_mN; });
  add("intended_mm", [](const Row& row) { return row.intended_mm; });
  add("free_mm", [](const Row& row) { return row.free_mm; });
  found["end"] = arrayOf(ends);
  add("depth_mm", [](const Row& row) { return inMillimeters(row.insertion.depth); });
  add("angle_deg", [](const Row& row) { return inDegrees(row.insertion.apical); });
  add("peak_mN", [](const Row& row) { return inMillinewtons(row.insertion.peak); });
  add("partition_mN", [](const Row& row) { return inMillinewtons(row.insertion.partition); });
  add("end_mN", [](const Row& row) { return inMillinewtons(row.insertion.endForce); });
  const auto atRest = [](const std::optional<Force>& force) {
    return force ? inMillinewtons(*force) : std::numeric_limits<double>::quiet_NaN();
  };
  add("force_after_1s_mN", [&](const Row& row) { return atRest(row.insertion.forceAfter1s); });
  add("force_after_10s_mN", [&](const Row& row) { return atRest(row.insertion.forceAfter10s); });
  return found;
}

planning::PlanRequest requestOf(const py::object& patient, const py::object& arrays,
                                const std::optional<long>& samples, bool allSamples, long seed,
                                long jobs, const py::object& scenario, const py::object& friction,
                                const py::object& clinicResistance)
{
  planning::PlanRequest request;
  request.patient = patientOf(patient);
  if (arrays.is_none())
    request.arrays = shippedNames("plugins/electrodes");
  else if (py::isinstance<py::str>(arrays))
    throw py::type_error("arrays must be a list of names, paths or Array objects");
  else
    for (const py::handle each : py::iter(arrays))
      request.arrays.push_back(arrayNameOf(py::reinterpret_borrow<py::object>(each), "arrays"));
  if (request.arrays.size() > planning::maxStoredArrays)
    throw EngineError(std::to_string(request.arrays.size()) +
                      " arrays are too many; a plan compares " +
                      std::to_string(planning::maxStoredArrays) + " at most. Name fewer.");
  const auto whole = [](long value, const char* name, double high) {
    return numberOf(static_cast<double>(value), name, "(whole numbers)", 0.0, high);
  };
  if (!clinicResistance.is_none())
    request.clinicResistance = nameOrFileOf(clinicResistance, "clinic_resistance");
  request.draws = samples ? static_cast<std::size_t>(std::max(*samples, 0L))
                          : planning::usualDraws(request.clinicResistance.has_value());
  valueOf(planning::checkDraws(request.draws));
  whole(jobs, "jobs", maxJobs);
  whole(seed, "seed", 9e15);
  request.stopsEarly = !allSamples;
  request.seed = static_cast<std::uint64_t>(seed);
  request.jobs = static_cast<unsigned>(jobs);
  request.scenario = scenarioNameOf(scenario);
  if (!friction.is_none()) request.friction = frictionNameOf(friction);
  return request;
}

std::shared_ptr<Plan> plan(const py::object& patient, const py::object& arrays,
                           const std::optional<long>& samples, bool allSamples, long seed,
                           long jobs, const py::object& scenario, const py::object& friction,
                           const py::object& clinicResistance, const py::object& draws,
                           const py::object& progress)
{
  const planning::PlanRequest request = requestOf(patient, arrays, samples, allSamples, seed, jobs,
                                                  scenario, friction, clinicResistance);
  std::filesystem::path file;
  if (!draws.is_none()) file = nameOrFileOf(draws, "draws_file");
  PendingException pending;
  std::stop_source stop;
  const auto report = [&](std::size_t done, std::size_t all) {
    const bool isRaised = pending.isRaisedBy([&] {
      if (!progress.is_none()) progress(done, all);
    });
    if (isRaised) stop.request_stop();
  };
  const auto made =
      withoutLock([&] { return planning::makePlan(request, file, report, stop.get_token()); });
  pending.raise();
  planning::Plan whole = valueOf(made);
  // To the digits of a plan.json, with its sources and limits; and the insertions, which it lacks.
  StoredPlan stored = valueOf(withoutLock([&]() -> Result<StoredPlan> {
    const auto json = planning::planJson(whole);
    if (!json) return json.error();
    return planning::planIn(*json, "plan");
  }));
  return std::make_shared<Plan>(Plan{std::move(stored), insertions(whole), whole.request.patient});
}

std::shared_ptr<Plan> readPlan(const py::object& given)
{
  const std::string place = nameOrFileOf(given, "path");
  StoredPlan stored = valueOf(withoutLock([&] { return planning::readPlan(place); }));
  anatomy::Patient patient = stored.plan.request.patient;
  return std::make_shared<Plan>(Plan{std::move(stored), {}, std::move(patient)});
}

py::tuple planState(const Plan& one)
{
  return py::make_tuple(py::bytes(one.stored.text), one.insertions, one.patient);
}

std::string identityOf(const Plan& one) { return std::string(bytesOf(planState(one))); }

/// "angular insertion depth 512 deg (404 to 583)" and more of an array.
std::vector<std::pair<std::string, std::string>> figuresOf(const ArrayPlan& array)
{
  const auto text = [](const Band& band, int digits, const char* unit) {
    return figures::fixed(band.median, digits) + unit + " (" + figures::fixed(band.low, digits) +
           " to " + figures::fixed(band.high, digits) + ")";
  };
  return {{"angular insertion depth", text(array.angle_deg, 0, " deg")},
          {"depth", text(array.depth_mm, 1, " mm")},
          {"peak insertion force", text(array.peak_mN, 0, " mN")}};
}

py::str htmlOf(const Plan& one)
{
  std::vector<std::pair<std::string, std::string>> rows{
      {"bands", planning::bandsHold(one.stored.plan)}};
  for (const ArrayPlan& array : one.stored.plan.arrays)
    for (const auto& [name, value] : figuresOf(array))
      rows.emplace_back(array.name + ", " + name, value);
  return htmlTable("Plan for '" + one.stored.plan.request.patient.label + "'", rows);
}

}  // namespace

void definePlan(py::module_& module)
{
  py::class_<PlannedArray> planned(
      module, "PlannedArray",
      "One array over all draws of a plan. A band is the quantiles 5, 25, 50, 75 "
      "and 95 %, shape (5,); of n rows, shape (n, 5).");
  planned
      .def_property_readonly(
          "array", [](const PlannedArray& one) { return textOf((*one).array); },
          "As it was asked for.")
      .def_property_readonly(
          "name", [](const PlannedArray& one) { return textOf((*one).name); }, "\"FLEX28\".")
      .def_property_readonly(
          "draws", [](const PlannedArray& one) { return (*one).draws; }, "Number of draws.")
      .def(
          "bands", [](const PlannedArray& one) { return bands(*one); },
          "Bands by name: 'angle_deg', 'coverage_percent', 'depth_mm', 'peak_mN', 'end_mN', "
          "'partition_mN', 'first_resistance_mm', 'force_after_1s_mN', 'force_after_10s_mN' (of "
          "rest; "
          "zeros if not computed); each of shape (5,). 'end_mN' is the mean of the last half "
          "second before "
          "the hand stops. What a band holds: Plan.bands_hold.")
      .def(
          "probabilities", [](const PlannedArray& one) { return probabilities(*one); },
          "Probabilities by name, each (value, low, high) with its 95 % interval: "
          "'intended_depth_reached', 'stopped_by_resistance', 'buckled', ...")
      .def(
          "at_median_friction", [](const PlannedArray& one) { return atMedianFriction(*one); },
          "Bands 'angle_deg', 'depth_mm', 'peak_mN' and 'end_mN', each of shape (5,), at the "
          "median of the drawn friction: from the same insertions, less the slope of the value "
          "on the logarithm of the friction. Empty where the friction states no spread.")
      .def(
          "in_clinic", [](const PlannedArray& one) { return inClinic(*one.plan, *one); },
          "The depth with the clinic's resistance: 'depth_mm' of shape (5,), before the hand "
          "rests, "
          "and 'effective_simulations', the number of draws that its weights amount to. Empty "
          "without "
          "clinic_resistance; Error where these are fewer than 100. Forces and ruptures stay those "
          "of the shipped resistance.")
      .def(
          "force", [](const PlannedArray& one) { return force(*one); },
          "Force over depth: 'depth_mm' (n,), 'draws' (n,), 'force_mN' (n, 5).")
      .def(
          "contacts", [](const PlannedArray& one) { return contacts(*one); },
          "The contacts from the tip: 'number' (n,), 'draws' (n,), 'angle_deg' (n, 5), "
          "'to_modiolus_mm' (n, 5), frequencies (n,) [Hz], 'mismatch_semitones' (n, 5).")
      .def(
          "contacts_to_pandas", [](const PlannedArray& one) { return dataFrameOf(contacts(*one)); },
          "contacts() as a pandas DataFrame, a row each, with columns such as 'angle_deg_p50'.")
      .def(
          "influence", [](const PlannedArray& one) { return influence(*one); },
          "How much of the variance of angle and peak force each input explains, 0 to 1, and the "
          "widths of their bands if it were known: columns of shape (inputs,).")
      .def(py::pickle(
          [](const PlannedArray& one) { return py::make_tuple(one.plan, one.index); },
          [](const py::tuple& state) {
            PlannedArray one{state[0].cast<std::shared_ptr<Plan>>(), state[1].cast<std::size_t>()};
            if (one.index >= one.plan->stored.plan.arrays.size())
              throw EngineError("The pickled array is of another version. Make the plan again.");
            return one;
          }))
      .def("__repr__",
           [](const PlannedArray& one) {
             std::string text = "<perilymph.PlannedArray '" + (*one).name + "'";
             for (const auto& [name, value] : figuresOf(*one)) text += ", " + name + ' ' + value;
             return textOf(text + '>');
           })
      .def(
          "_repr_html_",
          [](const PlannedArray& one) { return htmlTable((*one).name, figuresOf(*one)); },
          "A table of its key figures for notebooks.");
  defineIdentity(planned, [](const PlannedArray& one) {
    return identityOf(*one.plan) + std::to_string(one.index);
  });

  py::class_<Plan, std::shared_ptr<Plan>> kind(
      module, "Plan",
      "Arrays in one patient's cochlea, with bands for what measures, shape, "
      "hand, friction, approach, stiffness and wires leave open. Values are "
      "those of the model, none is "
      "a recommendation.");
  kind.def_property_readonly(
          "patient", [](const Plan& one) { return one.patient; }, "The patient.")
      .def_property_readonly(
          "arrays",
          [](const std::shared_ptr<Plan>& one) {
            std::vector<PlannedArray> arrays;
            for (std::size_t i = 0; i < one->stored.plan.arrays.size(); ++i)
              arrays.push_back({one, i});
            return arrays;
          },
          "The arrays, in the order of the request.")
      .def_property_readonly(
          "bands_hold",
          [](const Plan& one) { return textOf(planning::bandsHold(one.stored.plan)); },
          "What its bands hold from 5 to 95 %: '90 % over friction 0.08 to 0.33'; of a friction "
          "without a stated spread, '90 % at friction 0.12'; of fewer than 64 simulations, "
          "'lowest to highest of 16 simulations at friction 0.12'.")
      .def_property_readonly(
          "seed", [](const Plan& one) { return one.stored.plan.request.seed; }, "Of the draws.")
      .def_property_readonly(
          "program", [](const Plan& one) { return textOf(one.stored.program); },
          "Version of the program that made it.")
      .def_property_readonly(
          "number", [](const Plan& one) { return textOf(one.stored.plan.fingerprint); },
          "SHA-256 of everything it depends on; empty for a plan that was changed after the "
          "program "
          "wrote it.")
      .def_property_readonly(
          "clinic_resistance",
          [](const Plan& one) {
            return textOf(one.stored.plan.clinic ? one.stored.plan.clinic->number : std::string());
          },
          "SHA-256 of the file of the clinic's resistance; empty without one.")
      .def_property_readonly(
          "seal", [](const Plan& one) { return nameOf(one.stored.plan.seal); },
          "'intact', 'absent' (of a version without seals) or 'changed' (by hand, after the "
          "program "
          "wrote it).")
      .def_property_readonly(
          "limits",
          [](const Plan& one) {
            return std::vector<std::string>(one.stored.limits.begin(), one.stored.limits.end());
          },
          "What it leaves open, a sentence each.")
      .def_property_readonly(
          "sources",
          [](const Plan& one) {
            py::list rows;
            for (const planning::PlanSource& each : one.stored.sources)
              rows.append(
                  py::make_tuple(textOf(each.table), textOf(each.source), textOf(each.confidence)));
            return rows;
          },
          "(table, source, confidence) of what was drawn.")
      .def(
          "differences", [](const Plan& one) { return differences(one.stored); },
          "Every two arrays in the same ears, with the same hands and frictions, first minus "
          "second: columns 'first', 'second', 'draws', 'angle_deg', 'depth_mm', 'peak_mN' (n, 5) "
          "and 'first_is_deeper', 'first_has_higher_peak' (n, 3), probabilities with their 95 % "
          "intervals.")
      .def(
          "insertions", [](const Plan& one) { return copied(one.insertions); },
          "Every insertion of a plan that plan() made, as columns: 'draw', 'array', 'A_mm', ..., "
          "'intended_mm' (depth at which the surgeon means to stop), "
          "'angle_deg', 'peak_mN', 'partition_mN', 'end_mN', 'force_after_1s_mN', "
          "'force_after_10s_mN' (NaN if not computed). Empty for one that was read.")
      .def(
          "to_pandas", [](const Plan& one) { return dataFrameOf(one.insertions); },
          "insertions() as a pandas DataFrame.")
      .def(py::pickle([](const Plan& one) { return planState(one); },
                      [](const py::tuple& state) {
                        const auto text = state[0].cast<std::string>();
                        return std::make_shared<Plan>(Plan{
                            valueOf(withoutLock([&] { return planning::planIn(text, "plan"); })),
                            state[1].cast<py::dict>(), state[2].cast<anatomy::Patient>()});
                      }))
      .def("__repr__",
           [](const Plan& one) {
             std::string text =
                 "<perilymph.Plan for '" + one.stored.plan.request.patient.label + "'";
             for (const ArrayPlan& array : one.stored.plan.arrays)
               text += ", " + array.name + ' ' + figuresOf(array).front().second;
             return textOf(text + '>');
           })
      .def(
          "_repr_html_", [](const Plan& one) { return htmlOf(one); },
          "A table of its bands for notebooks.");
  defineIdentity(kind, [](const Plan& one) { return identityOf(one); });

  module.def(
      "plan", &plan, py::arg("patient"), py::arg("arrays") = py::none(), py::kw_only(),
      py::arg("samples") = py::none(), py::arg("all_samples") = false, py::arg("seed") = 1,
      py::arg("jobs") = 0, py::arg("scenario") = "surgery-flex28", py::arg("friction") = py::none(),
      py::arg("clinic_resistance") = py::none(), py::arg("draws_file") = py::none(),
      py::arg("progress") = py::none(),
      "Makes a plan, as 'perilymph-cli plan' does.\n\n"
      "patient: a Patient, a Cochlea of one, or the name or file of one, with A and B.\narrays: "
      "names, files or Array objects; "
      "all shipped ones if None.\nsamples: simulations of each array at most, 16 to 4096; 64 if "
      "None, with "
      "clinic_resistance 512; fewer if the bands stand, unless all_samples.\nseed: of the draws. "
      "jobs: threads, 0: one per processor; does not affect "
      "the plan.\nscenario: what is neither drawn nor named: a Scenario, or the name or path of "
      "one.\nfriction: a Friction, or the name or file of one; None: the "
      "scenario's, an estimate from pig tissue.\nclinic_resistance: the file of a clinic's "
      "resistance "
      "that perilymph.outcome.outcomes wrote; PlannedArray.in_clinic() then has the depth with it. "
      "It "
      "weights the draws, so that more are needed.\ndraws_file: keeps the draws "
      "(.sqlite), so that an interrupted plan continues.\nprogress: called with the numbers "
      "of done and of all insertions; an exception in it ends the plan.\n\n"
      "The interpreter's lock is released while it computes; Ctrl+C ends it.");
  module.def("read_plan", &readPlan, py::arg("path"),
             "Reads a plan: its folder, or the plan.json or draws.sqlite in it.");
}

}  // namespace perilymph::python
