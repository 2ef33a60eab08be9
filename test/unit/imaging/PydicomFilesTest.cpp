// SPDX-License-Identifier: BSD-3-Clause

// The test files of Debian's python3-pydicom: nine encodings of the same image, and many
// other kinds of files.

#include <gmock/gmock.h>

#include <filesystem>

#include "dicom/DicomHeader.h"
#include "dicom/FrameDecoder.h"
#include "perilymph/imaging/CtSeries.h"

namespace perilymph::imaging {
namespace {

class PydicomFiles : public testing::Test {
protected:
  void SetUp() override
  {
    if (!std::filesystem::is_directory(folder))
      GTEST_SKIP() << folder << " is not there: install python3-pydicom to test on its files.";
  }

  DecodedFrames decoded(const std::string& name)
  {
    const auto header = readDicomHeader(folder / name);
    if (!header) throw std::runtime_error(name + " is no DICOM file");
    auto frames = decodeFrames(*header);
    if (!frames) throw std::runtime_error(name + ": " + frames.error().message);
    return *std::move(frames);
  }

  const std::filesystem::path folder = "/usr/lib/python3/dist-packages/pydicom/data/test_files";
};

TEST_F(PydicomFiles, HaveTheSameVoxelsInEveryLosslessCoding)
{
  const DecodedFrames plain = decoded("MR_small.dcm");
  ASSERT_EQ(plain.voxels.size(), 64u * 64u);
  EXPECT_NE(plain.voxels.front(), plain.voxels[2000]);
  for (const char* name :
       {"MR_small_implicit.dcm", "MR_small_bigendian.dcm", "MR_small_expb.dcm", "MR_small_RLE.dcm",
        "MR_small_padded.dcm", "MR_small_jp2klossless.dcm", "MR_small_jpeg_ls_lossless.dcm"})
    EXPECT_EQ(decoded(name).voxels, plain.voxels) << name;
}

TEST_F(PydicomFiles, AreReadOrRefusedInSilence)
{
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    if (const auto header = readDicomHeader(entry.path()); header && header->hasPixels) {
      const auto frames = decodeFrames(*header);
      if (!frames) {
        EXPECT_THAT(frames.error().message, testing::HasSubstr("could not be decoded"));
      }
    }
    const bool isRead = static_cast<bool>(readCt(entry.path()));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << entry.path();
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "") << entry.path();
    // None of these files is a CT of two or more slices.
    const bool isDirectory = entry.path().filename().string().find("DICOMDIR") == 0;
    EXPECT_TRUE(isDirectory || !isRead) << entry.path();
    ++files;
  }
  EXPECT_GT(files, 100);
}

TEST_F(PydicomFiles, CutOffAreNotRead)
{
  const auto header = readDicomHeader(folder / "MR_truncated.dcm");
  ASSERT_TRUE(header);
  EXPECT_TRUE(header->isTruncated);
}

TEST_F(PydicomFiles, ThatGdcmCannotDecodeAreRefused)
{
  // The marker of its second fragment is within the data, and the decoder stops without an error.
  const auto header = readDicomHeader(folder / "JPEG2000-embedded-sequence-delimiter.dcm");
  ASSERT_TRUE(header);
  EXPECT_TRUE(header->isTruncated || !decodeFrames(*header));
}

TEST_F(PydicomFiles, OfADicomdirAreListedAsSeries)
{
  const auto list = findSeries(folder / "dicomdirtests" / "DICOMDIR");
  ASSERT_TRUE(list) << list.error().message;
  EXPECT_EQ(list->series.size(), 13u);
  for (const CtSeries& series : list->series) {
    if (series.modality == "CT") continue;
    EXPECT_THAT(series.obstacle, testing::HasSubstr("modality " + series.modality + ", not CT"));
  }
}

}  // namespace
}  // namespace perilymph::imaging
