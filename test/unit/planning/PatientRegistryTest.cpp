// SPDX-License-Identifier: BSD-3-Clause

// The table for registries beside the files that it is made of.

#include "perilymph/planning/PatientRegistry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/planning/PlanFolder.h"
#include "perilymph/planning/PlanReport.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/SavedPatients.h"
#include "perilymph/test/SyntheticPlan.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::planning {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
using Fields = std::map<std::string, std::string>;

/// The fields of a line; a field in quotation marks may hold commas.
std::vector<std::string> fieldsOf(const std::string& line)
{
  std::vector<std::string> fields(1);
  bool isQuoted = false;
  for (const char letter : line) {
    if (letter == '"')
      isQuoted = !isQuoted;
    else if (letter == ',' && !isQuoted)
      fields.emplace_back();
    else
      fields.back() += letter;
  }
  return fields;
}

std::vector<Fields> rowsOf(const std::string& csv)
{
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  const auto names = fieldsOf(line);
  std::vector<Fields> rows;
  while (std::getline(lines, line)) {
    const auto fields = fieldsOf(line);
    EXPECT_EQ(fields.size(), names.size()) << line;
    Fields row;
    for (std::size_t i = 0; i < std::min(fields.size(), names.size()); ++i)
      row[names[i]] = fields[i];
    rows.push_back(row);
  }
  return rows;
}

class Registry : public testing::Test {
protected:
  Registry()
  {
    for (const char* name : {"patients", "plans", "recordings"})
      fs::create_directory(folder_ / name);
  }

  /// A patient's file. @return Its place.
  fs::path save(const anatomy::Patient& patient)
  {
    const fs::path file =
        folder_ / "patients" / (patient.label + "-" + nameOf(patient.side) + ".toml");
    EXPECT_TRUE(session::savePatientVersion(patient, file, {"2026-01-02T03:04:05Z"}, true));
    return file;
  }
  static anatomy::Patient measured(const char* code)
  {
    anatomy::Patient patient = test::measuredPatient();
    patient.label = code;
    return patient;
  }
  /// A plan of the synthetic insertions. @return Its plan.json.
  std::string plan(const anatomy::Patient& patient, const char* name, const char* utc,
                   std::size_t draws)
  {
    Plan plan = test::syntheticPlan(draws);
    plan.request.patient = patient;
    const fs::path place = folder_ / "plans" / name;
    fs::create_directory(place);
    EXPECT_TRUE(anatomy::savePatient(patient, place / planPatientFile));
    std::ofstream(place / planRequestFile)
        << "made = '" << utc << "'\narrays = ['flex24']\nscenario = 'surgery-flex28'\ndraws = 64\n"
        << "seed = 1\nshown_draws = " << draws << "\n";
    const auto json = planJson(plan);
    EXPECT_TRUE(json) << json.error().message;
    std::ofstream(place / planJsonFile) << *json;
    return *json;
  }
  /// A recorded insertion of 4 mm.
  fs::path insert(const fs::path& patient, const std::string& array, const char* name)
  {
    const fs::path scenario = folder_ / "coarse.toml";
    std::ofstream(scenario)
        << "title = 'coarse'\nanatomy = 'mean'\nfriction = 'tissue'\nnodes = 20\n"
           "dt_ms = 10.0\nstart_inside_mm = 1.0\nstop_travel_mm = 4.0\n";
    const auto one =
        session::loadScenario(scenario.string(), {{"array", array}, {"patient", patient.string()}});
    EXPECT_TRUE(one) << one.error().message;
    const fs::path file = folder_ / "recordings" / (std::string(name) + ".insertion");
    auto insertion = session::Insertion::prepare(
        *one, std::make_unique<device::ScriptedDevice>(one->speed().si(), one->timeStep().si()),
        file);
    EXPECT_TRUE(insertion) << insertion.error().message;
    EXPECT_TRUE((*insertion)->runToEnd(nullptr));
    return file;
  }

  PatientRegistry registry()
  {
    const auto made = patientRegistry(folders());
    EXPECT_TRUE(made) << made.error().message;
    return made ? *made : PatientRegistry{};
  }
  RegistryFolders folders() const
  {
    return {folder_ / "patients", folder_ / "plans", folder_ / "recordings"};
  }

  test::TemporaryFolder folder_;
};

double valueOf(const Fields& row, const char* name)
{
  return row.at(name).empty() ? std::nan("") : std::stod(row.at(name));
}

TEST_F(Registry, IsEmptyWithoutPatients)
{
  const auto none = registry();
  EXPECT_EQ(none.patients, 0u);
  EXPECT_TRUE(rowsOf(none.csv).empty());
  EXPECT_TRUE(none.notes.empty());
  EXPECT_TRUE(patientRegistry({"/absent", "/absent", "/absent"}));
}

TEST_F(Registry, HasARowForEachColumnInItsDictionary)
{
  std::istringstream lines(registryDictionaryCsv());
  std::string line, head;
  std::getline(lines, line);
  EXPECT_EQ(line, "column,unit,meaning,source");
  while (std::getline(lines, line)) {
    const auto fields = fieldsOf(line);
    ASSERT_EQ(fields.size(), 4u) << line;
    EXPECT_FALSE(fields[2].empty() || fields[3].empty()) << line;
    head += (head.empty() ? "" : ",") + fields[0];
    for (const auto& [unit, ending] :
         {std::pair{"mm", "_mm"}, {"degrees", "_deg"}, {"mN", "_mN"}, {"%", "_percent"}})
      EXPECT_EQ(fields[1] == unit, fields[0].ends_with(ending)) << line;
  }
  EXPECT_EQ(registry().csv, head + "\n");
}

TEST_F(Registry, StatesMeasuresWithTheir95PercentIntervalsAndNothingThatIsNotKnown)
{
  save(measured("P-2"));  // A 9.2, B 6.8 and H 4.0 mm with errors of 0.1, 0.2 and 0.3 mm
  anatomy::Patient lengths;
  lengths.label = "P-1";
  lengths.side = anatomy::Side::left;
  save(lengths);
  const auto rows = rowsOf(registry().csv);
  ASSERT_EQ(rows.size(), 2u);
  const Fields& one = rows[1];
  EXPECT_EQ(one.at("code"), "P-2");
  EXPECT_EQ(one.at("ear"), "right");
  EXPECT_EQ(one.at("measures_from"), "typed");
  EXPECT_EQ(one.at("measured_utc"), "2026-01-02T03:04:05Z");
  EXPECT_EQ(one.at("A_mm"), "9.2");
  EXPECT_NEAR(valueOf(one, "A_low_mm"), 9.2 - 0.196, 1e-4);
  EXPECT_NEAR(valueOf(one, "A_high_mm"), 9.2 + 0.196, 1e-4);
  EXPECT_NEAR(valueOf(one, "B_low_mm"), 6.8 - 0.392, 1e-4);
  EXPECT_NEAR(valueOf(one, "H_high_mm"), 4.0 + 0.588, 1e-4);
  // Schurzig et al. 2018 for the mean A and B of the population: 33 to 36 mm
  EXPECT_GT(valueOf(one, "cdl_oc_mm"), 32.0);
  EXPECT_LT(valueOf(one, "cdl_oc_mm"), 37.0);
  EXPECT_LT(valueOf(one, "cdl_oc_low_mm"), valueOf(one, "cdl_oc_mm"));
  EXPECT_GT(valueOf(one, "cdl_oc_high_mm"), valueOf(one, "cdl_oc_mm"));
  for (const char* unknown : {"st_length_mm", "plan_utc", "plan_arrays", "insertion_utc",
                              "insertion_angle_deg", "planned_angle_deg", "outcome_utc"})
    EXPECT_EQ(one.at(unknown), "") << unknown;
  const Fields& other = rows[0];
  EXPECT_EQ(other.at("ear"), "left");
  EXPECT_EQ(other.at("A_mm"), "");
  EXPECT_EQ(other.at("st_length_mm"), "35.58");
  EXPECT_NEAR(valueOf(other, "rw_width_low_mm"), 1.94 - 0.196, 1e-4);
}

TEST_F(Registry, StatesTheNewestPlanAsItsJsonAndTheNewestInsertionAsItsTicks)
{
  const anatomy::Patient patient = measured("P-3");
  const fs::path file = save(patient);
  plan(patient, "old", "2026-01-01T00:00:00Z", 16);
  const auto json = nlohmann::json::parse(plan(patient, "new", "2026-02-01T00:00:00Z", 64));
  anatomy::Patient otherEar = patient;
  otherEar.side = anatomy::Side::left;
  plan(otherEar, "other", "2026-03-01T00:00:00Z", 32);
  const std::string array = json["arrays"][0]["array"];
  const fs::path recording = insert(file, array, "one");
  const auto made = registry();
  EXPECT_TRUE(made.notes.empty()) << made.notes.front();
  const auto rows = rowsOf(made.csv);
  ASSERT_EQ(rows.size(), 1u);
  const Fields& row = rows[0];

  EXPECT_EQ(row.at("plan_utc"), "2026-02-01T00:00:00Z");
  EXPECT_EQ(row.at("plan_of_these_measures"), "1");
  EXPECT_EQ(row.at("plan_bands_hold"), json["bands_hold"].get<std::string>());
  const auto both = [&json](const char* key, const char* quantile) {
    std::ostringstream text;
    for (const int index : {0, 1})
      text << (index > 0 ? ";" : "") << json["arrays"][index][key][quantile].get<double>();
    return text.str();
  };
  EXPECT_EQ(row.at("plan_angle_deg"), both("angle_deg", "median"));
  EXPECT_EQ(row.at("plan_angle_p5_deg"), both("angle_deg", "p5"));
  EXPECT_EQ(row.at("plan_peak_p95_mN"), both("peak_mN", "p95"));
  EXPECT_EQ(row.at("plan_simulations"), "64;64");
  // of the array that was inserted
  EXPECT_EQ(row.at("insertion_array"), array);
  EXPECT_EQ(valueOf(row, "planned_peak_mN"), json["arrays"][0]["peak_mN"]["median"]);
  EXPECT_NEAR(valueOf(row, "planned_translocated_percent"),
              100.0 * json["arrays"][0]["probability"]["translocated"]["value"].get<double>(),
              1e-3);

  double depth = 0.0, peak = 0.0;
  const auto ticks = session::RecordedInsertion::open(recording);
  ASSERT_TRUE(ticks) << ticks.error().message;
  ASSERT_TRUE(ticks->forEach([&](const haptics::TickRecord& record) {
    depth = std::max(depth, record.output.depth);
    peak = std::max(peak, record.output.axialForce);
    return true;
  }));
  EXPECT_EQ(row.at("insertion_utc"), ticks->facts().startedUtc);
  EXPECT_NEAR(valueOf(row, "insertion_depth_mm"), 1e3 * depth, 1e-3);
  EXPECT_NEAR(valueOf(row, "insertion_peak_mN"), 1e3 * peak, 1e-3 * (1.0 + 1e3 * peak));
  EXPECT_EQ(row.at("insertion_outcome"), "finished");
  EXPECT_EQ(row.at("insertion_verified"), "1");
  EXPECT_EQ(row.at("insertion_translocated"), "0");
  EXPECT_GT(valueOf(row, "insertion_contacts"), valueOf(row, "insertion_contacts_inside"));
  EXPECT_EQ(row.at("insertion_angle_deg").empty(), row.at("insertion_contacts_inside") == "0");
}

TEST_F(Registry, SaysThatAPlanIsOfOtherMeasuresAndStatesNoneOfAnotherArray)
{
  anatomy::Patient patient = measured("P-4");
  plan(patient, "plan", "2026-02-01T00:00:00Z", 64);
  patient.basalTurn->a = millimeters(9.9);
  insert(save(patient), "contour", "one");
  const auto rows = rowsOf(registry().csv);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].at("plan_of_these_measures"), "0");
  EXPECT_EQ(rows[0].at("insertion_array"), "contour");
  EXPECT_EQ(rows[0].at("planned_angle_deg"), "");
}

TEST_F(Registry, NamesNobodyAndSaysWhatIsLeftOut)
{
  const fs::path file = save(measured("P-5"));
  ASSERT_TRUE(session::changePatientRecord(file, [](session::PatientRecord& record) {
    record.notes = "Secretname wants music";
    record.tags = {"Secrettag"};
    record.isArchived = true;
    record.outcomes = {{"2026-04-05T06:07:08Z", std::string(64, 'a'), "{}"}};
  }));
  anatomy::Patient named = measured("Jane Secretname");
  ASSERT_TRUE(anatomy::savePatient(named, folder_ / "patients" / "typed.toml"));
  std::ofstream(folder_ / "patients" / "broken.toml") << "a_mm = 'nine'";
  const auto made = registry();
  EXPECT_THAT(made.csv, Not(HasSubstr("Secret")));
  EXPECT_THAT(made.csv, Not(HasSubstr(folder_.path().string())));
  EXPECT_EQ(made.patients, 1u);
  EXPECT_THAT(made.notes,
              testing::UnorderedElementsAre(
                  HasSubstr("broken.toml"),
                  testing::AllOf(HasSubstr("typed.toml is left out"), Not(HasSubstr("Secret")))));
  const auto rows = rowsOf(made.csv);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].at("archived"), "1");
  EXPECT_EQ(rows[0].at("outcome_utc"), "2026-04-05T06:07:08Z");
}

TEST_F(Registry, IsMadeWholeOrNotAtAllWhenItIsCanceled)
{
  save(measured("P-6"));
  save(measured("P-7"));
  std::stop_source source;
  std::size_t last = 0;
  const auto made = patientRegistry(
      folders(),
      [&](std::size_t done, std::size_t all) {
        EXPECT_EQ(all, 2u);
        last = done;
        if (done == 1) source.request_stop();
      },
      source.get_token());
  EXPECT_FALSE(made);
  EXPECT_EQ(last, 1u);
}

}  // namespace
}  // namespace perilymph::planning
