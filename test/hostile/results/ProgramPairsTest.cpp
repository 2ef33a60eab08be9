// SPDX-License-Identifier: BSD-3-Clause

// Two programs at once on one plan, study, merge or patient: one works, the other says so or comes
// after it, and nothing is lost.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <functional>

#include "PlanFile.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/planning/Plan.h"
#include "perilymph/session/PatientRecord.h"
#include "perilymph/study/StudyFile.h"
#include "perilymph/study/StudyRun.h"
#include "perilymph/test/SyntheticPlan.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr int pairs = PROGRAM_PAIRS;

/// Runs some work in two processes that begin together; their errors, empty for one that is done.
std::array<std::string, 2> inTwoPrograms(const fs::path& folder,
                                         const std::function<std::string(int)>& work)
{
  int gate[2];
  EXPECT_EQ(::pipe(gate), 0);
  for (int i = 0; i < 2; ++i)
    if (::fork() == 0) {
      ::close(gate[1]);
      char byte = 0;
      static_cast<void>(::read(gate[0], &byte, 1));  // until the parent closes it
      std::ofstream(folder / ("error-" + std::to_string(i))) << work(i);
      ::_exit(0);
    }
  ::close(gate[0]);
  ::close(gate[1]);
  std::array<std::string, 2> errors;
  for (int i = 0; i < 2; ++i) {
    int status = 0;
    EXPECT_GT(::wait(&status), 0);
    EXPECT_EQ(status, 0);
  }
  for (int i = 0; i < 2; ++i)
    errors[std::size_t(i)] = *readWhole(folder / ("error-" + std::to_string(i)));
  return errors;
}

/// One is done; the other is, too, or says that it cannot be.
void expectOneDone(const std::array<std::string, 2>& errors, const char* sentence)
{
  EXPECT_TRUE(errors[0].empty() || errors[1].empty()) << errors[0] << '\n' << errors[1];
  for (const std::string& error : errors)
    if (!error.empty()) {
      EXPECT_THAT(error, HasSubstr(sentence));
    }
}

/// Files in a folder that no program should leave there.
void expectNothingLeft(const fs::path& folder)
{
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    EXPECT_TRUE(name.find("begin-") == std::string::npos &&
                name.find("lock") == std::string::npos &&
                name.find("unfinished") == std::string::npos && !name.ends_with("-wal"))
        << name;
  }
}

template <class Value>
std::string errorOf(const Result<Value>& result)
{
  return result ? Sentence() : result.error().message;
}

TEST(TwoPrograms, MakeOnePlan)
{
  planning::PlanRequest request;
  request.patient = measuredPatient();
  request.arrays = {"flex24"};
  request.resolution = planning::Resolution{20, milliseconds(10)};
  request.draws = 1;
  request.jobs = 1;
  for (int pair = 0; pair < pairs; ++pair) {
    const TemporaryFolder folder, errors;
    const fs::path draws = folder / "draws.sqlite";
    expectOneDone(
        inTwoPrograms(errors.path(),
                      [&](int) { return errorOf(planning::makePlan(request, draws, {})); }),
        "another program works on it");
    const auto table = session::InsertionTable::open(draws, planning::planKind());
    ASSERT_TRUE(table) << table.error().message;
    EXPECT_EQ(table->seal(), Seal::intact);
    EXPECT_EQ(table->size(), 1u);
    expectNothingLeft(folder.path());
  }
}

study::Study smallStudy()
{
  const auto study = study::parseStudy(R"(
title = "Small"
scenario = "mean-flex28"
depth = "scenario"
[cochleae]
mean = true
[vary]
nodes = [20]
dt_ms = [10.0]
stop_travel_mm = [0.5, 1.0]
)",
                                       "/study.toml");
  EXPECT_TRUE(study) << errorOf(study);
  return *study;
}

TEST(TwoPrograms, RunAndMergeOneStudy)
{
  const study::Study study = smallStudy();
  for (int pair = 0; pair < pairs; ++pair) {
    const TemporaryFolder folder, errors;
    const auto shard = study::shardOf(study.size(), 1, 1);
    expectOneDone(
        inTwoPrograms(
            errors.path(),
            [&](int) { return errorOf(study::runShard(study, shard, folder.path(), 1, {})); }),
        "another program works on it");
    const auto run = study::StudyFile::open(folder / study::fileNameOf(shard));
    ASSERT_TRUE(run) << run.error().message;
    EXPECT_EQ(run->size(), study.size());
    EXPECT_EQ(run->facts().seal, Seal::intact);

    expectOneDone(inTwoPrograms(errors.path(),
                                [&](int) { return errorOf(study::mergeShards(folder.path())); }),
                  "another program works on it");
    const auto merged = study::StudyFile::open(folder / study::mergedFile);
    ASSERT_TRUE(merged) << merged.error().message;
    EXPECT_EQ(merged->size(), study.size());
    EXPECT_EQ(merged->facts().seal, Seal::intact);
    expectNothingLeft(folder.path());
  }
}

TEST(TwoPrograms, SaveOnePatient)
{
  for (int pair = 0; pair < pairs; ++pair) {
    const TemporaryFolder folder, errors;
    const fs::path patient = folder / "P-17-right.toml";
    // both save the patient as new: one of them did not know of the other
    const auto saved = inTwoPrograms(errors.path(), [&](int i) {
      anatomy::Patient own = measuredPatient();
      own.basalTurn->a = millimeters(9.0 + 0.25 * i);
      return errorOf(session::savePatientVersion(own, patient, {"2026-11-20T09:30:00Z"}, true));
    });
    expectOneDone(saved, "is there already");
    EXPECT_NE(saved[0].empty(), saved[1].empty());
    const auto record = session::loadPatientRecord(patient);
    ASSERT_TRUE(record) << record.error().message;
    EXPECT_EQ(record->versions.size(), 1u);
    EXPECT_EQ(anatomy::loadPatient(patient)->basalTurn->a,
              millimeters(saved[0].empty() ? 9.0 : 9.25));

    // both read the record, then both write their notes
    const auto noted = inTwoPrograms(errors.path(), [&](int i) {
      session::PatientRecord own = *record;
      own.notes = std::to_string(i);
      return errorOf(session::savePatientRecord(own, patient));
    });
    expectOneDone(noted, "was changed by another program meanwhile");
    EXPECT_NE(noted[0].empty(), noted[1].empty());
    EXPECT_EQ(session::loadPatientRecord(patient)->notes, noted[0].empty() ? "0" : "1");

    // both save other measures of a patient that they know: each is a version
    const auto measured = inTwoPrograms(errors.path(), [&](int i) {
      anatomy::Patient own = measuredPatient();
      own.basalTurn->a = millimeters(9.5 + 0.25 * i);
      return errorOf(session::savePatientVersion(own, patient, {"2026-11-21T09:30:00Z"}, false));
    });
    EXPECT_EQ(measured[0] + measured[1], "");
    EXPECT_EQ(session::loadPatientRecord(patient)->versions.size(), 3u);
    expectNothingLeft(folder.path());
  }
}

}  // namespace
}  // namespace perilymph::test
