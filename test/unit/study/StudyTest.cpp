// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/study/Study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <charconv>
#include <set>

#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::study {
namespace {

using testing::HasSubstr;

constexpr const char* small = R"(
title = "Length and friction"
scenario = "mean-flex28"
seed = 7
[cochleae]
mean = true
virtual = 2
[vary]
array = ["flex24", "flex28"]
friction = ["soap-10", "tissue"]
)";

Result<Study> read(const std::string& text) { return parseStudy(text, "/study.toml"); }

/// The message of a study that is refused.
std::string refusal(const std::string& text)
{
  const auto study = read(text);
  return study ? "was read" : study.error().message;
}

std::string valueOf(const StudyCase& one, const std::string& key)
{
  for (const auto& [name, value] : one.overrides)
    if (name == key) return value;
  return "";
}

TEST(Study, RunsEveryCombinationInEveryCochlea)
{
  const auto study = read(small);
  ASSERT_TRUE(study) << study.error().message;
  EXPECT_EQ(study->size(), 12u);
  std::set<std::string> seen;
  for (std::size_t k = 0; k < study->size(); ++k) {
    const StudyCase one = study->caseAt(k);
    EXPECT_EQ(one.number, k);
    EXPECT_EQ(one.cochlea, k / 4);
    seen.insert(study->cochleae()[one.cochlea].name + valueOf(one, "array") +
                valueOf(one, "friction"));
  }
  EXPECT_EQ(seen.size(), 12u);
  EXPECT_EQ(study->cochleae().front().name, "mean");
  EXPECT_EQ(study->cochleae().back().name, "virtual 2");
}

TEST(Study, InsertsEachArrayToItsOwnFullDepth)
{
  const auto study = read(small);
  ASSERT_TRUE(study) << study.error().message;
  for (const std::size_t k : {0, 3, 7}) {
    const auto parameters = study->parametersOf(study->caseAt(k));
    ASSERT_TRUE(parameters) << parameters.error().message;
    const Length full = parameters->array.insertable - parameters->startInside;
    EXPECT_NEAR(inMillimeters(parameters->stopTravel), inMillimeters(full), 0.001);
    EXPECT_EQ(parameters->engine.stopTravel, parameters->stopTravel.si());
  }
}

TEST(Study, DrawsAVirtualPatientBySeedAndNumberAlone)
{
  const auto study = read(small);
  const auto more = read(std::string(small) + "speed_mm_s = [0.5, 1.0]\n");
  ASSERT_TRUE(study && more);
  const auto a = study->parametersOf(study->caseAt(4));
  const auto b = more->parametersOf(more->caseAt(8));
  const auto other = study->parametersOf(study->caseAt(8));
  ASSERT_TRUE(a && b && other);
  ASSERT_TRUE(a->cochlea.patient.basalTurn);
  EXPECT_EQ(a->cochlea.patient.basalTurn->a, b->cochlea.patient.basalTurn->a);
  EXPECT_NE(a->cochlea.patient.basalTurn->a, other->cochlea.patient.basalTurn->a);
}

TEST(Study, SamplesRangesOverAllCochleaeTheSameForEveryCombination)
{
  const auto study =
      read(std::string(small) + "[ranges]\nspeed_mm_s = [0.2, 2.0]\napproach_tilt_deg = [-5, 5]\n");
  ASSERT_TRUE(study) << study.error().message;
  EXPECT_EQ(study->size(), 12u);
  std::set<std::string> speeds;
  for (std::size_t k = 0; k < study->size(); ++k) {
    const StudyCase one = study->caseAt(k);
    EXPECT_EQ(valueOf(one, "speed_mm_s"), valueOf(study->caseAt(k / 4 * 4), "speed_mm_s"));
    speeds.insert(valueOf(one, "speed_mm_s"));
    const auto parameters = study->parametersOf(one);
    ASSERT_TRUE(parameters) << parameters.error().message;
    const std::string text = valueOf(one, "speed_mm_s");
    double written = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), written);
    EXPECT_NEAR(parameters->speed.si() * 1e3, written, 1e-12);
    EXPECT_GE(written, 0.2);
    EXPECT_LE(written, 2.0);
  }
  EXPECT_EQ(speeds.size(), 3u);  // a stratum for each cochlea
}

TEST(Study, SaysOfWhichPatientsTheMeasuresWereChangedAndThenWhichHaveNoSeal)
{
  const test::TemporaryFolder folder;
  const auto keep = [&folder](const std::string& name, const std::string& software,
                              const std::string& from = "", const std::string& to = "") {
    anatomy::Patient patient;
    patient.label = name;
    patient.basalTurn = anatomy::BasalTurn{millimeters(9.2), millimeters(6.8), std::nullopt};
    patient.origin.software = software;
    std::string text = patientText(patient);
    if (!from.empty()) text.replace(text.find(from), from.size(), to);
    ASSERT_TRUE(writeWhole(folder / (name + ".toml"), text));
  };
  const std::string seal = std::string(sealKey) + " = ";
  keep("intact", "perilymph 0.3.0");
  keep("older", "perilymph 0.2.0", seal, "# ");
  keep("typed", "", seal, "# ");
  keep("resized", "perilymph 0.3.0", "9.2", "9.3");
  keep("unsealed", "perilymph 0.3.0", seal, "# ");
  const auto study = parseStudy(R"(
title = "Five patients"
scenario = "mean-flex28"
[cochleae]
patients = ["intact.toml", "older.toml", "typed.toml", "resized.toml", "unsealed.toml"]
)",
                                folder / "study.toml");
  ASSERT_TRUE(study) << study.error().message;
  const auto begins = [](const char* text) { return testing::StartsWith(text); };
  EXPECT_THAT(study->notes(),
              testing::ElementsAre(begins("The measures of resized were changed by hand"),
                                   begins("The measures of unsealed were changed by hand"),
                                   begins("The measures of older carry no seal")));
  std::vector<std::string> names;
  for (const StudyCochlea& each : study->cochleae()) names.push_back(each.name);
  EXPECT_THAT(names, testing::ElementsAre("intact.toml", "older.toml", "typed.toml",
                                          "resized.toml (measures changed by hand)",
                                          "unsealed.toml (measures changed by hand)"));
  EXPECT_TRUE(study->parametersOf(study->caseAt(3))) << "the file keeps its name";
}

TEST(Study, HasCasesThatAreWrittenOut)
{
  const auto study = read(R"(
title = "two techniques"
scenario = "mean-flex28"
[cochleae]
mean = true
[[case]]
speed_mm_s = 0.5
friction = "tissue"
[[case]]
speed_mm_s = 1.5
)");
  ASSERT_TRUE(study) << study.error().message;
  ASSERT_EQ(study->size(), 2u);
  EXPECT_EQ(valueOf(study->caseAt(0), "friction"), "tissue");
  EXPECT_EQ(valueOf(study->caseAt(1), "speed_mm_s"), "1.5");
}

TEST(Study, HasAnotherFingerprintWithAnotherArray)
{
  const auto a = read(small);
  std::string text(small);
  text.replace(text.find("flex24"), 6, "hifocus-slimj");
  const auto b = read(text);
  ASSERT_TRUE(a) << a.error().message;
  ASSERT_TRUE(b) << b.error().message;
  EXPECT_NE(a->fingerprint(), b->fingerprint());
  EXPECT_EQ(a->fingerprint(), read(small)->fingerprint());
}

// Before the first combination is made: these would take gigabytes and minutes.
TEST(Study, BoundsItsCombinationsBeforeItMakesThem)
{
  const auto list = [](const std::string& key, int count) {
    std::string text = key + " = [";
    for (int i = 0; i < count; ++i) text += (i > 0 ? ", " : "") + std::to_string(1.0 + 0.001 * i);
    return text + "]\n";
  };
  const auto cases = [](int count) {
    std::string text;
    for (int i = 0; i < count; ++i)
      text += "[[case]]\nstart_inside_mm = " + std::to_string(1.0 + 0.0001 * i) + "\n";
    return text;
  };
  const std::string head =
      "title = \"x\"\nscenario = \"mean-flex28\"\n[cochleae]\nmean = true\n[vary]\n";
  // the smallest first: without a bound the others take all memory
  for (const std::string& text : {list("speed_mm_s", 101) + cases(100), list("speed_mm_s", 10'001),
                                  cases(10'001), list("speed_mm_s", 3000) + list("dt_ms", 300),
                                  list("speed_mm_s", 3000) + list("dt_ms", 300) + cases(200)})
    ASSERT_THAT(refusal(head + text), testing::AllOf(HasSubstr("10000"), HasSubstr("ivide")))
        << text.substr(0, 60);
  EXPECT_TRUE(read(head + list("speed_mm_s", 20) + cases(5)));
}

TEST(Study, RefusesWhatItCannotRunInOneSentence)
{
  const std::string text(small);
  EXPECT_THAT(refusal(text + "anatomy = [\"mean\"]\n"), HasSubstr("'vary.anatomy' is not allowed"));
  EXPECT_THAT(refusal(text + "speed_mm_s = [1.0, 900.0]\n"),
              testing::AllOf(HasSubstr("speed_mm_s=900"), HasSubstr("between 0.01 and 200")));
  EXPECT_THAT(refusal(text + "sped_mm_s = [1.0]\n"), HasSubstr("sped_mm_s"));
  EXPECT_THAT(refusal(text + "speed_mm_s = []\n"), HasSubstr("at least one"));
  EXPECT_THAT(refusal(text + "stop_travel_mm = [10.0]\n"), HasSubstr("depth = \"scenario\""));
  EXPECT_THAT(refusal(text + "[ranges]\nspeed_mm_s = [2.0, 0.2]\n"),
              HasSubstr("goes from 2 to 0.2; the first must be the lower end"));
  EXPECT_THAT(refusal("samples = 5\n" + text), HasSubstr("needs a range"));
  EXPECT_THAT(refusal("title = \"x\"\nscenario = \"mean-flex28\"\n"), HasSubstr("no cochlea"));
  EXPECT_THAT(refusal("title = \"x\"\nscenario = \"contour-published\"\n[cochleae]\nvirtual = 3\n"),
              HasSubstr("anatomy"));
  EXPECT_THAT(refusal("title = \"x\"\nscenario = \"none-such\"\n[cochleae]\nmean = true\n"),
              HasSubstr("none-such"));
  EXPECT_THAT(refusal(text + "[cochleae2]\n"), HasSubstr("cochleae2"));
}

TEST(Study, CountsNoInsertionTwice)
{
  const std::string text(small);
  for (const std::string twice :
       {"speed_mm_s = [1.0, 0.5, 1.0]\n",
        "[[case]]\nspeed_mm_s = 1.0\n[[case]]\nspeed_mm_s = 1.0\n",
        "[[case]]\nspeed_mm_s = 1.0\nnodes = 40\n[[case]]\nnodes = 40\nspeed_mm_s = 1.0\n"})
    EXPECT_THAT(refusal(text + twice),
                testing::AllOf(HasSubstr("speed_mm_s=1"), HasSubstr("stand twice")))
        << twice;
  EXPECT_TRUE(read(text + "[[case]]\nspeed_mm_s = 1.0\n[[case]]\nnodes = 40\n"));
  EXPECT_THAT(refusal("title = \"x\"\nscenario = \"mean-flex28\"\n[cochleae]\npatients = "
                      "[\"one.toml\", \"two.toml\", \"one.toml\"]\n"),
              HasSubstr("one.toml stands twice"));
}

TEST(Study, RefusesARangeOfWhatIsListed)
{
  const std::string text(small), range = "[ranges]\nspeed_mm_s = [0.2, 2.0]\n";
  for (const std::string list : {"speed_mm_s = [1.0, 0.5]\n", "[[case]]\nspeed_mm_s = 1.0\n"})
    EXPECT_THAT(
        refusal(text + list + range),
        testing::AllOf(HasSubstr("'speed_mm_s' has values in [ranges]"), HasSubstr("Remove one")))
        << list;
  EXPECT_TRUE(read(text + range));
}

TEST(Study, SaysThatTheCochleaOfItsScenarioIsNotUsed)
{
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeWhole(folder / "own.toml", "a_mm = 9.2\nb_mm = 6.8\n"));
  const auto scenario = session::loadScenario("mean-flex28", {{"patient", folder / "own.toml"}});
  ASSERT_TRUE(scenario) << scenario.error().message;
  ASSERT_TRUE(writeWhole(folder / "of-patient.toml", scenario->text()));
  const auto notesOf = [&folder](const std::string& name) {
    const auto study =
        parseStudy("title = \"x\"\nscenario = \"" + name + "\"\n[cochleae]\nmean = true\n",
                   folder / "study.toml");
    EXPECT_TRUE(study) << study.error().message;
    return study->notes();
  };
  EXPECT_THAT(notesOf("mean-flex28"), testing::IsEmpty());
  EXPECT_THAT(notesOf("of-patient.toml"),
              testing::ElementsAre(HasSubstr("The scenario is of a patient")));
}

TEST(Study, HasAnotherFingerprintIfALineMovesToTheNextPatient)
{
  const test::TemporaryFolder folder;
  const auto fingerprintOf = [&folder](const std::string& first, const std::string& second) {
    EXPECT_TRUE(writeWhole(folder / "1.toml", first) && writeWhole(folder / "2.toml", second));
    const auto study = parseStudy(
        "title = \"Two\"\nscenario = \"mean-flex28\"\n[cochleae]\npatients = [\"1.toml\", "
        "\"2.toml\"]\n",
        folder / "study.toml");
    EXPECT_TRUE(study) << study.error().message;
    return study->fingerprint();
  };
  const std::string one = "a_mm = 9.2\nb_mm = 6.8\n", ear = "side = \"left\"\n";
  EXPECT_NE(fingerprintOf(one + ear, one), fingerprintOf(one, ear + one));
}

TEST(Study, HasATitleOfOneLine)
{
  std::string text(small);
  const std::string title = "Length and friction";
  text.replace(text.find(title), title.size(), "a\\n# b\\u001b[31m");
  const auto study = read(text);
  ASSERT_TRUE(study) << study.error().message;
  EXPECT_EQ(study->title(), "a # b [31m");
}

TEST(Study, RefusesAPatientThatIsNotThere)
{
  EXPECT_THAT(refusal("title = \"x\"\nscenario = \"mean-flex28\"\n[cochleae]\npatients = "
                      "[\"nobody.toml\"]\n"),
              HasSubstr("nobody.toml"));
}

}  // namespace
}  // namespace perilymph::study
