// SPDX-License-Identifier: BSD-3-Clause

// One byte of a file with results changed at random, read in a child process with two seconds of
// processor time and 500 MB of addresses: none crashes the reader, and none keeps its number unless
// its content is the same.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <optional>
#include <random>

#include "PlanFile.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/planning/PlanReading.h"
#include "perilymph/planning/PlanReport.h"
#include "perilymph/session/PatientRecord.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/study/StudyFile.h"
#include "perilymph/test/OddRecords.h"
#include "perilymph/test/SyntheticPlan.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

/// What a reader gives of a file that it takes as the program's own.
using Content = std::optional<std::string>;

std::string digits(double value)
{
  return std::to_string(std::bit_cast<std::uint64_t>(value)) + ' ';
}

Content planIn(const fs::path& file)
{
  const auto stored = planning::readPlan(file);
  if (!stored || stored->plan.fingerprint.empty()) return std::nullopt;
  return *readWhole(file);  // every byte of a text is content
}

Content drawsIn(const fs::path& file)
{
  const auto table = session::InsertionTable::open(file, planning::planKind());
  if (!table || table->seal() == Seal::changed) return std::nullopt;
  const auto insertions = planning::insertionsIn(*table);
  if (!insertions) return std::nullopt;
  std::string text;
  for (const auto& [key, value] : table->facts()) text += key + '=' + value + '\n';
  for (const auto& each : *insertions) text += planning::contentOf(each) + '\n';
  return text;
}

Content studyIn(const fs::path& file)
{
  const auto opened = study::StudyFile::open(file);
  if (!opened || opened->facts().fingerprint.empty()) return std::nullopt;
  const study::StudyFileFacts& facts = opened->facts();
  std::string text = facts.title + facts.text + facts.fingerprint + facts.program +
                     std::to_string(facts.cases) + ' ' + std::to_string(facts.first) + ' ' +
                     std::to_string(facts.end) + '\n';
  for (const std::string& note : facts.notes) text += note + '\n';
  const auto read = opened->read([&](const study::StudyResult& one) -> Result<void> {
    const auto& found = one.insertion;
    text += std::to_string(one.number) + one.cochlea + haptics::nameOf(found.end) + found.reason;
    for (const auto& [key, value] : one.settings) text += key + '=' + value + ' ';
    for (const double value :
         {one.a_mm, one.b_mm, one.scalaLength_mm, found.depth.si(), found.maxDepth.si(),
          found.apical.si(), found.coverage, found.peak.force.si(), found.peak.depth.si(),
          found.endForce.si(), found.partition.si(), double(found.ticks),
          double(found.ticksNotConverged)})
      text += digits(value);
    for (const auto& each : found.profile)
      text += digits(each.depth.si()) + digits(each.force.si());
    for (const auto& each : found.contacts)
      text += std::to_string(each.number) + (each.isInserted ? "+" : "-") +
              digits(each.angle.si()) + digits(each.depth.si()) + digits(each.toModiolus.si()) +
              digits(each.frequency_Hz);
    return {};
  });
  return read ? Content(text) : std::nullopt;
}

Content patientIn(const fs::path& file)
{
  const auto patient = anatomy::loadPatient(file);
  if (!patient || patient->seal != Seal::intact) return std::nullopt;
  return anatomy::patientText(*patient);
}

Content recordIn(const fs::path& file)
{
  const auto record = session::loadPatientRecord(file);
  if (!record || record->isChangedByHand) return std::nullopt;
  return *readWhole(session::recordFileOf(file));
}

Content recordingIn(const fs::path& file)
{
  const auto recorded = session::RecordedInsertion::open(file);
  if (!recorded) return std::nullopt;
  const auto check = recorded->check();
  if (!check || !check->damage.empty()) return std::nullopt;
  const session::RecordingFacts& facts = recorded->facts();
  std::string text = facts.scenarioName + facts.scenarioText + facts.device + facts.version +
                     facts.buildId + facts.startedUtc + digits(facts.timeStep) +
                     std::to_string(facts.seed);
  const auto read = recorded->forEach([&text](const haptics::TickRecord& record) {
    for (const std::uint64_t bits : bitsOf(record)) text += std::to_string(bits) + ' ';
    return true;
  });
  return read ? Content(text) : std::nullopt;
}

void writePlan(const fs::path& file)
{
  const auto json = planning::planJson(syntheticPlan(9));
  ASSERT_TRUE(json) << json.error().message;
  ASSERT_TRUE(writeWhole(file, *json));
}

void writeDraws(const fs::path& file)
{
  auto table = session::InsertionTable::openToContinue(file, planning::planKind(),
                                                       planning::planFacts("0123456789abcdef"));
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_TRUE(table->append(planning::rowsOf(syntheticInsertions(9))));
  ASSERT_TRUE(table->close());
}

/// Part of a study, or all of it.
void writeStudy(const fs::path& file, std::size_t first, std::size_t end)
{
  auto opened = study::StudyFile::openToContinue(
      file, {"Nine", "title = \"Nine\"\n", "ab12", "0.2.0", 9, first, end, {"A is changed."}});
  ASSERT_TRUE(opened) << opened.error().message;
  std::vector<study::StudyResult> results;
  for (std::size_t number = first; number < end; ++number) {
    study::StudyResult one;
    one.number = number;
    one.cochlea = "virtual " + std::to_string(number);
    one.settings = {{"array", "flex28"}, {"friction", "tissue"}};
    one.a_mm = 9.0 + 0.01 * double(number);
    one.b_mm = 6.8;
    one.scalaLength_mm = 33.0;
    one.insertion.end = analysis::InsertionEnd::finished;
    one.insertion.apical = degrees(300.0 + double(number));
    one.insertion.peak = {millimeters(12.0), millinewtons(60.0 + double(number))};
    one.insertion.profile = {{millimeters(1.0), millinewtons(2.0)},
                             {millimeters(2.0), millinewtons(3.5)}};
    one.insertion.contacts.resize(3);
    for (int i = 0; i < 3; ++i) one.insertion.contacts[std::size_t(i)].number = i + 1;
    results.push_back(one);
  }
  ASSERT_TRUE(opened->append(results));
  ASSERT_TRUE(opened->close());
}

void writePatient(const fs::path& file)
{
  anatomy::Patient patient = measuredPatient();
  patient.origin = {"perilymph 0.3.0", std::string(64, 'a'), "RW, A", "B"};
  ASSERT_TRUE(anatomy::savePatient(patient, file));
}

void writeRecord(const fs::path& patient)
{
  ASSERT_TRUE(session::savePatientVersion(
      measuredPatient(), patient,
      {"2026-11-20T09:30:00Z", {}, {{"RW", {1.0, 2.0, 3.0}, true}}, {"A is unusual."}}, true));
  const auto changed = session::changePatientRecord(patient, [](session::PatientRecord& record) {
    record.notes = "Second look.";
    record.plans = {{"2026-11-20T09:30:00Z", "P-17-right-01234567", "2 arrays"}};
  });
  ASSERT_TRUE(changed) << changed.error().message;
}

void writeRecording(const fs::path& file)
{
  session::RecordingFacts facts;
  facts.scenarioText = "title = \"none\"\n";
  facts.startedUtc = "2026-11-20T09:30:00Z";
  auto recording = session::Recording::create(file, facts);
  ASSERT_TRUE(recording) << recording.error().message;
  std::vector<haptics::TickRecord> records;
  for (std::uint64_t tick = 0; tick < 20; ++tick) records.push_back(oddRecord(tick));
  ASSERT_TRUE((*recording)->append(records));
  ASSERT_TRUE((*recording)->close());
}

/// A kind of file: its name, how it is written and read.
struct Kind {
  const char* name;
  std::function<void(const fs::path&)> write;
  std::function<Content(const fs::path&)> read;
};

/// The reader of a record takes the name of its patient's file.
const Kind kinds[] = {
    {"plan.json", writePlan, planIn},
    {"draws.sqlite", writeDraws, drawsIn},
    {"study.sqlite", [](const fs::path& file) { writeStudy(file, 0, 9); }, studyIn},
    {"shard-2-of-3.sqlite", [](const fs::path& file) { writeStudy(file, 3, 6); }, studyIn},
    {"P-17-right.toml", writePatient, patientIn},
    {"P-17-right.json",
     [](const fs::path& file) { writeRecord(fs::path(file).replace_extension(".toml")); },
     [](const fs::path& file) { return recordIn(fs::path(file).replace_extension(".toml")); }},
    {"one.insertion", writeRecording, recordingIn}};

constexpr int withoutNumber = 1, same = 2, other = 3;

/// Reads a file in a child with little time and memory.
int answerInChild(const Kind& kind, const fs::path& file, const std::string& original)
{
  const ::pid_t child = ::fork();
  if (child == 0) {
    const rlimit seconds = {2, 2};
    ::setrlimit(RLIMIT_CPU, &seconds);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    const rlimit bytes = {500u << 20, 500u << 20};
    ::setrlimit(RLIMIT_AS, &bytes);  // a sanitizer needs more
#endif
    const Content content = kind.read(file);
    ::_exit(!content ? withoutNumber : *content == original ? same : other);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

class ResultFiles : public testing::TestWithParam<Kind> {};

TEST_P(ResultFiles, WithOneChangedByteKeepNoNumberForOtherContent)
{
  const Kind& kind = GetParam();
  const TemporaryFolder folder;
  const fs::path file = folder / kind.name;
  kind.write(file);
  if (HasFatalFailure()) return;
  const Content original = kind.read(file);
  ASSERT_TRUE(original);
  const std::string bytes = *readWhole(file);
  std::mt19937 random(20'261'126);
  int withoutItsNumber = 0, withSameContent = 0;
  for (int i = 0; i < RESULT_CHANGES; ++i) {
    std::string content = bytes;
    const std::size_t place = random() % content.size();
    const auto before = content[place];
    while (content[place] == before) content[place] = static_cast<char>(random());
    ASSERT_TRUE(writeWhole(file, content));
    const int answer = answerInChild(kind, file, *original);
    EXPECT_TRUE(answer == withoutNumber || answer == same)
        << kind.name << ", byte " << place << ": " << int(before) << " became "
        << int(content[place]) << (answer == other ? ", unnoticed" : ", answer ") << answer;
    withoutItsNumber += answer == withoutNumber ? 1 : 0;
    withSameContent += answer == same ? 1 : 0;
  }
  RecordProperty("changes", RESULT_CHANGES);
  RecordProperty("without_its_number", withoutItsNumber);
  RecordProperty("with_the_same_content", withSameContent);
  EXPECT_GT(withoutItsNumber, RESULT_CHANGES / 10);  // SQLite leaves much of a small file empty
}

INSTANTIATE_TEST_SUITE_P(All, ResultFiles, testing::ValuesIn(kinds), [](const auto& tested) {
  std::string name = tested.param.name;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
  return name;
});

}  // namespace
}  // namespace perilymph::test
