// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as a file of a CT. The first byte says which kind of file.

#include <Eigen/LU>
#include <cmath>

#include "InputFile.h"
#include "Seeds.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/imaging/VolumeWriter.h"
#include "perilymph/test/DicomWriter.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::fuzz {

namespace {

constexpr const char* names[] = {"a.dcm", "a.nii", "a.nii.gz", "a.nrrd", "a.mha"};

ct::CtVolume smallVolume()
{
  std::vector<std::int16_t> voxels;
  for (int k = 0; k < 6 * 5 * 8; ++k) voxels.push_back(static_cast<std::int16_t>(k * 37 % 3000));
  Eigen::Matrix4d lps = Eigen::Matrix4d::Identity();
  lps.diagonal() << 0.3, 0.4, 0.5, 1.0;
  return *ct::CtVolume::make({6, 5, 8}, lps, std::move(voxels));
}

void checkVolume(const imaging::LoadedCt& loaded)
{
  const ct::CtVolume& volume = loaded.volume;
  const auto& size = volume.size();
  promise(size[0] > 1 && size[1] > 1 && size[2] > 1, "a volume has three dimensions");
  promise(volume.voxels().size() == static_cast<std::size_t>(size[0]) *
                                        static_cast<std::size_t>(size[1]) *
                                        static_cast<std::size_t>(size[2]),
          "every voxel is there");
  promise(volume.lpsFromIndex().allFinite(), "positions are finite");
  promise(std::fabs(volume.lpsFromIndex().topLeftCorner<3, 3>().determinant()) > 0.0,
          "voxels have a volume");
}

}  // namespace

std::vector<Bytes> seeds()
{
  const ct::CtVolume volume = smallVolume();
  std::vector<Bytes> files;
  const auto add = [&files](std::uint8_t kind, const std::string& content) {
    Bytes file{kind};
    file.insert(file.end(), content.begin(), content.end());
    files.push_back(std::move(file));
  };
  add(0, test::enhancedDicom(volume).file());
  add(0, test::dicomSlices(volume).front().file());
  const test::TemporaryFolder folder;
  for (std::uint8_t kind = 1; kind < 4; ++kind) {
    const auto file = folder / names[kind];
    promise(bool(imaging::writeVolume(volume, file)), "a seed is written");
    const Bytes content = contentOf(file);
    add(kind, {content.begin(), content.end()});
  }
  std::string meta =
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nTransformMatrix = 1 0 0 0 1 0 0 0 1\n"
      "Offset = 0 0 0\nAnatomicalOrientation = RAI\nElementSpacing = 0.3 0.4 0.5\nDimSize = 6 5 8\n"
      "ElementType = MET_SHORT\nElementDataFile = LOCAL\n";
  const auto voxels = volume.voxels();
  meta.append(reinterpret_cast<const char*>(voxels.data()), voxels.size_bytes());
  add(4, meta);
  addCorpus("ct_file", files);
  return files;
}

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  static fuzz::InputFile kinds[] = {
      fuzz::InputFile(fuzz::names[0]), fuzz::InputFile(fuzz::names[1]),
      fuzz::InputFile(fuzz::names[2]), fuzz::InputFile(fuzz::names[3]),
      fuzz::InputFile(fuzz::names[4])};
  if (size == 0) return 0;
  const auto& file = kinds[data[0] % 5].holding({data + 1, size - 1});
  const auto loaded = imaging::readCt(file);
  if (loaded)
    fuzz::checkVolume(*loaded);
  else
    fuzz::promise(
        !loaded.error().message.empty() && loaded.error().message.find('\n') == std::string::npos,
        "a refusal is one sentence");
  return 0;
}
