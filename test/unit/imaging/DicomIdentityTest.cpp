// SPDX-License-Identifier: BSD-3-Clause

// Whose images make a volume: those of one patient, study, frame of reference and reconstruction.

#include <gmock/gmock.h>

#include "StatedSeries.h"
#include "perilymph/imaging/AcquisitionDay.h"

namespace perilymph::imaging {
namespace {

using test::DicomData;
using testing::Contains;
using testing::HasSubstr;

class DicomIdentity : public ChangedSeries {
protected:
  static void expectNoPatient(const std::string& text)
  {
    for (const char* const secret : {"Secretname", "SECRETID", "19010203", "OTHERID", "Othername"})
      EXPECT_THAT(text, testing::Not(HasSubstr(secret)));
  }
};

TEST_F(DicomIdentity, OfASliceIsNotThatOfAnother)
{
  for (const auto& [from, to] : {std::pair{3, 4}, std::pair{0, 9}, std::pair{7, 2}}) {
    Files copied = slices;
    DicomData copy = slices[static_cast<std::size_t>(from)];
    copy.setNumbers(tags::position, {-30.0, 12.0, -400.0 + 0.6 * to});
    copy.setNumbers(tags::location, {-400.0 + 0.6 * to});
    copied[static_cast<std::size_t>(to)] = copy;
    const auto loaded = read(copied);
    ASSERT_TRUE(loaded) << loaded.error().message;
    const std::string both = "Slices " + std::to_string(std::min(from, to) + 1) + " and " +
                             std::to_string(std::max(from, to) + 1) + " of 10";
    EXPECT_THAT(loaded->series.warnings, Contains(HasSubstr(both)));
    EXPECT_TRUE(loaded->volume.provenance().isInDoubt);
  }
}

TEST_F(DicomIdentity, IsOfOnePatientAndStudy)
{
  const struct {
    test::DicomTag tag;
    const char* type;
    const char* value;
  } others[] = {{tags::patientId, "LO", "OTHERID"}, {tags::study, "UI", "1.2.77"}};
  for (const auto& other : others) {
    Files files = statedSlices();
    // the upper half is of somebody else, whose slices go on where the first ones end
    for (std::size_t k = 5; k < files.size(); ++k)
      files[k].setText(other.tag, other.type, other.value);
    const auto place = write(files);
    const auto list = findSeries(place);
    ASSERT_TRUE(list) << list.error().message;
    ASSERT_EQ(list->series.size(), 2u);
    for (const CtSeries& series : list->series) {
      EXPECT_EQ(series.size[2], 5) << series.obstacle;
      EXPECT_THAT(series.uid, testing::StartsWith("1.2.3.4#"));
      EXPECT_THAT(series.warnings,
                  Contains(HasSubstr("5 of 10 images with its series number are of "
                                     "another patient or study")));
      for (const std::string& warning : series.warnings) expectNoPatient(warning);
    }
    EXPECT_NE(list->series[0].uid, list->series[1].uid);
    EXPECT_NE(list->series[0].key, list->series[1].key);
    const auto either = readCt(place, "1.2.3.4");
    ASSERT_FALSE(either) << "one number, two patients";
    EXPECT_THAT(either.error().message, HasSubstr("1.2.3.4#1"));
    for (const char* const uid : {"1.2.3.4#1", "1.2.3.4#2"}) {
      const auto loaded = readCt(place, uid);
      ASSERT_TRUE(loaded) << loaded.error().message;
      EXPECT_EQ(loaded->volume.size()[2], 5);
      EXPECT_THAT(loaded->volume.provenance().notes,
                  Contains(HasSubstr("another patient or study")));
    }
  }
}

TEST_F(DicomIdentity, OfTwoWholePatientsIsWarnedOfInOneFolder)
{
  Files both = statedSlices(smoothCt(), "1.2.3.4");
  Files second = statedSlices(smoothCt(), "1.2.3.5");
  for (DicomData& slice : second) {
    slice.setText(tags::patientId, "LO", "OTHERID");
    slice.setText(tags::study, "UI", "1.2.78");
  }
  both.insert(both.end(), second.begin(), second.end());
  const auto place = write(both);
  const auto loaded = readCt(place, "1.2.3.5");
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_THAT(loaded->series.warnings, Contains(HasSubstr("images of 2 patients")));
  EXPECT_EQ(loaded->series.uid, "1.2.3.5");
}

TEST_F(DicomIdentity, IsRefusedWhereThePatientsAttributesDiffer)
{
  const struct {
    test::DicomTag tag;
    const char* type;
    const char* value;
    const char* name;
  } others[] = {{tags::sex, "CS", "M", "PatientSex (0010,0040)"},
                {tags::birthDate, "DA", "19010204", "PatientBirthDate (0010,0030)"},
                {tags::patientName, "PN", "Othername^Patient", "PatientName (0010,0010)"}};
  for (const auto& other : others) {
    Files files = statedSlices();
    files[6].setText(other.tag, other.type, other.value);
    const auto loaded = readCt(write(files));
    ASSERT_FALSE(loaded) << other.name;
    EXPECT_THAT(loaded.error().message, HasSubstr(std::string("differ in ") + other.name));
    expectNoPatient(loaded.error().message);
    // what is absent contradicts nothing
    files[6].setText(other.tag, other.type, "");
    const auto without = readCt(write(files));
    EXPECT_TRUE(without) << without.error().message;
  }
  // the same name, padded otherwise
  Files files = statedSlices();
  files[6].setText(tags::patientName, "PN", "Secretname^Patient^^ ");
  EXPECT_TRUE(readCt(write(files)));
}

TEST_F(DicomIdentity, IsOfOneFrameOfReference)
{
  Files files = statedSlices();
  Files later = statedSlices();
  later.resize(4);
  for (DicomData& slice : later) slice.setText(tags::frameOfReference, "UI", "1.2.3.100");
  files.insert(files.end(), later.begin(), later.end());
  const auto loaded = readCt(write(files), "1.2.3.4");
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->volume.size()[2], 10);
  EXPECT_THAT(loaded->series.warnings,
              Contains(HasSubstr("4 of 14 images with its series number are of another frame of "
                                 "reference")));
}

TEST_F(DicomIdentity, IsOfOneReconstruction)
{
  // two reconstructions of one series, interleaved by half a step
  const auto fine = smoothCt({20, 20, 20}, {0.4, 0.4, 0.3});
  const struct {
    test::DicomTag tag;
    const char* type;
    const char* value;
    const char* name;
  } settings[] = {{tags::acquisition, "IS", "7", "AcquisitionNumber (0020,0012)"},
                  {tags::diameter, "DS", "8.0001", "ReconstructionDiameter (0018,1100)"},
                  {tags::imageType, "CS", "ORIGINAL\\SECONDARY\\AXIAL", "ImageType (0008,0008)"},
                  {tags::kvp, "DS", "80", "KVP (0018,0060)"},
                  {tags::filter, "SH", "BODY", "FilterType (0018,1160)"},
                  {tags::thickness, "DS", "0.61", "SliceThickness (0018,0050)"},
                  {tags::kernel, "SH", "Br40", "reconstruction kernels"}};
  for (const auto& setting : settings) {
    Files files = statedSlices(fine);
    for (std::size_t k = 1; k < files.size(); k += 2)
      files[k].setText(setting.tag, setting.type, setting.value);
    const auto loaded = readCt(write(files));
    ASSERT_FALSE(loaded) << setting.name;
    EXPECT_THAT(loaded.error().message, HasSubstr(setting.name));
  }
  // an acquisition may follow another, as axial scanners count them
  Files axial = statedSlices();
  for (std::size_t k = 0; k < axial.size(); ++k)
    axial[k].setText(tags::acquisition, "IS", std::to_string(1 + k / 2));
  for (DicomData& slice : axial) slice.setText(tags::imagesInAcquisition, "IS", "2");
  const auto loaded = readCt(write(axial));
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_THAT(loaded->volume.provenance().notes, testing::IsEmpty());
}

TEST_F(DicomIdentity, NamesASliceOfAnotherScannerSideOrUnit)
{
  const struct {
    test::DicomTag tag;
    const char* type;
    const char* value;
    const char* name;
  } settings[] = {
      {tags::manufacturer, "LO", "Another", "Manufacturer (0008,0070)"},
      {tags::bodyPart, "CS", "FOOT", "BodyPartExamined (0018,0015)"},
      {tags::laterality, "CS", "L", "Laterality (0020,0060)"},
      {tags::rescaleType, "LO", "OD", "RescaleType (0028,1054)"},
      {tags::studyDate, "DA", "20260102", "StudyDate (0008,0020)"},
      {tags::photometric, "CS", "MONOCHROME1", "PhotometricInterpretation (0028,0004)"}};
  for (const auto& setting : settings) {
    Files files = statedSlices();
    files[6].setText(setting.tag, setting.type, setting.value);
    const auto loaded = readCt(write(files));
    ASSERT_TRUE(loaded) << setting.name << loaded.error().message;
    EXPECT_THAT(loaded->series.warnings,
                Contains(HasSubstr(std::string("Its slices differ in ") + setting.name)));
  }
}

TEST_F(DicomIdentity, StatesTheDayOfTheAcquisitionBeforeThatOfTheStudy)
{
  const auto dayOf = [this](const Files& files) -> std::string {
    const auto list = findSeries(write(files));
    if (!list) return list.error().message;
    EXPECT_EQ(list->series.size(), 1u);
    EXPECT_EQ(acquisitionDay(*list, "another"), "");
    return acquisitionDay(*list, list->series.front().uid);
  };
  const struct {
    const char *date, *dateTime, *series, *study, *day;
  } cases[] = {{"20260103", "20260104101500.5", "20260105", "20260106", "2026-01-03"},
               {"", "20260104101500.5", "20260105", "20260106", "2026-01-04"},
               {"20260230", "", "20260105", "20260106", "2026-01-05"},
               {"", "", "", "20260106", "2026-01-06"},
               {"3 Jan", "2026", "000000", "ANONYMOU", ""},
               {"", "", "", "", ""}};
  for (const auto& each : cases) {
    Files files = statedSlices();
    for (DicomData& slice : files) {
      slice.setText(tags::acquisitionDate, "DA", each.date);
      slice.setText(tags::acquisitionDateTime, "DT", each.dateTime);
      slice.setText(tags::seriesDate, "DA", each.series);
      slice.setText(tags::studyDate, "DA", each.study);
    }
    EXPECT_EQ(dayOf(files), each.day) << each.date << each.study;
  }
  // over midnight: the earlier one
  Files files = statedSlices();
  for (std::size_t k = 0; k < files.size(); ++k)
    files[k].setText(tags::acquisitionDate, "DA", k < 4 ? "20260104" : "20260103");
  EXPECT_EQ(dayOf(files), "2026-01-03");
  EXPECT_EQ(acquisitionDay(CtSeriesList(), "1.2.3.4"), "");
}

TEST_F(DicomIdentity, OfASliceWithoutAUnitIsThatOfHounsfieldUnits)
{
  Files files = statedSlices();
  for (DicomData& slice : files) slice.remove(tags::rescaleType);
  files[6].setText(tags::rescaleType, "LO", "HU");
  auto loaded = readCt(write(files));
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_THAT(loaded->series.warnings, testing::Not(Contains(HasSubstr("RescaleType"))));
  files[6].setText(tags::rescaleType, "LO", "US");
  loaded = readCt(write(files));
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_THAT(loaded->series.warnings,
              Contains(HasSubstr("Its slices differ in RescaleType (0028,1054)")));
}

TEST_F(DicomIdentity, OfAnImageIsNotThatOfAnother)
{
  Files files = statedSlices();
  files[7].setText(tags::instance, "UI", "1.2.3.4.3");
  const auto loaded = readCt(write(files));
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_THAT(loaded->series.warnings, Contains(HasSubstr("Slices 3 and 8 of 10 have one number")));
}

TEST_F(DicomIdentity, NamesFilesThatEndBeforeTheySayWhatTheyAre)
{
  for (const std::uintmax_t bytes : {0, 1, 100, 128, 132, 140, 300}) {
    const auto place = write(statedSlices());
    // the slice on top, whose absence leaves a regular stack
    const auto last = place / ("IM" + std::to_string(10 * 7919 % 100'003));
    std::filesystem::resize_file(last, bytes);
    const auto loaded = readCt(place);
    if (!loaded) continue;  // refused is a word as well
    EXPECT_EQ(loaded->volume.size()[2], 9);
    EXPECT_THAT(loaded->series.warnings, Contains(HasSubstr(last.filename().string()))) << bytes;
    EXPECT_THAT(loaded->volume.provenance().notes, Contains(HasSubstr("may be missing"))) << bytes;
  }
}

}  // namespace
}  // namespace perilymph::imaging
