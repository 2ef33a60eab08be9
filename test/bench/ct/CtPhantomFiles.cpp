// SPDX-License-Identifier: BSD-3-Clause

// Writes a synthetic temporal bone as DICOM, for trying the programs without a CT:
//
//     perilymph-ct-phantom SEED FOLDER [cone-beam | high-resolution | clinical]
//
// Prints its true A, B, H, side and axis.

#include <charconv>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>

#include "perilymph/test/CtPhantom.h"
#include "perilymph/test/DicomWriter.h"

namespace perilymph::test {
namespace {

std::optional<PhantomScan> scanNamed(std::string_view name)
{
  if (name == "cone-beam") return coneBeamScan();
  if (name == "high-resolution") return highResolutionScan();
  if (name == "clinical") return clinicalScan();
  return std::nullopt;
}

int write(std::uint64_t seed, const std::filesystem::path& folder, const PhantomScan& scan)
{
  std::error_code failure;
  if (std::filesystem::exists(folder) && !std::filesystem::is_empty(folder, failure)) {
    std::fprintf(stderr, "%s is not empty; name a new folder.\n", folder.c_str());
    return 1;
  }
  std::filesystem::create_directories(folder, failure);
  if (failure) {
    std::fprintf(stderr, "%s cannot be made: %s.\n", folder.c_str(), failure.message().c_str());
    return 1;
  }
  const CtPhantom phantom = makeCtPhantom(seed, scan);
  auto slices = dicomSlices(phantom.volume, "1.2.3." + std::to_string(seed));
  for (DicomData& slice : slices) slice.setText(0x00100010, "PN", "Phantom^Synthetic");
  writeDicomFiles(slices, folder);
  std::printf(
      "%zu slices. %s ear, A %.2f, B %.2f, H %.2f mm; axis %.3f, %.3f, %.3f (LPS); in the "
      "cochlea: %.2f,%.2f,%.2f\n",
      slices.size(), phantom.isRight ? "right" : "left", phantom.a, phantom.b, phantom.h,
      phantom.axis_P.x(), phantom.axis_P.y(), phantom.axis_P.z(), phantom.inside_P.x(),
      phantom.inside_P.y(), phantom.inside_P.z());
  return 0;
}

}  // namespace
}  // namespace perilymph::test

int main(int argc, char** argv)
{
  using namespace perilymph::test;
  std::uint64_t seed = 0;
  const auto isSeed = [&seed](const char* text) {
    const char* const end = text + std::strlen(text);
    const auto [next, error] = std::from_chars(text, end, seed);
    return error == std::errc{} && next == end;
  };
  const auto scan = scanNamed(argc > 3 ? argv[3] : "high-resolution");
  if (argc < 3 || argc > 4 || !isSeed(argv[1]) || !scan) {
    std::fprintf(stderr,
                 "perilymph-ct-phantom SEED FOLDER [cone-beam | high-resolution | clinical]\n");
    return 2;
  }
  return write(seed, argv[2], *scan);
}
