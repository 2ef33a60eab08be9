// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/anatomy/Patient.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "perilymph/foundation/Resources.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::anatomy {
namespace {

using testing::HasSubstr;

class PatientFile : public testing::Test {
protected:
  Result<Patient> load(const std::string& text)
  {
    std::ofstream(file_) << text;
    return loadPatient(file_);
  }

  /// The error message for the text, without the folder.
  std::string error(const std::string& text)
  {
    const Result<Patient> patient = load(text);
    if (patient) return "fine";
    const std::string folder = folder_.path().string() + "/";
    const std::string& message = patient.error().message;
    return message.rfind(folder, 0) == 0 ? message.substr(folder.size()) : message;
  }

  const test::TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "p.toml";
};

TEST_F(PatientFile, GivesTheThreeNumbersAndTheSide)
{
  const Result<Patient> patient = load(
      "label = 'P 7'\nside = 'left'\nst_length_mm = 33.6\nrw_width_mm = 1.9\nrw_height_mm = 1.8\n");
  ASSERT_TRUE(patient) << patient.error().message;
  EXPECT_EQ(patient->label, "P 7");
  EXPECT_EQ(patient->side, Side::left);
  EXPECT_DOUBLE_EQ(patient->scalaTympaniLength.si(), 33.6e-3);
  EXPECT_DOUBLE_EQ(patient->roundWindowWidth.si(), 1.9e-3);
  EXPECT_DOUBLE_EQ(patient->roundWindowHeight.si(), 1.8e-3);
}

TEST_F(PatientFile, WithoutSideAndLabelIsARightEarNamedAfterItsFile)
{
  const Result<Patient> patient =
      load("st_length_mm = 33.6\nrw_width_mm = 1.9\nrw_height_mm = 1.8\n");
  ASSERT_TRUE(patient);
  EXPECT_EQ(patient->side, Side::right);
  EXPECT_EQ(patient->label, "p");
}

TEST_F(PatientFile, IsRefusedWithOneSentenceForEachError)
{
  EXPECT_EQ(error("rw_width_mm = 1.9\nrw_height_mm = 1.8\n"),
            "p.toml: key 'st_length_mm' is missing; it must be between 25 and 45.");
  EXPECT_EQ(error("st_length_mm = 3.56\nrw_width_mm = 1.9\nrw_height_mm = 1.8\n"),
            "p.toml:1: st_length_mm is 3.56; it must be between 25 and 45.");
  EXPECT_EQ(error("st_length_mm = 33\nrw_width_mm = 0.19\nrw_height_mm = 1.8\n"),
            "p.toml:2: rw_width_mm is 0.19; it must be between 1 and 3.");
  EXPECT_EQ(error("st_length_mm = 33\nrw_width_mm = 1.9\nrw_height_mm = 'x'\n"),
            "p.toml:3: rw_height_mm is 'x'; it must be a number, between 1 and 2.8.");
  EXPECT_EQ(error("st_length = 33\nrw_width_mm = 1.9\nrw_height_mm = 1.8\n"),
            "p.toml:1: unknown key 'st_length'; did you mean st_length_mm?");
  EXPECT_EQ(error("st_length_mm = 33\nrw_width_mm = 1.9\nrw_height_mm = 1.8\nside = 'up'\n"),
            "p.toml:4: side is 'up'; it must be one of right, left.");
  EXPECT_THAT(error("st_length_mm = 33\nrw_width_mm =\n"),
              HasSubstr("p.toml:2:14: this is not TOML: "));
}

TEST_F(PatientFile, GivesTheBasalTurnInstead)
{
  const Result<Patient> patient = load("a_mm = 9.1\nb_mm = 6.9\n");
  ASSERT_TRUE(patient) << patient.error().message;
  ASSERT_TRUE(patient->basalTurn);
  EXPECT_EQ(patient->basalTurn->a, millimeters(9.1));
  EXPECT_EQ(patient->basalTurn->b, millimeters(6.9));
  EXPECT_FALSE(patient->basalTurn->h);
}

TEST_F(PatientFile, GivesEitherLengthsOrTheBasalTurn)
{
  EXPECT_THAT(
      error("a_mm = 9.1\nb_mm = 6.9\nrw_width_mm = 1.9\n"),
      testing::AllOf(HasSubstr("p.toml:3"), HasSubstr("either"), HasSubstr("st_length_mm")));
  EXPECT_THAT(error("a_mm = 9.1\n"), HasSubstr("'b_mm' is missing"));
  EXPECT_THAT(error("a_mm = 9.1\nb_mm = 6.9\nh_mm = 9\n"), HasSubstr("between 2.3 and 4.8"));
}

TEST_F(PatientFile, WithADiameterThatNoCochleaHasIsRefusedWithThePopulation)
{
  // (11.2 - 9.23) / 0.428 = 4.6 standard deviations
  const std::string sentence = error("a_mm = 11.2\nb_mm = 6.9\n");
  for (const char* part : {"p.toml", "A (a_mm) is 11.2 mm", "4.6 standard deviations above", "9.23",
                           "SD 0.43", "between 7.52 and 10.94"})
    EXPECT_THAT(sentence, HasSubstr(part));
}

TEST(Patient, OfAnUnusualDiameterIsFlagged)
{
  Patient patient;
  EXPECT_TRUE(unusualMeasures(patient).empty());
  patient.basalTurn = BasalTurn{millimeters(9.0), millimeters(7.0), std::nullopt};
  EXPECT_TRUE(unusualMeasures(patient).empty());
  // (5.8 - 6.80) / 0.361 = -2.8 standard deviations
  patient.basalTurn->b = millimeters(5.8);
  ASSERT_EQ(unusualMeasures(patient).size(), 1u);
  EXPECT_THAT(unusualMeasures(patient).front(), HasSubstr("2.8 standard deviations below"));
  EXPECT_TRUE(checkPatient(patient));
}

TEST(Patient, WithAAndBThatDoNotGoTogetherIsFlagged)
{
  // Each within two standard deviations of its own mean. With the published half-diameters the
  // covariance of A and B is 0.1236 mm^2, the variance of A 0.1829 and of B 0.1303, so that B given
  // A = 9.9 mm is 6.80 + 0.1236 / 0.1829 (9.90 - 9.23) = 7.25 mm, SD sqrt(0.1303 - 0.1236^2 /
  // 0.1829) = 0.22 mm.
  Patient patient;
  patient.basalTurn = BasalTurn{millimeters(9.9), millimeters(7.2), std::nullopt};
  EXPECT_TRUE(unusualMeasures(patient).empty());
  patient.basalTurn->b = millimeters(6.3);
  ASSERT_EQ(unusualMeasures(patient).size(), 1u);
  EXPECT_THAT(unusualMeasures(patient).front(),
              testing::AllOf(HasSubstr("A and B do not match"), HasSubstr("usually 7.25 mm"),
                             HasSubstr("SD 0.22")));
}

TEST(PatientCode, HasLettersDigitsAndHyphens)
{
  for (const char* code : {"P-017", "a", "014", "ABCDEFGHIJKLMNOPQRSTUVWX"})
    EXPECT_TRUE(checkPatientCode(code)) << code;
  for (const char* code : {"", "P 017", "P-017 / Müller", "Müller", "P_017", "P.017", "../P",
                           "ABCDEFGHIJKLMNOPQRSTUVWXY"}) {
    const auto checked = checkPatientCode(code);
    ASSERT_FALSE(checked) << code;
    EXPECT_THAT(checked.error().message,
                testing::AllOf(HasSubstr(code), HasSubstr("letters"), HasSubstr("hyphens")));
  }
}

TEST(Patient, OfAHeightThatNoCochleaHasIsFlagged)
{
  Patient patient;
  for (const double h_mm : {2.4, 3.9, 4.7}) {
    patient.basalTurn = BasalTurn{millimeters(9.0), millimeters(7.0), millimeters(h_mm)};
    EXPECT_TRUE(unusualMeasures(patient).empty()) << h_mm;
  }
  for (const double h_mm : {1.2, 9.9}) {  // a flat spiral, a helix
    patient.basalTurn->h = millimeters(h_mm);
    ASSERT_EQ(unusualMeasures(patient).size(), 1u);
    EXPECT_THAT(unusualMeasures(patient).front(), HasSubstr("cochleae have 2.3 to 4.8 mm"));
  }
}

TEST_F(PatientFile, ThatIsMissingIsNamed)
{
  const Result<Patient> patient = loadPatient(folder_ / "no.toml");
  ASSERT_FALSE(patient);
  EXPECT_THAT(patient.error().message, HasSubstr("no.toml: there is no such file"));
}

TEST_F(PatientFile, ThatWasSavedReadsBackAsTheSamePatient)
{
  Patient lengths;
  lengths.label = "Frau \"Ü\" \\ 7\n";
  lengths.side = Side::left;
  lengths.scalaTympaniLength = millimeters(34.2);
  Patient turn;
  turn.label = "P 8";
  turn.basalTurn = BasalTurn{millimeters(9.3), millimeters(6.75), millimeters(4)};
  for (const Patient& saved : {lengths, turn}) {
    ASSERT_TRUE(savePatient(saved, file_));
    const Result<Patient> back = loadPatient(file_);
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(back->side, saved.side);
    EXPECT_EQ(back->scalaTympaniLength, saved.scalaTympaniLength);
    EXPECT_EQ(back->roundWindowWidth, saved.roundWindowWidth);
    ASSERT_EQ(back->basalTurn.has_value(), saved.basalTurn.has_value());
    if (!saved.basalTurn) continue;
    EXPECT_EQ(back->basalTurn->a, saved.basalTurn->a);
    EXPECT_EQ(back->basalTurn->b, saved.basalTurn->b);
    EXPECT_EQ(back->basalTurn->h, saved.basalTurn->h);
  }
  ASSERT_TRUE(savePatient(lengths, file_));
  EXPECT_EQ(loadPatient(file_)->label, "Frau \"Ü\" \\ 7 ");
}

TEST_F(PatientFile, CarriesTheErrorsAndTheOriginOfItsMeasures)
{
  const Result<Patient> patient = load(
      "a_mm = 9.3\nb_mm = 6.75\nh_mm = 4\na_sd_mm = 0.15\nb_sd_mm = 0.09\nh_sd_mm = 0.2\n"
      "measured_with = 'perilymph 0.2'\nseries_sha256 = 'ab12'\nlandmarks_by_hand = 'RW, A'\n"
      "landmarks_proposed = 'OW'\n");
  ASSERT_TRUE(patient) << patient.error().message;
  ASSERT_TRUE(savePatient(*patient, file_));
  const Result<Patient> back = loadPatient(file_);
  ASSERT_TRUE(back) << back.error().message;
  for (const Patient& each : {*patient, *back}) {
    ASSERT_TRUE(each.errors);
    EXPECT_EQ(each.errors->a, millimeters(0.15));
    EXPECT_EQ(each.errors->b, millimeters(0.09));
    EXPECT_EQ(each.errors->h, millimeters(0.2));
    EXPECT_EQ(each.origin.software, "perilymph 0.2");
    EXPECT_EQ(each.origin.seriesKey, "ab12");
    EXPECT_EQ(each.origin.landmarksByHand, "RW, A");
    EXPECT_EQ(each.origin.landmarksProposed, "OW");
  }
}

TEST_F(PatientFile, CarriesTheCorrelationsOfTheErrors)
{
  const std::string measures = "a_mm = 9.3\nb_mm = 6.75\nh_mm = 4.0\n";
  const std::string errors = "a_sd_mm = 0.15\nb_sd_mm = 0.09\nh_sd_mm = 0.2\n";
  const Result<Patient> patient =
      load(measures + errors + "ab_correlation = 0.5\nbh_correlation = -0.25\n");
  ASSERT_TRUE(patient) << patient.error().message;
  ASSERT_TRUE(savePatient(*patient, file_));
  const Result<Patient> back = loadPatient(file_);
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->errors->ab, 0.5);
  EXPECT_EQ(back->errors->ah, 0.0);
  EXPECT_EQ(back->errors->bh, -0.25);
  EXPECT_THAT(error(measures + errors + "ab_correlation = 1.0\n"),
              HasSubstr("ab_correlation) is 1; it must be between -1 and 1"));
  EXPECT_THAT(error(measures + errors +
                    "ab_correlation = 0.9\nah_correlation = 0.9\nbh_correlation = -0.9\n"),
              HasSubstr("contradict each other"));
}

TEST_F(PatientFile, WithoutErrorsStatesNone)
{
  const Result<Patient> patient = load("a_mm = 9.3\nb_mm = 6.75\n");
  ASSERT_TRUE(patient);
  EXPECT_FALSE(patient->errors);
}

TEST_F(PatientFile, WithHalfOfTheErrorsOrImpossibleOnesIsRefused)
{
  EXPECT_THAT(error("a_mm = 9.3\nb_mm = 6.75\na_sd_mm = 0.1\n"), HasSubstr("b_sd_mm"));
  EXPECT_THAT(error("a_mm = 9.3\nb_mm = 6.75\na_sd_mm = -0.1\nb_sd_mm = 0.1\n"),
              HasSubstr("a_sd_mm is -0.1"));
}

TEST(Patient, OfThePaperIsAllowed) { EXPECT_TRUE(checkPatient(Patient{})); }

TEST(Patient, WithAnErrorThatLeavesNoMeasurementIsRefusedByItsKey)
{
  Patient patient;
  patient.basalTurn = BasalTurn{millimeters(9.2), millimeters(6.8), std::nullopt};
  patient.errors = BasalTurnErrors{millimeters(0.0), millimeters(2.0), millimeters(0.1)};
  EXPECT_TRUE(checkPatient(patient));
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const double error_mm : {-0.01, 2.01, none}) {
    patient.errors->h = millimeters(error_mm);
    const auto checked = checkPatient(patient);
    ASSERT_FALSE(checked) << error_mm;
    EXPECT_THAT(checked.error().message, HasSubstr("h_sd_mm"));
  }
}

TEST(Patient, AtTheLimitsIsAllowedAndJustBeyondIsNot)
{
  const PatientLimits limits = patientLimits();
  Patient patient;
  patient.scalaTympaniLength = limits.lengthLow;
  patient.roundWindowWidth = limits.widthHigh;
  patient.roundWindowHeight = limits.heightHigh;
  EXPECT_TRUE(checkPatient(patient));
  patient.scalaTympaniLength = limits.lengthLow - millimeters(0.001);
  EXPECT_FALSE(checkPatient(patient));
}

TEST(Patient, OutOfTheLimitsIsNamedWithValueAndRange)
{
  Patient patient;
  patient.scalaTympaniLength = millimeters(46.5);
  const Result<void> done = checkPatient(patient);
  ASSERT_FALSE(done);
  EXPECT_EQ(
      done.error().message,
      "The length of the scala tympani (st_length_mm) is 46.5 mm; it must be between 25 and 45 "
      "mm.");
}

TEST(Patient, WithoutANumberIsRefused)
{
  Patient patient;
  patient.roundWindowWidth = Length::fromSi(std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(checkPatient(patient));
}

// Clinical series from the shortest (25.3 mm, Hardy 1938) to the longest duct (45 mm, Rivas 2017).
TEST(Patient, LimitsHoldEveryPublishedLength)
{
  const PatientLimits limits = patientLimits();
  EXPECT_LE(limits.lengthLow, millimeters(25.3));
  EXPECT_GE(limits.lengthHigh, millimeters(45.0));
}

TEST(Patient, LimitsHoldThreeStandardDeviationsOfTheSection)
{
  const double spread = 3.0 * 0.15;  // relative, Avci et al. 2014
  const PatientLimits limits = patientLimits();
  EXPECT_LE(inMillimeters(limits.widthLow), 1.94 * (1.0 - spread));
  EXPECT_GE(inMillimeters(limits.widthHigh), 1.94 * (1.0 + spread));
  EXPECT_LE(inMillimeters(limits.heightLow), 1.85 * (1.0 - spread));
  EXPECT_GE(inMillimeters(limits.heightHigh), 1.85 * (1.0 + spread));
}

TEST(Patient, AtEveryCornerOfTheLimitsHasAScalaTympani)
{
  const PatientLimits limits = patientLimits();
  for (const Length length : {limits.lengthLow, limits.lengthHigh})
    for (const Length width : {limits.widthLow, limits.widthHigh})
      for (const Length height : {limits.heightLow, limits.heightHigh}) {
        const Patient patient{"corner", Side::right, length, width, height};
        const auto scala = buildPublished(patient, millimeters(1.0));
        ASSERT_NE(scala, nullptr);
        EXPECT_GT(scala->section(0.0).area, 0.0);
        EXPECT_GT(scala->section(scala->lastAngle().si()).area, 0.0);
      }
}

TEST(ShippedPatients, AllLoad)
{
  const std::vector<std::string> names = shippedNames("resources/patients");
  EXPECT_GE(names.size(), 4u);
  for (const std::string& name : names) {
    const auto file = findByName("patient", "resources/patients", name);
    ASSERT_TRUE(file) << file.error().message;
    const Result<Patient> patient = loadPatient(*file);
    EXPECT_TRUE(patient) << patient.error().message;
  }
}

TEST(ShippedPatients, HaveThePaperAsTheirAverageAndALeftEar)
{
  const auto average = loadPatient(resource("resources/patients/average.toml"));
  ASSERT_TRUE(average) << average.error().message;
  const Patient paper;
  EXPECT_EQ(average->scalaTympaniLength, paper.scalaTympaniLength);
  EXPECT_EQ(average->roundWindowWidth, paper.roundWindowWidth);
  EXPECT_EQ(average->roundWindowHeight, paper.roundWindowHeight);
  const auto left = loadPatient(resource("resources/patients/left.toml"));
  ASSERT_TRUE(left) << left.error().message;
  EXPECT_EQ(left->side, Side::left);
}

}  // namespace
}  // namespace perilymph::anatomy
