// SPDX-License-Identifier: BSD-3-Clause

// The seal of a patient's file.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::anatomy {
namespace {

using testing::HasSubstr;

class PatientSeal : public testing::Test {
protected:
  Result<Patient> load(const std::string& text)
  {
    std::ofstream(file_) << text;
    return loadPatient(file_);
  }

  const test::TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "p.toml";
};

Patient measuredBy(const std::string& program)
{
  Patient patient;
  patient.label = "P-017";
  patient.basalTurn = BasalTurn{millimeters(9.3), millimeters(6.75), millimeters(4.0)};
  patient.errors = BasalTurnErrors{millimeters(0.15), millimeters(0.09), millimeters(0.2), 0.25};
  patient.origin = {program, std::string(64, 'a'), "RW", "A, B"};
  return patient;
}

TEST_F(PatientSeal, HasASealThatHoldsForItsValuesAlone)
{
  ASSERT_TRUE(savePatient(measuredBy("perilymph 0.3.0"), file_));
  EXPECT_EQ(loadPatient(file_)->seal, Seal::intact);
  EXPECT_EQ(noteOn(*loadPatient(file_)), "");
  const std::string text = *readWhole(file_);
  EXPECT_EQ(load("# a remark\n" + text + "\n# another\n")->seal, Seal::intact);
  std::size_t begin = 0, changed = 0;
  while (begin < text.size()) {  // each line, with another digit or letter in its value
    const std::size_t end = text.find('\n', begin);
    for (std::size_t i = text.find("= ", begin) + 2; i < end; ++i)
      for (const char other : {'1', '8'}) {
        std::string written = text;
        written[i] = other;
        if (written == text) continue;
        const auto patient = load(written);
        if (!patient) continue;
        EXPECT_EQ(patient->seal, Seal::changed) << written;
        EXPECT_EQ(statedSeries(*patient), "") << written;
        EXPECT_THAT(noteOn(*patient), HasSubstr("were changed by hand"));
        ++changed;
      }
    const auto without = load(text.substr(0, begin) + text.substr(end + 1));
    EXPECT_TRUE(!without || without->seal == Seal::changed || patientText(*without) == text)
        << "without " << text.substr(begin, end - begin);
    begin = end + 1;
  }
  EXPECT_GT(changed, 150u);
}

TEST_F(PatientSeal, IsOverTextsOnOneLine)
{
  const std::string text = patientText(measuredBy("perilymph 0.3.0"));
  const auto place = text.find("A, B");
  ASSERT_NE(place, std::string::npos);
  for (const char* white : {"\t", "\\t", "\\n"}) {
    const auto read = load(std::string(text).replace(place + 2, 1, white));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->seal, Seal::intact);
    EXPECT_EQ(read->origin.landmarksProposed, "A, B");
  }
}

TEST_F(PatientSeal, ThatWasChangedGetsNoNewSealByWritingItAgain)
{
  Patient patient = measuredBy("perilymph 0.3.0");
  std::string text = patientText(patient);
  text.replace(text.find("a_mm = 9.3"), 10, "a_mm = 9.9");
  for (int i = 0; i < 3; ++i) {
    const auto read = load(text);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->seal, Seal::changed);
    EXPECT_EQ(read->basalTurn->a, millimeters(9.9));
    text = patientText(*read);
  }
}

TEST_F(PatientSeal, WithoutASealIsTakenByTheProgramThatItNames)
{
  const auto unsealed = [this](const std::string& program) {
    Patient patient = measuredBy(program);
    patient.seal = Seal::absent;
    return *load(patientText(patient));
  };
  for (const char* sealing : {"perilymph 0.3.0-dev+1a2b", "perilymph 0.4.1", ""})
    EXPECT_EQ(unsealed(sealing).seal, Seal::changed) << sealing;
  for (const char* other : {"perilymph 0.2.0+1a2b", "perilymph 0.2", "Other 7.1"}) {
    const Patient patient = unsealed(other);
    EXPECT_EQ(patient.seal, Seal::absent) << other;
    EXPECT_EQ(statedSeries(patient), std::string(64, 'a'));
    EXPECT_THAT(noteOn(patient), HasSubstr("carry no seal"));
    EXPECT_EQ(load(patientText(patient))->seal, Seal::absent) << "written again";
  }
  const auto typed = load("a_mm = 9.3\nb_mm = 6.75\n");  // by a person, who states no origin
  EXPECT_EQ(typed->seal, Seal::absent);
  EXPECT_EQ(noteOn(*typed), "");
}

}  // namespace
}  // namespace perilymph::anatomy
