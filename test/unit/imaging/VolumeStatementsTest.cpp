// SPDX-License-Identifier: BSD-3-Clause

// Every pair of statements of volume files, made to differ by small and large factors: the file is
// refused or warned of, by the names of both places.

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <map>

#include "SmallVolumeFiles.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/test/TemporaryFolder.h"
#include "statements/VolumePairs.h"

namespace perilymph::imaging {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

/// A file whose two statements differ by a factor.
struct Disagreeing {
  const char* name;
  std::function<std::string(double)> content;
  bool hasSizes = true;  ///< False for a disagreement of kind only.
};

std::string nrrdWith(const std::string& line)
{
  return replaced(nrrdHeader("short", "raw", "LPS", 1.0), "\nsizes:", "\n" + line + "\nsizes:") +
         obliqueVoxels();
}

std::string text(double value) { return std::to_string(value); }

Bytes niftiOfBothForms() { return niftiFile(obliqueCt(), Form::both); }

float at(const Bytes& bytes, std::size_t place)
{
  float value = 0.0F;
  std::memcpy(&value, bytes.content.data() + place, sizeof value);
  return value;
}

/// Scales numbers of the header.
std::string scaled(Bytes bytes, const std::vector<std::size_t>& places, double factor)
{
  for (const std::size_t place : places)
    bytes.put<float>(place, static_cast<float>(factor * static_cast<double>(at(bytes, place))));
  return bytes.content;
}

/// The QForm moved by so many millimeters, of another code than the SForm or of the same.
std::string movedQForm(double distance_mm, std::int16_t sformCode, std::int16_t qformCode)
{
  Bytes bytes = niftiOfBothForms();
  bytes.put<std::int16_t>(254, sformCode);
  bytes.put<std::int16_t>(252, qformCode);
  bytes.put<float>(268, at(bytes, 268) + static_cast<float>(distance_mm));
  return bytes.content;
}

/// Voxel data of another length.
std::string resized(std::string content, double factor)
{
  const std::size_t header = content.size() - 2 * voxelCount;
  content.resize(header + static_cast<std::size_t>(std::lround(factor * 2 * voxelCount)));
  return content;
}

std::string spacings(const char* field, double factor)
{
  return std::string(field) + text(0.3 * factor) + " 0.4 " + text(0.6);
}

std::map<const StatedTwice*, std::vector<Disagreeing>> disagreeing()
{
  return {
      {&nifti::voxelSize,
       {{"a.nii",
         [](double factor) {  // a column of the SForm
           return scaled(niftiFile(obliqueCt(), Form::sform), {284, 300, 316}, factor);
         }},
        {"b.nii",
         [](double factor) {  // pixdim
           return scaled(niftiFile(obliqueCt(), Form::sform), {88}, factor);
         }},
        {"c.nii",
         [](double factor) {  // every column, as in another unit
           std::vector<std::size_t> places;
           for (std::size_t place = 280; place < 328; place += 4) places.push_back(place);
           return scaled(niftiOfBothForms(), places, factor);
         }}}},
      {&nifti::cornerPlace,
       {{"a.nii", [](double factor) { return movedQForm(31.25 * (factor - 1.0), 1, 1); }},
        {"b.nii",
         [](double factor) {  // turned
           Bytes bytes = niftiOfBothForms();
           bytes.put<float>(256, at(bytes, 256) * static_cast<float>(1.0 / (1.0 + factor)));
           return bytes.content;
         }}}},
      {&nifti::otherQForm,
       {{"a.nii", [](double factor) { return movedQForm(31.25 * (factor - 1.0), 2, 1); }},
        {"b.nii", [](double factor) { return movedQForm(31.25 * (factor - 1.0), 1, 2); }}}},
      {&nifti::templateSForm,
       {{"a.nii", [](double factor) { return movedQForm(31.25 * (factor - 1.0), 4, 1); }}}},
      {&nifti::handedness,
       {{"a.nii",
         [](double) {
           Bytes bytes = niftiOfBothForms();
           bytes.put<float>(76, -1.0F);
           return bytes.content;
         },
         false}}},
      {&nifti::unusableForm,
       {{"a.nii",
         [](double) {
           return scaled(niftiOfBothForms(), {280, 284, 288, 296, 300, 304, 312, 316, 320}, 0.0);
         },
         false}}},
      {&nifti::voxelBits,
       {{"a.nii",
         [](double) {
           Bytes bytes = niftiOfBothForms();
           bytes.put<std::int16_t>(72, 12);
           return bytes.content;
         },
         false}}},
      {&nifti::grayValues,
       {{"a.nii",
         [](double) {
           Bytes bytes = niftiOfBothForms();
           bytes.put<float>(116, -1024.0F);
           return bytes.content;
         },
         false}}},
      {&nifti::bytes,
       {{"a.nii", [](double f) { return resized(niftiOfBothForms().content, f); }},
        {"b.nii", [](double f) { return resized(niftiOfBothForms().content, 1.0 / f); }},
        {"c.nii.gz", [](double f) { return gzipped(resized(niftiOfBothForms().content, f)); }},
        {"d.nii.gz",
         [](double f) { return gzipped(resized(niftiOfBothForms().content, 1.0 / f)); }}}},
      {&nrrd::voxelSize,
       {{"a.nrrd", [](double f) { return nrrdWith(spacings("spacings: ", f)); }},
        {"c.nrrd", [](double f) { return nrrdWith(spacings("spacing:=", f)); }},
        {"b.nrrd", [](double f) { return nrrdWith("spacings: nan nan " + text(0.6 / f)); }}}},
      {&nrrd::extent,
       {{"a.nrrd",
         [](double f) {
           return nrrdWith("axis mins: 0 0 0\naxis maxs: " + text(3.6 * f) + " 3.6 4.8");
         }}}},
      {&nrrd::unit,
       {{"a.nrrd",
         [](double) {
           return nrrdWith("space units: \"mm\" \"mm\" \"mm\"\nunits: \"cm\" \"cm\" \"cm\"");
         },
         false}}},
      {&nrrd::dimensions,
       {{"a.nrrd", [](double) { return nrrdWith("space dimension: 4"); }, false}}},
      {&nrrd::voxelCount,
       {{"a.nrrd", [](double f) { return nrrdWith("number: " + text(std::round(960 * f))); }}}},
      {&nrrd::grayValues,
       {{"a.nrrd", [](double) { return nrrdWith("old min: -1024\nold max: 3071"); }, false}}},
      {&nrrd::thickness,
       {{"a.nrrd",
         [](double f) { return nrrdWith("thicknesses: nan nan " + text(0.6 * 5.0 * f)); }},
        {"b.nrrd",
         [](double f) { return nrrdWith("thicknesses: nan nan " + text(0.6 * 0.195 / f)); }},
        {"c.nrrd", [](double f) { return nrrdWith("thickness:=nan nan " + text(3.0 * f)); }}}},
      {&nrrd::keyValue,
       {{"a.nrrd",
         [](double f) { return nrrdWith("spacings: 0.3 0.4 0.6\n" + spacings("Spacing:=", f)); }},
        {"b.nrrd", [](double) { return nrrdWith("sizes:=12 10 9"); }, false},
        {"c.nrrd", [](double) { return nrrdWith("space_origin:=(0,0,0)"); }, false},
        {"d.nrrd",
         [](double) {
           return nrrdWith("space units:=\"cm\" \"cm\" \"cm\"\nspace units: \"mm\" \"mm\" \"mm\"");
         },
         false}}},
      {&nrrd::field,
       {{"a.nrrd", [](double) { return nrrdWith("space: RAS"); }, false},
        {"b.nrrd", [](double) { return nrrdWith("dimension: 2"); }, false},
        {"c.nrrd", [](double) { return nrrdWith("spaceorigin: (0,0,0)"); }, false}}},
      {&nrrd::bytes,
       {{"a.nrrd", [](double f) { return resized(nrrdWith("content: a"), f); }},
        {"b.nrrd", [](double f) { return resized(nrrdWith("content: a"), 1.0 / f); }},
        {"c.nrrd",
         [](double f) {
           return nrrdHeader("short", "gzip", "LPS", 1.0) + gzipped(resized(obliqueVoxels(), f));
         }},
        {"d.nrrd",
         [](double f) {
           return nrrdHeader("short", "gzip", "LPS", 1.0) +
                  gzipped(resized(obliqueVoxels(), 1.0 / f));
         }}}},
      {&meta::voxelSize,
       {{"a.mha",
         [](double f) {  // the matrix holds the spacing, too
           std::string header = metaHeader();
           const std::size_t place = header.find("TransformMatrix = ") + 18;
           const Eigen::Matrix3d axes = obliqueAxes() * f;
           std::string numbers;
           for (Eigen::Index axis = 0; axis < 3; ++axis)
             for (Eigen::Index row = 0; row < 3; ++row) numbers += text(axes(row, axis)) + " ";
           header.replace(place, header.find('\n', place) - place, numbers);
           return header + obliqueVoxels();
         }}}},
      {&meta::elementSize,
       {{"a.mha",
         [](double f) {
           return metaHeader(spacings("ElementSize = ", f) + "\n") + obliqueVoxels();
         }}}},
      {&meta::orientation,
       {{"a.mha",
         [](double) { return metaHeader("AnatomicalOrientation = LAI\n") + obliqueVoxels(); },
         false},
        {"b.mha",
         [](double) { return metaHeader("AnatomicalOrientation = RIA\n") + obliqueVoxels(); },
         false},
        {"c.mha",
         [](double) { return metaHeader("AnatomicalOrientation = up\n") + obliqueVoxels(); },
         false}}},
      {&meta::grayValues,
       {{"a.mha",
         [](double f) {
           return metaHeader("ElementMin = -1024\nElementMax = " + text(3068 * f) + "\n") +
                  obliqueVoxels();
         }}}},
      {&meta::packedBytes,
       {{"a.mha",
         [](double f) {
           const std::string packed = zipped(obliqueVoxels());
           return metaHeader("CompressedData = True\nCompressedDataSize = " +
                             std::to_string(std::lround(f * static_cast<double>(packed.size()))) +
                             "\n") +
                  packed;
         }}}},
      {&meta::field,
       {{"a.mha", [](double) { return metaHeader("Origin = 1 2 3\n") + obliqueVoxels(); }, false},
        {"b.mha", [](double) { return metaHeader("DimSize = 10 12 8\n") + obliqueVoxels(); },
         false}}},
      {&meta::bytes,
       {{"a.mha", [](double f) { return resized(metaHeader() + obliqueVoxels(), f); }},
        {"b.mha", [](double f) { return resized(metaHeader() + obliqueVoxels(), 1.0 / f); }},
        {"c.mha",
         [](double f) {
           return metaHeader("CompressedData = True\n") + zipped(resized(obliqueVoxels(), f));
         }},
        {"d.mha",
         [](double f) {
           return metaHeader("CompressedData = True\n") + zipped(resized(obliqueVoxels(), 1.0 / f));
         }}}},
  };
}

class VolumeStatements : public testing::Test {
protected:
  /// Reads a file of a disagreement and expects an answer that names the quantity and both places.
  void expectAnswer(const StatedTwice& pair, const Disagreeing& file, double factor)
  {
    std::ofstream(folder_ / file.name, std::ios::binary) << file.content(factor);
    const auto loaded = readCt(folder_ / file.name);
    const auto sentence =
        AllOf(HasSubstr(" twice: "), HasSubstr(pair.quantity),
              HasSubstr(std::string(" in ") + pair.first),
              HasSubstr(std::string(" in ") + pair.second), HasSubstr(pair.remedy));
    if (pair.answer == Disagreement::warn) {
      ASSERT_TRUE(loaded) << loaded.error().message;
      EXPECT_THAT(loaded->series.warnings, Contains(sentence)) << file.name << " " << factor;
      // what a patient file and the flags are made of
      EXPECT_THAT(loaded->volume.provenance().notes, Contains(sentence));
      EXPECT_TRUE(loaded->volume.provenance().isInDoubt);
    } else {
      ASSERT_FALSE(loaded) << pair.format << ": " << pair.quantity << " " << file.name << " "
                           << factor;
      // packed data that end early are seen as such
      EXPECT_THAT(loaded.error().message, sentence) << file.name << " " << factor;
    }
  }

  test::TemporaryFolder folder_;
};

TEST_F(VolumeStatements, AllHaveAFileOfTheirDisagreement)
{
  const auto files = disagreeing();
  EXPECT_EQ(files.size(), volumePairs().size());
  for (const StatedTwice* pair : volumePairs())
    EXPECT_TRUE(files.contains(pair)) << pair->format << ": " << pair->quantity;
}

TEST_F(VolumeStatements, ThatDifferAreNeverTakenWithoutAWord)
{
  for (const auto& [pair, files] : disagreeing())
    for (const Disagreeing& file : files)
      for (const double factor : {1.01, 1.05, 10.0, 1000.0}) {
        SCOPED_TRACE(std::string(pair->format) + ", " + pair->quantity + ", " + file.name);
        expectAnswer(*pair, file, factor);
        if (!file.hasSizes) break;
      }
}

TEST_F(VolumeStatements, ThatAgreeAreTakenWithoutAWord)
{
  // by rounding, as programs write it
  const std::map<std::string, std::string> files = {
      {"a.nii", scaled(niftiFile(obliqueCt(), Form::sform), {88}, 1.0001)},
      {"b.nii", niftiOfBothForms().content},
      {"c.nii", movedQForm(0.01, 1, 1)},
      {"d.nii", movedQForm(0.0, 2, 1)},
      {"a.nrrd", nrrdWith("spacings: 0.3 nan 0.6\nspace units: \"mm\" \"mm\" \"mm\"\nnumber: 960")},
      {"b.nrrd", nrrdWith("axis mins: 0 0 0\naxis maxs: 3.3 3.6 4.2\nspace dimension: 3")},
      {"c.nrrd", nrrdWith("axis mins: 0 0 0\naxis maxs: 3.6 4.0 4.8\nSpace: LPS")},
      {"d.nrrd", nrrdWith("thicknesses: nan nan 1.2\nspacing:=0.30 0.40 0.60\nsizes:=12 10 8\n"
                          "modality:=CT\nunits:=HU\ntype:=temporal bone")},
      {"a.mha", metaHeader("ElementSize = 0.3 0.4 0.6\nAnatomicalOrientation = RAI\nElementMin = "
                           "-1024\nElementMax = 3068\n") +
                    obliqueVoxels()},
      {"b.mha", metaHeader("AnatomicalOrientation = ???\nNDims = 3\n") + obliqueVoxels()}};
  for (const auto& [name, content] : files) {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    const auto loaded = readCt(folder_ / name);
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_THAT(loaded->series.warnings, testing::Not(Contains(HasSubstr("twice")))) << name;
    EXPECT_FALSE(loaded->volume.provenance().isInDoubt) << name;
  }
}

TEST_F(VolumeStatements, OfAnotherModalityAreRefused)
{
  for (const char* const modality : {"MR", "PT", "DWMRI", "ultrasound"})
    for (const char* const key :
         {"modality:=", "Modality:= ", "DICOM_0008_0060_Modality:=", "0008|0060:="}) {
      std::ofstream(folder_ / "a.nrrd", std::ios::binary) << nrrdWith(std::string(key) + modality);
      const auto loaded = readCt(folder_ / "a.nrrd");
      ASSERT_FALSE(loaded) << key << modality;
      EXPECT_EQ(loaded.error().message, (folder_ / "a.nrrd").string() + " is of the modality " +
                                            modality +
                                            ", not CT. Export the CT as NRRD with its voxels in "
                                            "the file.");
    }
}

TEST_F(VolumeStatements, OfNifti2AreRefusedWithWhatToDo)
{
  for (const bool isBigEndian : {false, true}) {
    Bytes bytes(544 + 2 * voxelCount, isBigEndian);
    bytes.put<std::int32_t>(0, 540);
    std::memcpy(bytes.content.data() + 4, "n+2\0\r\n\032\n", 8);
    std::ofstream(folder_ / "a.nii", std::ios::binary | std::ios::trunc) << bytes.content;
    const auto loaded = readCt(folder_ / "a.nii");
    ASSERT_FALSE(loaded);
    EXPECT_THAT(loaded.error().message, HasSubstr("is a NIfTI-2 file; NIfTI-1 is read. Save"));
  }
}

}  // namespace
}  // namespace perilymph::imaging
