// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/ChildProcess.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <system_error>

#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

using namespace std::chrono_literals;

ProgramCall shell(const std::string& script)
{
  return {.program = "sh", .arguments = {"-c", script}, .environment = {}, .folder = {}};
}

TEST(ChildProcess, KeepsOutputAndErrorApart)
{
  const ProgramOutcome outcome = run(shell("echo to out; echo to err >&2; exit 7"));
  EXPECT_EQ(outcome.out, "to out\n");
  EXPECT_EQ(outcome.err, "to err\n");
  EXPECT_EQ(outcome.status, 7);
}

TEST(ChildProcess, TakesMoreOutputThanAPipeHolds)
{
  const ProgramOutcome outcome =
      run(shell("head -c 1000000 /dev/zero; head -c 300000 /dev/zero >&2"));
  EXPECT_EQ(outcome.out.size(), 1000000u);
  EXPECT_EQ(outcome.err.size(), 300000u);
}

TEST(ChildProcess, TellsASignalFromAnExit)
{
  const ProgramOutcome outcome = run(shell("kill -SEGV $$"));
  EXPECT_EQ(outcome.signal, SIGSEGV);
  EXPECT_EQ(outcome.status, -1);
}

TEST(ChildProcess, IsKilledWithItsChildrenWhenTheTimeIsOver)
{
  // If it survived, the inner shell would hold the pipe open for an hour.
  const ProgramOutcome outcome = run(shell("echo begun; sh -c 'sleep 3600' & wait"), 200ms);
  EXPECT_TRUE(outcome.timedOut);
  EXPECT_EQ(outcome.signal, SIGKILL);
}

TEST(ChildProcess, EndsEvenIfSomethingItLeftBehindHoldsItsOutput)
{
  const ProgramOutcome outcome = run(shell("sleep 5 & echo $!"), 4s);
  EXPECT_FALSE(outcome.timedOut);
  kill(std::atoi(outcome.out.c_str()), SIGKILL);
}

TEST(ChildProcess, IsWaitedForUntilItSaysAWord)
{
  ChildProcess process(shell("echo ready; exec sleep 3600"));
  EXPECT_TRUE(process.waitForOutput("ready", 60s));
  process.send(SIGTERM);
  EXPECT_EQ(process.wait(60s).signal, SIGTERM);
}

TEST(ChildProcess, WaitsForNoWordOnceItHasEnded)
{
  ChildProcess process(shell("echo something else"));
  EXPECT_FALSE(process.waitForOutput("ready", 60s));
}

TEST(ChildProcess, SeesItsEnvironmentChanged)
{
  setenv("PERILYMPH_TEST_OLD", "old", 1);
  ProgramCall call = shell("echo \"$PERILYMPH_TEST_NEW/${PERILYMPH_TEST_OLD-gone}\"");
  call.environment = {{"PERILYMPH_TEST_NEW", "new"}, {"PERILYMPH_TEST_OLD", std::nullopt}};
  EXPECT_EQ(run(call).out, "new/gone\n");
}

TEST(ChildProcess, RunsInTheFolderItIsGiven)
{
  const TemporaryFolder folder;
  ProgramCall call = shell("pwd -P");
  call.folder = folder.path();
  EXPECT_EQ(run(call).out, std::filesystem::canonical(folder.path()).string() + "\n");
}

TEST(ChildProcess, ThatCannotBeStartedIsAnError)
{
  EXPECT_THROW(
      run({.program = "/no/such/program", .arguments = {}, .environment = {}, .folder = {}}),
      std::system_error);
}

TEST(ChildProcess, LeavesNothingRunningWhenItIsForgotten)
{
  int id = 0;
  {
    ChildProcess process(shell("exec sleep 3600"));
    id = process.id();
    ASSERT_EQ(kill(id, 0), 0);
  }
  EXPECT_NE(kill(id, 0), 0);
}

}  // namespace
}  // namespace perilymph::test
