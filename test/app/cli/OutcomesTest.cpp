// SPDX-License-Identifier: BSD-3-Clause

// Outcomes of a clinic beside its plans, and what is refused.

#include "perilymph/test/Cli.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class OutcomesCommand : public testing::Test {
protected:
  ProgramOutcome outcomes(const std::vector<std::string>& more = {}) const
  {
    std::vector<std::string> arguments = {"outcomes", "--library", folder_ / "library", "--out",
                                          folder_ / "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(cliCall(std::move(arguments)));
  }
  TemporaryFolder folder_;
};

TEST_F(OutcomesCommand, WritesTablesFiguresAndSentencesAlsoWithoutOutcomes)
{
  fs::create_directories(folder_.path() / "library" / "patients");
  const auto written = outcomes();
  ASSERT_EQ(written.status, 0) << written.err;
  EXPECT_THAT(written.out, HasSubstr("0 of 0 outcomes are informative about resistance"));
  for (const char* name :
       {"outcomes.json", "outcomes.csv", "outcomes-dictionary.csv", "outcomes.md", "depths.svg"})
    EXPECT_TRUE(fs::exists(folder_.path() / "out" / name)) << name;
}

TEST_F(OutcomesCommand, WritesNoResistanceThatIsNotOffered)
{
  fs::create_directories(folder_.path() / "library" / "patients");
  const std::string file = folder_ / "clinic.json";
  const auto refused = outcomes({"--resistance", file});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("The clinic's resistance is not offered"));
  EXPECT_FALSE(fs::exists(file));
  EXPECT_FALSE(fs::exists(folder_.path() / "out"));
}

TEST_F(OutcomesCommand, RefusesALibraryWithoutPatients)
{
  const auto refused = outcomes();
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("has no folder 'patients'"));
}

TEST_F(OutcomesCommand, LetsAPlanRefuseAFileThatIsNoResistance)
{
  const std::string file = folder_ / "clinic.json";
  std::ofstream(file) << "{}";
  const auto refused = run(cliCall({"plan", "--patient", "measured", "--arrays", "flex28",
                                    "--clinic-resistance", file, "--out", folder_ / "plan"}));
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("is not the resistance of a clinic"));
}

}  // namespace
}  // namespace perilymph::test
