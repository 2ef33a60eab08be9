// SPDX-License-Identifier: BSD-3-Clause

// A PDF in a DICOM object, read again by GDCM's gdcmdump.

#include "perilymph/imaging/EncapsulatedPdf.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <system_error>

#include "SmallCt.h"
#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/DicomWriter.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::imaging {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

PdfDocument document()
{
  // printf 1.2.840.99.1 | sha256sum
  return {"%PDF-1.4 a document of an odd number of bytes", "Insertion plan", "P-17", "0.1.0+test",
          "2a87a5a516859a3324f333db4edfe1e3e86e3fea8c2ef0af34b45a44f2a7438e"};
}

/// A CT of two slices of a patient with a name.
std::vector<test::DicomData> ctOf(const std::string& study, const std::string& patient)
{
  std::vector<test::DicomData> slices = test::dicomSlices(
      smallCt(Eigen::Matrix3d::Identity(), Eigen::Vector3d(0.3, 0.4, 0.6), {4, 4, 2}),
      study + ".1");
  for (test::DicomData& slice : slices) {
    slice.setText(0x00080005, "CS", "ISO_IR 100");
    slice.setText(0x00080020, "DA", "20250102");
    slice.setText(0x00080050, "SH", "ACC-9");
    slice.setText(0x00100010, "PN", "Doe^Jane");
    slice.setText(0x00100020, "LO", patient);
    slice.setText(0x00100030, "DA", "19700102");
    slice.setText(0x0020000D, "UI", study);
    slice.setText(0x00200010, "SH", "7");
  }
  return slices;
}

class EncapsulatedPdfFile : public testing::Test {
protected:
  fs::path file() const { return folder_ / "plan.dcm"; }

  std::string bytes() const
  {
    std::ifstream stream(file(), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  /// What GDCM's own reader prints of the file.
  std::string dump() const
  {
    try {
      return test::run({"gdcmdump", {file().string()}, {}, {}}).out;
    } catch (const std::system_error&) {
      return {};
    }
  }

  std::string uidOf(const std::string& tag) const
  {
    std::smatch found;
    const std::string text = dump();
    return std::regex_search(text, found, std::regex(tag + " UI \\[([0-9.]+)")) ? found[1].str()
                                                                                : std::string();
  }

  test::TemporaryFolder folder_;
};

TEST_F(EncapsulatedPdfFile, BecomesPartOfTheStudyOfTheCt)
{
  test::writeDicomFiles(ctOf("1.2.840.99", "MRN-4711"), folder_ / "ct");
  const auto written = writeEncapsulatedPdf(document(), folder_ / "ct", file());
  ASSERT_TRUE(written) << written.error().message;
  EXPECT_THAT(bytes(), HasSubstr(document().content));
  const std::string text = dump();
  if (text.empty()) GTEST_SKIP() << "Install the package libgdcm-tools.";
  for (const char* part :
       {"[1.2.840.10008.5.1.4.1.1.104.1]", "[Doe^Jane]", "[MRN-4711", "[19700102]", "[20250102]",
        "[ACC-9", "[1.2.840.99", "[ISO_IR 100]", "[DOC ]", "[application/pdf", "[Insertion plan]"})
    EXPECT_THAT(text, HasSubstr(part));
  EXPECT_THAT(text, Not(HasSubstr("[1.2.840.99.1")));  // a series of its own
}

TEST_F(EncapsulatedPdfFile, HasTheCodeAndNoNameWithoutACt)
{
  ASSERT_TRUE(writeEncapsulatedPdf(document(), std::nullopt, file()));
  const std::string text = dump();
  if (text.empty()) GTEST_SKIP() << "Install the package libgdcm-tools.";
  EXPECT_THAT(text, HasSubstr("[P-17"));
  EXPECT_THAT(text, HasSubstr("(0010,0010) PN (no value)"));
  EXPECT_THAT(text, Not(HasSubstr("Doe")));
}

TEST_F(EncapsulatedPdfFile, HasNewUidsEachTime)
{
  std::set<std::string> uids;
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(writeEncapsulatedPdf(document(), std::nullopt, file()));
    if (dump().empty()) GTEST_SKIP() << "Install the package libgdcm-tools.";
    for (const char* tag : {"\\(0008,0018\\)", "\\(0020,000d\\)", "\\(0020,000e\\)"})
      uids.insert(uidOf(tag));
  }
  EXPECT_EQ(uids.size(), 6u);
  EXPECT_EQ(uids.count(""), 0u);
}

TEST_F(EncapsulatedPdfFile, OfAnotherPersonsDataIsRefusedWithoutNamingAnyone)
{
  test::writeDicomFiles(ctOf("1.2.840.98", "MRN-4712"), folder_ / "ct");
  PdfDocument other = document();
  for (const bool isFiledWithoutSeries : {false, true}) {
    other.isFiledWithoutSeries = isFiledWithoutSeries;
    const auto written = writeEncapsulatedPdf(other, folder_ / "ct", file());
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().message, HasSubstr("is not the CT in which this was measured"));
    EXPECT_THAT(written.error().message, Not(HasSubstr("MRN")));
    EXPECT_FALSE(fs::exists(file()));
  }
}

TEST_F(EncapsulatedPdfFile, IsComparedWithEverySeriesOfTheStudy)
{
  auto slices = ctOf("1.2.840.99", "MRN-4711");
  for (test::DicomData& slice : slices) slice.setText(0x0020000E, "UI", "1.2.840.99.7");
  test::writeDicomFiles(slices, folder_ / "ct/b");
  EXPECT_FALSE(writeEncapsulatedPdf(document(), folder_ / "ct", file()));
  test::writeDicomFiles(ctOf("1.2.840.99", "MRN-4711"), folder_ / "ct/a");
  EXPECT_TRUE(writeEncapsulatedPdf(document(), folder_ / "ct", file()));
}

TEST_F(EncapsulatedPdfFile, WithoutASeriesIsFiledOnlyIfAsked)
{
  test::writeDicomFiles(ctOf("1.2.840.99", "MRN-4711"), folder_ / "ct");
  PdfDocument other = document();
  other.seriesKey.clear();
  const auto written = writeEncapsulatedPdf(other, folder_ / "ct", file());
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, HasSubstr("add --ct-not-compared"));
  EXPECT_FALSE(fs::exists(file()));
  other.isFiledWithoutSeries = true;
  EXPECT_TRUE(writeEncapsulatedPdf(other, folder_ / "ct", file()));
}

TEST_F(EncapsulatedPdfFile, IsRefusedForSeveralStudiesWithoutNamingThePatient)
{
  test::writeDicomFiles(ctOf("1.2.840.99", "MRN-4711"), folder_ / "ct/a");
  test::writeDicomFiles(ctOf("1.2.840.98", "MRN-4712"), folder_ / "ct/b");
  const auto written = writeEncapsulatedPdf(document(), folder_ / "ct", file());
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, HasSubstr("several studies"));
  EXPECT_THAT(written.error().message, Not(HasSubstr("Doe")));
  EXPECT_THAT(written.error().message, Not(HasSubstr("MRN")));
  EXPECT_FALSE(fs::exists(file()));
}

TEST_F(EncapsulatedPdfFile, IsRefusedForTwoPatientsUnderOneSeriesNumber)
{
  auto slices = ctOf("1.2.840.99", "MRN-4711");
  for (std::size_t k = slices.size() / 2; k < slices.size(); ++k)
    slices[k].setText(0x00100020, "LO", "MRN-4712");
  test::writeDicomFiles(slices, folder_ / "ct");
  const auto written = writeEncapsulatedPdf(document(), folder_ / "ct", file());
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, Not(HasSubstr("MRN")));
  EXPECT_FALSE(fs::exists(file()));
}

TEST_F(EncapsulatedPdfFile, IsRefusedWithoutAStudyAndWithoutAPdf)
{
  std::ofstream(folder_ / "note.txt") << "no DICOM";
  EXPECT_FALSE(writeEncapsulatedPdf(document(), folder_ / "note.txt", file()));
  PdfDocument other = document();
  other.content = "no PDF";
  EXPECT_FALSE(writeEncapsulatedPdf(other, std::nullopt, file()));
  other = document();
  other.title = "Plan für links";
  EXPECT_FALSE(writeEncapsulatedPdf(other, std::nullopt, file()));
  EXPECT_FALSE(fs::exists(file()));
}

}  // namespace
}  // namespace perilymph::imaging
