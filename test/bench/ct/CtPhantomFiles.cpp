// SPDX-License-Identifier: BSD-3-Clause

// Writes a synthetic temporal bone as DICOM, for trying the programs without a CT:
//
//     perilymph-ct-phantom SEED FOLDER [cone-beam | high-resolution | clinical]
//     perilymph-ct-phantom implanted SEED ARRAY FOLDER [fine | cone-beam | high-resolution | clinical]
//
// Prints its true A, B, H, side and axis. An implanted one has a CT before surgery (FOLDER/before) and after it
// (FOLDER/after), and the truth in P of the latter (FOLDER/truth.json). There `inserted_length_mm` counts from the
// plane of the round window, and `inserted_length_from_opening_mm` from the opening before it, as `ct contacts` does.

#include <charconv>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/test/CtPhantom.h"
#include "perilymph/test/DicomWriter.h"
#include "perilymph/test/ImplantPhantom.h"

namespace perilymph::test {
namespace {

std::optional<PhantomScan> scanNamed(std::string_view name)
{
  if (name == "cone-beam") return coneBeamScan();
  if (name == "high-resolution") return highResolutionScan();
  if (name == "clinical") return clinicalScan();
  return std::nullopt;
}

std::optional<ImplantScan> implantScanNamed(std::string_view name)
{
  if (name == "fine") return fineImplantScan();
  if (name == "cone-beam") return coneBeamImplantScan();
  if (name == "high-resolution") return highResolutionImplantScan();
  if (name == "clinical") return clinicalImplantScan();
  return std::nullopt;
}

/// Makes a folder for new files, or says why not.
bool isMade(const std::filesystem::path& folder)
{
  std::error_code failure;
  if (std::filesystem::exists(folder) && !std::filesystem::is_empty(folder, failure)) {
    std::fprintf(stderr, "%s is not empty; name a new folder.\n", folder.c_str());
    return false;
  }
  std::filesystem::create_directories(folder, failure);
  if (failure)
    std::fprintf(stderr, "%s cannot be made: %s.\n", folder.c_str(), failure.message().c_str());
  return !failure;
}

/// Writes a series and returns its number of slices.
std::size_t writeSeries(const ct::CtVolume& volume, const std::string& uid,
                        const std::filesystem::path& folder)
{
  std::filesystem::create_directories(folder);
  auto slices = dicomSlices(volume, uid);
  for (DicomData& slice : slices) slice.setText(0x00100010, "PN", "Phantom^Synthetic");
  writeDicomFiles(slices, folder);
  return slices.size();
}

int write(std::uint64_t seed, const std::filesystem::path& folder, const PhantomScan& scan)
{
  if (!isMade(folder)) return 1;
  const CtPhantom phantom = makeCtPhantom(seed, scan);
  const std::size_t slices = writeSeries(phantom.volume, "1.2.3." + std::to_string(seed), folder);
  std::printf(
      "%zu slices. %s ear, A %.2f, B %.2f, H %.2f mm; axis %.3f, %.3f, %.3f (LPS); in the "
      "cochlea: %.2f,%.2f,%.2f\n",
      slices, phantom.isRight ? "right" : "left", phantom.a, phantom.b, phantom.h,
      phantom.axis_P.x(), phantom.axis_P.y(), phantom.axis_P.z(), phantom.inside_P.x(),
      phantom.inside_P.y(), phantom.inside_P.z());
  return 0;
}

nlohmann::json jsonOf(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }

nlohmann::json truthJson(const ImplantPhantom& phantom, const std::string& array)
{
  const ImplantTruth& truth = phantom.truth;
  nlohmann::json json;
  json["format"] = 1;
  json["array"] = array;
  json["side"] = truth.isRight ? "right" : "left";
  json["a_mm"] = truth.a;
  json["b_mm"] = truth.b;
  json["h_mm"] = truth.h;
  json["axis_lps"] = jsonOf(truth.axis_P);
  json["round_window_lps_mm"] = jsonOf(truth.roundWindow_P);
  json["in_cochlea_lps_mm"] = jsonOf(truth.inside_P);
  json["in_cochlea_before_lps_mm"] = jsonOf(phantom.preoperative.inside_P);
  json["angular_insertion_depth_deg"] = truth.angularInsertionDepth_deg;
  json["tip_angle_deg"] = truth.tipAngle_deg;
  json["tip_lps_mm"] = jsonOf(truth.tip_P);
  json["inserted_length_mm"] = truth.insertedLength_mm;
  json["inserted_length_from_opening_mm"] =
      truth.insertedLength_mm + inMillimeters(anatomy::Cochlea{}.leadIn);
  json["contacts_inside"] = truth.contactsInside;
  for (int row = 0; row < 4; ++row)
    json["after_from_before"].push_back(
        {phantom.post_from_pre(row, 0), phantom.post_from_pre(row, 1),
         phantom.post_from_pre(row, 2), phantom.post_from_pre(row, 3)});
  for (const TrueContact& contact : truth.contacts)
    json["contacts"].push_back({{"number", contact.number},
                                {"position_lps_mm", jsonOf(contact.position_P)},
                                {"on_course_lps_mm", jsonOf(contact.onCourse_P)},
                                {"angle_deg", contact.angle_deg},
                                {"inside", contact.isInside},
                                {"above_partition", contact.isAbove}});
  for (const Eigen::Vector3d& point : truth.course_P)
    json["course_lps_mm"].push_back(jsonOf(point));
  return json;
}

int writeImplanted(std::uint64_t seed, const std::string& array,
                   const std::filesystem::path& folder, const ImplantScan& scan)
{
  if (!isMade(folder)) return 1;
  ImplantCondition condition;
  condition.array = array;
  try {
    const ImplantPhantom phantom = makeImplantPhantom(seed, scan, condition);
    const std::size_t before = writeSeries(phantom.preoperative.volume,
                                           "1.2.3." + std::to_string(seed), folder / "before");
    const std::size_t after =
        writeSeries(phantom.postoperative, "1.2.4." + std::to_string(seed), folder / "after");
    std::ofstream(folder / "truth.json") << truthJson(phantom, array).dump(1) << '\n';
    const ImplantTruth& truth = phantom.truth;
    std::printf(
        "%zu slices before, %zu after surgery. %s ear, A %.2f, B %.2f, H %.2f mm; %d of %zu "
        "contacts inside, the "
        "most apical at %.0f degrees; in the cochlea: %.2f,%.2f,%.2f before, %.2f,%.2f,%.2f "
        "after\n",
        before, after, truth.isRight ? "right" : "left", truth.a, truth.b, truth.h,
        truth.contactsInside, truth.contacts.size(), truth.angularInsertionDepth_deg,
        phantom.preoperative.inside_P.x(), phantom.preoperative.inside_P.y(),
        phantom.preoperative.inside_P.z(), truth.inside_P.x(), truth.inside_P.y(),
        truth.inside_P.z());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
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
  if (argc > 1 && std::string_view(argv[1]) == "implanted") {
    const auto scan = implantScanNamed(argc > 5 ? argv[5] : "cone-beam");
    if (argc >= 5 && argc <= 6 && isSeed(argv[2]) && scan)
      return writeImplanted(seed, argv[3], argv[4], *scan);
  } else {
    const auto scan = scanNamed(argc > 3 ? argv[3] : "high-resolution");
    if (argc >= 3 && argc <= 4 && isSeed(argv[1]) && scan) return write(seed, argv[2], *scan);
  }
  std::fprintf(stderr,
               "perilymph-ct-phantom SEED FOLDER [cone-beam | high-resolution | clinical]\n"
               "perilymph-ct-phantom implanted SEED ARRAY FOLDER [fine | cone-beam | "
               "high-resolution | clinical]\n");
  return 2;
}
