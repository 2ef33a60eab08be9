// SPDX-License-Identifier: BSD-3-Clause

// Texts of files and devices that contain terminal control sequences: they are printed escaped, and
// JSON and CSV stay valid.

#include <sqlite3.h>

#include <nlohmann/json.hpp>

#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/Utf8.h"
#include "perilymph/test/Cli.h"
#include "perilymph/test/Forgery.h"
#include "perilymph/test/RecordedTree.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Sets the title, clears the screen, the same with U+009B, delete, reverses the line, and starts a
// new line.
const std::string steering =
    "\x1b]0;owned\x07\x1b[2J\xc2\x9b"
    "2J\x7f\xe2\x80\xae"
    "\nforged";
// The same as TOML writes it.
const std::string steeringToml = R"("\u001b]0;owned\u0007\u001b[2J\u009b2J\u007f\u202e\nforged")";

/// The output contains no control characters except newlines and tabs.
void expectHarmless(const ProgramOutcome& outcome)
{
  EXPECT_EQ(outcome.signal, 0);
  for (std::string_view text : {std::string_view(outcome.out), std::string_view(outcome.err)}) {
    EXPECT_THAT(std::string(text), testing::Not(HasSubstr("\nforged")));
    while (!text.empty()) {
      const Utf8Character first = firstCharacter(text);
      ASSERT_NE(first.length, 0u) << "no UTF-8 before " << text.substr(0, 20);
      EXPECT_TRUE(first.code >= 0x20 || first.code == '\n' || first.code == '\t')
          << "U+" << std::hex << static_cast<unsigned>(first.code);
      EXPECT_FALSE(first.code >= 0x7f && first.code < 0xa0);
      EXPECT_NE(first.code, char32_t{0x202e});
      text.remove_prefix(first.length);
    }
  }
}

void change(const fs::path& recording, const std::string& sql)
{
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(recording.c_str(), &database), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
      << sqlite3_errmsg(database);
  EXPECT_EQ(sqlite3_changes(database), 1) << sql;
  sqlite3_close(database);
}

/// A text as SQL writes it.
std::string quoted(const std::string& text)
{
  std::string result = "'";
  for (const char letter : text) result += letter == '\'' ? "''" : std::string(1, letter);
  return result + "'";
}

TEST(ControlSequences, InTheFactsOfARecordingAreEscaped)
{
  const TemporaryFolder folder;
  const std::string file = folder / "run.insertion";
  ASSERT_EQ(cli(shortSimulation({"--record", file})).status, 0);
  for (const std::string key : {"scenario_name", "device", "build_id", "started_utc"})
    change(file, "UPDATE meta SET value = " + quoted(steering) +
                     " || CAST(x'ff' AS TEXT) "
                     "WHERE key = '" +
                     key + "'");
  for (const std::vector<std::string>& call : {std::vector<std::string>{"replay", file},
                                               {"replay", file, "--verify"},
                                               {"compare", file, "--out", folder / "out"}})
    expectHarmless(cli(call));
  EXPECT_THAT(cli({"replay", file}).out, HasSubstr("\\x1b]0;owned\\x07\\x1b[2J\\xc2\\x9b2J\\x7f"
                                                   "\\xe2\\x80\\xae\\x0aforged\\xff"));
}

TEST(ControlSequences, InTheScenarioOfARecordingAreEscaped)
{
  const TemporaryFolder folder;
  const std::string recorded = folder / "run.insertion";
  ASSERT_EQ(cli(shortSimulation({"--record", recorded})).status, 0);
  for (const std::string key : {"anatomy", "side", "array", "technique", "opening", "membrane",
                                "coupling", "model", "friction", "calibration", "title"}) {
    const fs::path file = folder / (key + ".insertion");
    fs::copy(recorded, file);
    // the line number of the key in the scenario's text changes
    change(file,
           "UPDATE meta SET value = (WITH RECURSIVE line(rest, text) AS (SELECT value || "
           "char(10), '' FROM meta WHERE key = 'scenario' UNION ALL SELECT substr(rest, "
           "instr(rest, char(10)) + 1), text || CASE WHEN rest LIKE '" +
               key + " = %' THEN " + quoted(key + " = " + steeringToml) +
               " ELSE substr(rest, 1, instr(rest, char(10)) - 1) END || char(10) FROM line WHERE "
               "rest <> '') SELECT text FROM line WHERE rest = '') WHERE key = 'scenario'");
    test::rehash(file);
    const ProgramOutcome outcome = cli({"replay", file, "--verify"});
    SCOPED_TRACE(key);
    expectHarmless(outcome);
    if (key != "title" && key != "friction" && key != "calibration") {
      EXPECT_EQ(outcome.status, 1) << outcome.out;
      EXPECT_THAT(outcome.err, HasSubstr("owned"));
      EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    }
  }
}

TEST(ControlSequences, InAScenarioAreEscaped)
{
  const TemporaryFolder folder;
  for (const std::string key :
       {"anatomy", "patient", "side", "array", "technique", "opening", "membrane", "coupling",
        "model", "friction", "calibration", "nodes", "unknown"}) {
    std::ofstream(folder / "s.toml") << key << " = " << steeringToml << "\n";
    const ProgramOutcome outcome = cli({"simulate", "--scenario", folder / "s.toml"});
    SCOPED_TRACE(key);
    expectHarmless(outcome);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

TEST(ControlSequences, InTheArgumentsAreEscaped)
{
  const std::vector<std::vector<std::string>> calls = {
      {steering},
      {"simulate", "--scenario", steering},
      {"simulate", "--" + steering},
      {"anatomy", "--preset", steering},
      {"anatomy", "--preset", "published", "--json", "/" + steering + "/x"},
      {"replay", steering + "\xff"},
      shortSimulation({"--set", "title=" + steering + "\xff"}),
      shortSimulation({"--set", steering + "=1"})};
  for (const auto& call : calls) {
    const ProgramOutcome outcome = cli(call);
    EXPECT_NE(outcome.status, 0);
    expectHarmless(outcome);
  }
}

TEST(ControlSequences, InAPatientBreakNoFile)
{
  const TemporaryFolder folder;
  std::string patient = contentOf(resource("resources/patients/average.toml"));
  const std::size_t label = patient.find("label");
  ASSERT_NE(label, std::string::npos);
  patient.replace(label, patient.find('\n', label) - label,
                  "label = \"-->--\\u001b]0;owned\\nv 9 9 9\"");
  std::ofstream(folder / "patient.toml") << patient;
  for (const char* ending : {"obj", "ply", "vtp"}) {
    const fs::path surface = folder / (std::string("a.") + ending);
    const ProgramOutcome outcome = cli({"anatomy", "--patient", folder / "patient.toml", "--json",
                                        folder / "a.json", "--surface", surface});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    expectHarmless(outcome);
    EXPECT_THAT(contentOf(surface), testing::Not(HasSubstr("\nv 9 9 9")));
    const auto json = nlohmann::json::parse(contentOf(folder / "a.json"));
    EXPECT_EQ(json["label"].get<std::string>(), "-->-- ]0;owned v 9 9 9");
  }
  // the comment of the .vtp ends correctly
  if (!PERILYMPH_HAS_VTK) return;
  EXPECT_EQ(cli({"anatomy", "--import", folder / "a.vtp"}).status, 0);
}

TEST(ControlSequences, InTheNameOfADeviceAreEscapedAndItsJsonIsValid)
{
  const TemporaryFolder folder;
  RecordedTree tree;
  tree.add({"0003:ABCD:0002.0001", "\x1b]0;owned\x07\xff\xe2\x80\xae stick", "hidraw0", "00"});
  tree.addNode("hidraw0");
  ProgramCall call = cliCall({"devices", "--json", folder / "devices.json"});
  call.environment.emplace_back("PERILYMPH_SYSTEM_ROOT", tree.root().string());
  const ProgramOutcome outcome = run(call);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  expectHarmless(outcome);
  EXPECT_THAT(outcome.out, HasSubstr("\\x1b]0;owned\\x07\\xff"));
  const auto json = nlohmann::json::parse(contentOf(folder / "devices.json"));
  EXPECT_THAT(json["devices"][0]["name"].get<std::string>(), HasSubstr("]0;owned"));
}

TEST(ControlSequences, OnATapeAreEscapedAndItsJsonIsValid)
{
  const TemporaryFolder folder;
  std::ofstream(folder / "stick.hid")
      << "D: 0\nR: 38 05 01 09 04 a1 01 09 30 09 31 15 00 26 ff 00 75 08 95 02 81 02 05 09 19 01 "
         "29 08 15 00 25 01 75 01 95 08 81 02 c0\nN: \x1b]0;owned\x07\xff\x7f\nI: 3 abcd 0002\n"
         "E: 000000.000000 3 80 80 00\nE: 000000.010000 3 ff 80 01\n";
  const ProgramOutcome outcome =
      cli({"devices", "--replay", folder / "stick.hid", "--json", folder / "stick.json"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  expectHarmless(outcome);
  EXPECT_TRUE(nlohmann::json::accept(contentOf(folder / "stick.json")));
}

TEST(ControlSequences, InTheNamesOfRecordingsLeaveTheTablesValid)
{
  const TemporaryFolder folder;
  const fs::path file = folder / ("a,\"b\"\n\x1b[2J\xff.insertion");
  ASSERT_EQ(cli(shortSimulation({"--record", file})).status, 0);
  const ProgramOutcome outcome = cli({"compare", file, "--out", folder / "out"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  expectHarmless(outcome);
  for (const char* name : {"comparison.csv", "curves.csv", "curves.svg"}) {
    const std::string content = contentOf(folder / "out" / name);
    EXPECT_EQ(validUtf8(content), content) << name;
  }
  // one field in quotation marks, the line inside it
  EXPECT_THAT(contentOf(folder / "out/comparison.csv"), HasSubstr("\"a,\"\"b\"\"\n"));
  EXPECT_THAT(contentOf(folder / "out/curves.svg"), testing::Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace perilymph::test
