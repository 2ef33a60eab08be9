// SPDX-License-Identifier: BSD-3-Clause

// The published run gives the same bits on every x86-64: here with newer instructions hidden from
// the C library, whose sine and exponential then differ in the last digit (shown by the tests of
// foundation's Math.h).

#include "perilymph/test/Cli.h"

namespace perilymph::test {
namespace {

TEST(PublishedRun, GivesTheSameBitsWithoutFmaAndAvx2)
{
  const TemporaryFolder folder;
  const auto arguments = [&](const std::string& name) {
    return std::vector<std::string>{"simulate",
                                    "--scenario",
                                    "contour-published",
                                    "--csv",
                                    folder / (name + ".csv"),
                                    "--record",
                                    folder / (name + ".insertion")};
  };
  ASSERT_EQ(cli(arguments("here")).status, 0);
  ProgramCall older = cliCall(arguments("older"));
  older.environment = {{"GLIBC_TUNABLES", "glibc.cpu.hwcaps=-FMA,-AVX2"}};
  ASSERT_EQ(run(older).status, 0);

  const std::string rows = contentOf(folder / "here.csv");
  EXPECT_GT(std::count(rows.begin(), rows.end(), '\n'), 8250);
  EXPECT_TRUE(rows == contentOf(folder / "older.csv"));

  // a recording of the older machine replays here
  const auto replayed = cli({"replay", folder / "older.insertion", "--verify"});
  EXPECT_EQ(replayed.status, 0) << replayed.err;
}

}  // namespace
}  // namespace perilymph::test
