// SPDX-License-Identifier: BSD-3-Clause

// The saved patients, and the table of them for registries.

#include "perilymph/anatomy/Patient.h"
#include "perilymph/session/SavedPatients.h"
#include "perilymph/test/Cli.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class PatientsCommand : public testing::Test {
protected:
  ProgramOutcome patients(std::vector<std::string> arguments = {}) const
  {
    arguments.insert(arguments.begin(), "patients");
    ProgramCall call = cliCall(std::move(arguments));
    call.environment.emplace_back("XDG_DATA_HOME", folder_ / "data");
    call.environment.emplace_back("XDG_STATE_HOME", folder_ / "state");
    return run(call);
  }
  fs::path own() const { return folder_ / "data" / "perilymph" / "patients"; }
  void save(const char* code, double a_mm) const
  {
    anatomy::Patient patient;
    patient.label = code;
    patient.basalTurn = anatomy::BasalTurn{millimeters(a_mm), millimeters(6.7), std::nullopt};
    fs::create_directories(own());
    ASSERT_TRUE(session::savePatientVersion(patient, own() / (std::string(code) + "-right.toml"),
                                            {"2026-01-02T03:04:05Z"}, true));
  }
  TemporaryFolder folder_;
};

TEST_F(PatientsCommand, ListsThePatientsOfTheUser)
{
  EXPECT_EQ(patients().out, "0 patients in " + own().string() + "\n");
  save("P-2", 9.25);
  const auto listed = patients();
  EXPECT_EQ(listed.status, 0);
  EXPECT_THAT(listed.out, HasSubstr("1 patients in"));
  EXPECT_THAT(listed.out, HasSubstr("\nP-2, right ear: A 9.25, B 6.70 mm\n"));
}

TEST_F(PatientsCommand, WritesATableForItsOwnerWithTheDictionaryOfItsColumns)
{
  save("P-2", 9.25);
  save("P-1", 9.5);
  const std::string table = folder_ / "registry.csv", dictionary = folder_ / "columns.csv";
  const auto written = patients({"--registry", table, "--dictionary", dictionary});
  ASSERT_EQ(written.status, 0) << written.err;
  EXPECT_EQ(written.out, "2 patients in " + table + "\n");
  const std::string csv = contentOf(table);
  EXPECT_THAT(csv, HasSubstr("\nP-1,right,0,2026-01-02T03:04:05Z,typed,9.5,"));
  EXPECT_LT(csv.find("\nP-1,"), csv.find("\nP-2,"));
  EXPECT_EQ(fs::status(table).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_THAT(contentOf(dictionary), HasSubstr("\nA_mm,mm,"));
}

TEST_F(PatientsCommand, SaysWhatItCannotReadAndWritesTheOthers)
{
  save("P-1", 9.5);
  std::ofstream(own() / "broken.toml") << "a_mm = 'nine'";
  const auto written = patients({"--registry", folder_ / "registry.csv"});
  EXPECT_EQ(written.status, 0);
  EXPECT_THAT(written.err, HasSubstr("broken.toml"));
  EXPECT_THAT(written.out, HasSubstr("1 patients in"));
}

TEST_F(PatientsCommand, DoesNotWriteTwoTablesIntoOneFile)
{
  const std::string file = folder_ / "registry.csv";
  const auto refused = patients({"--registry", file, "--dictionary", file});
  EXPECT_NE(refused.status, 0);
  EXPECT_FALSE(fs::exists(file));
}

}  // namespace
}  // namespace perilymph::test
