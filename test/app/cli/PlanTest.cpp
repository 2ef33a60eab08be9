// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/test/Cli.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Plans : public testing::Test {
protected:
  ProgramOutcome plan(const std::string& patient, const std::vector<std::string>& more = {}) const
  {
    std::vector<std::string> call = {"plan",          "--patient", patient, "--out",
                                     folder_ / "out", "--samples", "1"};
    call.insert(call.end(), more.begin(), more.end());
    return run(fewDrawsCall(call));
  }
  std::string text(const std::string& name) const { return contentOf(folder_ / "out" / name); }
  TemporaryFolder folder_;
};

TEST_F(Plans, AreWrittenWithTheirTablesAndFiguresAndContinueToTheSameBytes)
{
  const auto first = plan("measured", {"--arrays", "flex24"});
  ASSERT_EQ(first.status, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("FLEX24, 1 simulation\n"));
  EXPECT_THAT(first.out, HasSubstr("Median (1 simulation over friction 0.08 to 0.33)"));
  EXPECT_THAT(first.out,
              HasSubstr("intended depth reached   0 of 1\n  stopped by resistance    1 of 1\n"));
  EXPECT_THAT(text("arrays.csv"), HasSubstr(",bands_hold,at_median_friction_angle_deg_p5,"));
  EXPECT_THAT(text("arrays.csv"), HasSubstr(",1 simulation over friction 0.08 to 0.33,"));
  EXPECT_THAT(first.out, HasSubstr("angular insertion depth"));
  EXPECT_THAT(first.out, HasSubstr("after 10 s of rest "));
  const std::string json = text("plan.json"), contacts = text("contacts.csv");
  const auto parsed = nlohmann::json::parse(json);
  EXPECT_EQ(parsed["patient"]["A_sd_mm"], 0.15);
  EXPECT_GT(parsed["arrays"][0]["angle_deg"]["median"].get<double>(), 90.0);
  EXPECT_TRUE(fs::exists(folder_ / "out" / "force-1.svg"));
  EXPECT_FALSE(fs::exists(folder_ / "out" / "influence-1.svg"));  // none from so few
  EXPECT_THAT(text("shapes.csv"), HasSubstr("\nflex24,1,40,"));   // the tip of 40 nodes

  // It describes a patient: its files are for their owner only.
  EXPECT_EQ(fs::status(folder_ / "out").permissions(), fs::perms::owner_all);
  for (const auto& entry : fs::directory_iterator(folder_ / "out"))
    EXPECT_EQ(entry.status().permissions(), fs::perms::owner_read | fs::perms::owner_write)
        << entry.path();

  EXPECT_THAT(text("plan.toml"), HasSubstr("\narrays = [\"flex24\"]\n"));
  EXPECT_THAT(text("plan.toml"), HasSubstr("\nshown_draws = 1\nis_complete = true\n"));
  EXPECT_EQ(
      anatomy::patientText(*anatomy::loadPatient(folder_ / "out/patient.toml")),
      anatomy::patientText(*anatomy::loadPatient(resource("resources/patients/measured.toml"))));

  const auto again = plan("measured", {"--arrays", "flex24"});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(text("plan.json"), json);
  EXPECT_EQ(text("contacts.csv"), contacts);
}

TEST_F(Plans, OfMeasuresThatWereChangedByHandSaySo)
{
  anatomy::Patient patient;
  patient.label = "P-017";
  patient.basalTurn = anatomy::BasalTurn{millimeters(9.2), millimeters(6.8), std::nullopt};
  patient.origin = {"perilymph 0.3.0", std::string(64, 'a'), "", "RW"};
  const fs::path file = folder_ / "p.toml";
  ASSERT_TRUE(anatomy::savePatient(patient, file));
  EXPECT_EQ(cli({"anatomy", "--patient", file}).err, "");
  std::string changed = contentOf(file);
  changed.replace(changed.find("9.2"), 3, "9.6");
  std::ofstream(file) << changed;
  const char* sentence =
      "The measures of P-017 were changed by hand after the program wrote them. Do not use them as "
      "measured in a CT.\n";
  EXPECT_EQ(cli({"anatomy", "--patient", file}).err, sentence);
  EXPECT_THAT(cli({"simulate", "--scenario", "mean-contour", "--patient", file, "--set",
                   "stop_travel_mm=0.5"})
                  .err,
              HasSubstr(sentence));
  const auto planned = plan(file, {"--arrays", "flex24"});
  ASSERT_EQ(planned.status, 0) << planned.err;
  EXPECT_EQ(planned.err, sentence);
  EXPECT_EQ(nlohmann::json::parse(text("plan.json"))["patient"]["seal"], "changed");
}

TEST_F(Plans, OfFewerThanSixteenSimulationsAreRefusedInOneSentence)
{
  for (const char* samples : {"0", "1", "15", "4097"}) {
    const auto outcome = cli({"plan", "--patient", "measured", "--arrays", "flex24", "--samples",
                              samples, "--out", folder_ / "out"});
    EXPECT_EQ(outcome.status, 1) << samples;
    EXPECT_THAT(outcome.err,
                HasSubstr(std::string("A plan of ") + samples + " simulations is too"));
    EXPECT_THAT(outcome.err, HasSubstr("Choose 16 to 4096."));
    EXPECT_FALSE(fs::exists(folder_ / "out"));
  }
}

TEST_F(Plans, AreRefusedWhereAWholeNumberIsNone)
{
  const std::string past = "18446744073709551617";  // 2^64 + 1
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"--samples", "-5"}, {"--samples", "1e3"}, {"--samples", "16.0"},
      {"--samples", past}, {"--seed", "-1"},     {"--seed", past},
      {"--seed", "0x10"},  {"--jobs", "0"},      {"--jobs", "257"}};
  for (const auto& [option, value] : cases) {
    const auto outcome = cli({"plan", "--patient", "measured", "--arrays", "flex24", option, value,
                              "--out", folder_ / "out"});
    EXPECT_EQ(outcome.status, 2) << option << value;
    EXPECT_THAT(outcome.err,
                testing::StartsWith(option + ": '" + value + "' is not a whole number from "));
  }
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Plans, NeedAPatientWithAAndB)
{
  const auto outcome = plan("average", {"--arrays", "flex24"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("has no A and B"));
}

TEST_F(Plans, NameAnArrayThatIsNotThere)
{
  const auto outcome = plan("measured", {"--arrays", "flex99"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("flex99"));
}

}  // namespace
}  // namespace perilymph::test
