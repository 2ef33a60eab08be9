// SPDX-License-Identifier: BSD-3-Clause

// Every pair of statements of a DICOM file or series, made to differ by 1 %, 5 %, a factor of 10 and of 1000:
// none is accepted without a word.

#include <gmock/gmock.h>

#include <fstream>
#include <functional>
#include <map>

#include "DicomStatementCases.h"
#include "dicom/DicomStatements.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/imaging/MeasuredPatient.h"
#include "perilymph/test/Places.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::imaging {
namespace {

class DicomStatements : public testing::Test {
protected:
  Result<LoadedCt> read(const Files& files, const std::string& syntax = "1.2.840.10008.1.2.1")
  {
    const auto place = folder / std::to_string(++count);
    std::filesystem::create_directories(place);
    for (std::size_t i = 0; i < files.size(); ++i)
      std::ofstream(place / ("IM" + std::to_string(i)), std::ios::binary) << files[i].file(syntax);
    auto loaded = readCt(place);
    if (loaded) expectWorded(loaded->series.warnings);
    return loaded;
  }

  /// Whether an answer names a pair.
  static bool names(const Result<LoadedCt>& loaded, const StatedTwice& pair)
  {
    const auto has = [&pair](const std::string& text) {
      return text.find(pair.second) != std::string::npos;
    };
    if (!loaded) return has(loaded.error().message);
    return std::any_of(loaded->series.warnings.begin(), loaded->series.warnings.end(), has);
  }

  test::TemporaryFolder folder;
  int count = 0;
};

TEST_F(DicomStatements, ThatAgreeAreReadWithoutAWord)
{
  for (const Files& files : {statedSlices(), Files{statedFrames()}}) {
    const auto loaded = read(files);
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_THAT(loaded->volume.provenance().notes, testing::IsEmpty());
    EXPECT_FALSE(loaded->volume.provenance().isInDoubt);
    ASSERT_EQ(loaded->series.warnings.size(), 1u) << loaded->series.warnings.back();
    EXPECT_THAT(loaded->series.warnings.front(), HasSubstr("Small field of view"));
  }
}

TEST_F(DicomStatements, OfTheRealWorldThatAgreeAreReadWithoutAWord)
{
  const auto loaded = read(realWorld(1.0, -1024.0));
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_FALSE(loaded->volume.provenance().isInDoubt);
}

TEST_F(DicomStatements, OfTheSideReachTheMeasurement)
{
  Files slices = statedSlices();
  EXPECT_EQ(read(slices)->volume.provenance().side, anatomy::Side::right);
  for (DicomData& slice : slices) {
    slice.setText(tags::laterality, "CS", "L");
    slice.setText(tags::imageLaterality, "CS", "");
  }
  EXPECT_EQ(read(slices)->volume.provenance().side, anatomy::Side::left);
  slices[4].setText(tags::laterality, "CS", "R");
  EXPECT_EQ(read(slices)->volume.provenance().side, std::nullopt);
}

TEST_F(DicomStatements, ThatDifferAreRefusedOrNamed)
{
  const std::string lossless = "1.2.840.10008.1.2.4.70";
  for (const Case& one : cases())
    for (const double factor : factors) {
      const bool isCompressed =
          one.pair == &dicomPairs::framesAndFragments || one.pair == &dicomPairs::framesAndOffsets;
      const auto loaded = read(one.make(factor), isCompressed ? lossless : "1.2.840.10008.1.2.1");
      const std::string which = std::string(one.pair->second) + " x " + std::to_string(factor);
      EXPECT_EQ(static_cast<bool>(loaded), one.pair->answer == Disagreement::warn)
          << which << (loaded ? "" : ": " + loaded.error().message);
      // a number of frames beyond the groups may also be beyond the file
      const bool isCut = !loaded && loaded.error().message.find("cut off") != std::string::npos;
      EXPECT_TRUE(names(loaded, *one.pair) || isCut)
          << which << ": " << (loaded ? "read in silence" : loaded.error().message);
      if (loaded) {
        EXPECT_THAT(loaded->volume.provenance().notes, testing::Not(testing::IsEmpty())) << which;
        EXPECT_TRUE(loaded->volume.provenance().isInDoubt) << which;
      }
    }
}

TEST_F(DicomStatements, AllHaveACase)
{
  std::map<std::string, int> tried;
  for (const Case& one : cases()) ++tried[std::string(one.pair->second) + one.pair->quantity];
  for (const StatedTwice& pair : allDicomPairs())
    EXPECT_GT(tried[std::string(pair.second) + pair.quantity], 0) << pair.second;
}

TEST(DicomStatementTable, IsThatOfTheGuide)
{
  const auto page = readWhole(test::projectFolder() / "resources/guide/dicom.md");
  ASSERT_TRUE(page) << page.error().message;
  std::string listed;
  for (const StatedTwice& pair : allDicomPairs()) listed += rowOf(pair) + "\n";
  EXPECT_THAT(*page,
              HasSubstr("|---|---|---|---|---|---|\n" + listed + "<!-- /statements of DICOM -->"));
}

TEST_F(DicomStatements, InDoubtReachThePatientFile)
{
  const auto loaded = read(scaledNumber(tags::spacingBetween, 0.6, 1.05));
  ASSERT_TRUE(loaded) << loaded.error().message;
  ct::CochleaMeasures measures{};
  measures.a.value = 9.2;
  measures.b.value = 6.8;
  measures.h.value = 3.9;
  measures.provenance = loaded->volume.provenance();
  const auto file = folder / "patient.toml";
  const auto done = writeMeasuredPatient(measures, "ear", file);
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_THAT(*readWhole(file),
              HasSubstr("# Of the CT: The series states the step of slice 1 of 10 "
                        "(IM0) twice: 0.6 mm in"));
}

// What has no tolerance of one pair: thickness is another quantity than the step, and says whether all was measured.
TEST_F(DicomStatements, OfThicknessSayWhereNothingWasMeasured)
{
  for (const double factor : {0.99, 0.95, 0.1, 0.001}) {
    const auto loaded = read(scaledNumber(tags::thickness, 0.6, factor));
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_THAT(loaded->series.warnings, testing::Contains(HasSubstr("was not measured")))
        << factor;
  }
  for (const double factor : {10.0, 1000.0}) {
    const auto loaded = read(scaledNumber(tags::thickness, 0.6, factor));
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_THAT(loaded->series.warnings, testing::Contains(HasSubstr("overlap so much"))) << factor;
  }
  const auto usual = read(scaledNumber(tags::thickness, 0.6, 2.0));
  ASSERT_TRUE(usual);
  EXPECT_EQ(usual->series.warnings.size(), 1u);
}

TEST_F(DicomStatements, OfGrayValuesMayCountPaddingOrNot)
{
  const ct::CtVolume volume = smoothCt();
  Files slices = statedSlices(volume);
  for (std::size_t k = 0; k < slices.size(); ++k) {
    std::vector<std::uint16_t> values;
    for (int at = 0; at < 400; ++at)
      values.push_back(static_cast<std::uint16_t>(
          at < 40 ? 0 : volume.voxel(at % 20, at / 20, static_cast<int>(k)) + 1024));
    slices[k].setPixels(values);
    slices[k].setNumber(tags::padding, 0);
    if (k % 2 == 0) slices[k].setNumber(tags::smallest, 0);
  }
  const auto loaded = read(slices);
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->series.warnings.size(), 1u) << loaded->series.warnings.back();
}

TEST_F(DicomStatements, OfThePatientsPositionAreOneInASeries)
{
  Files slices = statedSlices();
  for (std::size_t k = 5; k < slices.size(); ++k)
    slices[k].setText(tags::patientPosition, "CS", "HFP");
  const auto loaded = read(slices);
  EXPECT_TRUE(!loaded || loaded->series.warnings.size() > 1);
}

// Lengths that the positions alone state of one slice must be those of the others.
TEST_F(DicomStatements, OfOneSliceAreThoseOfTheOthers)
{
  const struct {
    test::DicomTag tag;
    std::vector<double> values;
  } tags[] = {{tags::pixelSpacing, {0.4, 0.4}},
              {tags::position, {-30.0, 12.0, -397.6}},
              {tags::orientation, {1, 0, 0, 0, 1, 0}},
              {tags::diameter, {8.0}},
              {tags::thickness, {0.6}}};
  for (const auto& [tag, values] : tags)
    for (std::size_t i = 0; i < values.size(); ++i)
      for (const double factor : factors) {
        if (values[i] == 0.0) continue;
        Files slices = statedSlices();
        auto scaled = values;
        scaled[i] *= factor;
        slices[4].setNumbers(tag, scaled);
        const auto loaded = read(slices);
        EXPECT_TRUE(!loaded || loaded->series.warnings.size() > 1)
            << std::hex << tag << " value " << i << " x " << factor;
      }
}

}  // namespace
}  // namespace perilymph::imaging
