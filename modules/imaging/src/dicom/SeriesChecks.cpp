// SPDX-License-Identifier: BSD-3-Clause
#include "SeriesChecks.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <vector>

#include "../statements/Warnings.h"
#include "DicomStatements.h"

namespace perilymph::imaging {
namespace {

constexpr double maxSpacingChange = 1e-4;  // of the first slice's

std::string spacingText(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

/// Files of which nothing can be read; empty where there are none.
Sentence deflatedObstacle(const DicomSeries& series)
{
  const auto isDeflated = [](const DicomHeader& header) {
    return header.coding == PixelCoding::deflated;
  };
  const std::size_t deflated = countOf(series.headers, isDeflated);
  if (deflated == 0) return {};
  return Sentence{
      "%1 of %2 files are compressed as a whole (transfer syntax 1.2.840.10008.1.2.1.99, "
      "deflated), which this program does not read. Export the series uncompressed, or convert it "
      "with gdcmconv --raw.",
      deflated, series.headers.size()};
}

Sentence cutObstacle(const DicomSeries& series)
{
  const auto isCut = [](const DicomHeader& header) { return header.isTruncated; };
  const std::size_t cut = countOf(series.headers, isCut);
  if (cut == 0) return {};
  return Sentence{
      "%1 of %2 files are cut off: they end before their voxels do. Copy the series again.", cut,
      series.headers.size()};
}

/// Classes of DICOM PS3.4, behind "1.2.840.10008.5.1.4.1.1.".
struct ImageClass {
  const char* ending;
  const char* modality;
};
constexpr ImageClass classes[] = {
    {"2", "CT"},      {"2.1", "CT"},    {"2.2", "CT"},    {"4", "MR"},      {"4.1", "MR"},
    {"4.3", "MR"},    {"4.4", "MR"},    {"128", "PT"},    {"128.1", "PT"},  {"130", "PT"},
    {"20", "NM"},     {"3.1", "US"},    {"6.1", "US"},    {"6.2", "US"},    {"1", "CR"},
    {"1.1", "DX"},    {"1.2", "MG"},    {"12.1", "XA"},   {"12.1.1", "XA"}, {"12.2", "RF"},
    {"12.2.1", "RF"}, {"13.1.1", "XA"}, {"13.1.2", "DX"}, {"13.1.3", "MG"}};

constexpr const char* classRoot = "1.2.840.10008.5.1.4.1.1.";

/// The modality of an image class; empty where it is not known, or of any modality.
std::string modalityOfClass(const std::string& sopClass)
{
  for (const ImageClass& known : classes)
    if (sopClass == std::string(classRoot) + known.ending) return known.modality;
  return {};
}

/// Secondary capture in all its classes.
bool isCapture(const DicomHeader& header)
{
  return header.sopClass == std::string(classRoot) + "7" ||
         header.sopClass.starts_with(std::string(classRoot) + "7.");
}

/// What X-ray tubes and flat panels reconstruct: volumes, if they have a place in the patient.
bool isFlatPanel(const std::string& modality)
{
  return modality == "XA" || modality == "RF" || modality == "DX";
}

/// What of a place in the patient the frames of a series lack; empty where it is whole.
std::string missingPlace(const DicomSeries& series)
{
  bool position = false, orientation = false, spacing = false;
  for (const DicomHeader& header : series.headers)
    for (const DicomFrame& frame : header.frames) {
      position = position || !frame.pose.position_P;
      orientation = orientation || !frame.pose.axes_P;
      spacing = spacing || !frame.pixelSpacing_mm;
    }
  std::string missing;
  const auto add = [&missing](bool isMissing, const char* name) {
    if (isMissing) missing += (missing.empty() ? "" : ", ") + std::string(name);
  };
  add(position, "ImagePositionPatient");
  add(orientation, "ImageOrientationPatient");
  add(spacing, "PixelSpacing");
  return missing;
}

/// Two statements of what the images are; empty where they agree.
Sentence contradictedKind(const DicomSeries& series)
{
  const std::string& modality = series.headers.front().modality;
  for (const DicomHeader& header : series.headers) {
    if (header.modality != modality)
      return Sentence{
          "Its images are of several modalities, %1 and %2. Export each as a series of its own.",
          (modality.empty() ? "(none)" : modality),
          (header.modality.empty() ? "(none)" : header.modality)};
    const std::string ofClass = modalityOfClass(header.sopClass);
    if (modality == "CT" && !ofClass.empty() && ofClass != "CT" && !isFlatPanel(ofClass))
      return *disagreement(Sentence{"The file %1", nameOf(header)}, dicomPairs::modality, modality,
                           ofClass);
  }
  return {};
}

/// What kind of image it is not; empty for a CT, and for a volume of another X-ray device.
Sentence kindObstacle(const DicomSeries& series)
{
  const DicomHeader& first = series.headers.front();
  if (!first.notParsed.empty()) {
    const auto isSkipped = [](const DicomHeader& header) { return !header.notParsed.empty(); };
    return Sentence{"%1 of %2 files were not read: %3", countOf(series.headers, isSkipped),
                    series.headers.size(), first.notParsed};
  }
  // Of a file that ends the parser, nothing else is known.
  if (first.modality.empty() && first.isTruncated) return cutObstacle(series);
  if (Sentence twice = contradictedKind(series); !twice.empty()) return twice;
  const std::string missing = missingPlace(series);
  const std::string& modality = series.summary.modality;
  if (isCapture(first) && !missing.empty())
    return Sentence{
        "It is a secondary capture, a picture of a screen, without a place in the patient (%1 is "
        "missing). Choose a series of original images.",
        missing};
  if (isFlatPanel(modality) && !missing.empty())
    return Sentence{
        "It is of the modality %1, a projection without a place in the patient (%2 is missing). "
        "Choose the volume that was reconstructed of it.",
        modality, missing};
  const bool isVolume =
      modality == "CT" || isFlatPanel(modality) ||
      (isCapture(first) && (modality.empty() || modality == "OT" || modality == "SC"));
  if (!isVolume)
    return Sentence{"It is of the modality %1, not CT. Choose a CT series.",
                    (modality.empty() ? "(none)" : modality)};
  if (series.slices.empty() && !first.frames.empty())
    return Sentence{
        "It is a scout (localizer), a projection and no slices. Choose a series of slices."};
  const auto isColored = [](const DicomHeader& header) {
    return header.hasPixels &&
           (header.samples != 1 || header.photometric.rfind("MONOCHROME", 0) != 0);
  };
  if (countOf(series.headers, isColored) > 0)
    return Sentence{
        "Its images are in color, as of a picture or a fusion, and hold no Hounsfield units. "
        "Choose a series of original images."};
  return {};
}

/// Whether all images are of one patient; empty if they are.
Sentence patientObstacle(const DicomSeries& series)
{
  const auto& first = series.headers.front().identity.others;
  for (std::size_t i = 0; i < first.size(); ++i) {
    std::string stated;
    for (const DicomHeader& header : series.headers) {
      const std::string& own = header.identity.others.at(i).second;
      if (own.empty()) continue;
      if (!stated.empty() && own != stated)
        return Sentence{
            "Its images differ in %1, so they may be of two patients. Export the images of each "
            "patient apart.",
            first[i].first};
      stated = own;
    }
  }
  return {};
}

/// Numbers that cannot be read, and what a file states twice.
Sentence faultObstacle(const DicomSeries& series)
{
  std::size_t faulty = 0;
  Sentence first;
  for (const DicomHeader& header : series.headers) {
    const bool isScout = std::all_of(header.frames.begin(), header.frames.end(),
                                     [](const DicomFrame& frame) { return frame.isLocalizer; });
    if (header.faults.empty() || isScout) continue;
    ++faulty;
    if (first.empty()) first = header.faults.front();
  }
  if (faulty < 2) return first;
  return Sentence{"%1 Other files have such faults: %2.", first, faulty - 1};
}

/// Whether every slope is one.
Sentence slopeObstacle(const DicomSeries& series)
{
  for (const SliceSource& slice : series.slices) {
    const DicomHeader& header = series.headers[slice.header];
    const double slope = header.frames[slice.frame].slope;
    if (slope > 0.0) continue;
    char text[40];
    std::snprintf(text, sizeof text, "%.4g", slope);
    return Sentence{
        "The slope of its gray values, RescaleSlope (0028,1053), is %1 in %2; it must be above 0. "
        "Export the series again as original images.",
        text, nameOf(header)};
  }
  return {};
}

/// Whether the stored values of all images are of one kind.
Sentence bitsObstacle(const DicomSeries& series)
{
  const DicomHeader& first = series.headers[series.slices.front().header];
  for (const SliceSource& slice : series.slices) {
    const DicomHeader& header = series.headers[slice.header];
    if (header.isSigned == first.isSigned) continue;
    return Sentence{
        "PixelRepresentation (0028,0103) differs between its images: signed in %1 and unsigned in "
        "%2. Export the series again as original images.",
        nameOf(header.isSigned ? header : first), nameOf(header.isSigned ? first : header)};
  }
  return {};
}

/// Whether every voxel is there and can be decoded.
Sentence fileObstacle(const DicomSeries& series)
{
  const std::vector<DicomHeader>& headers = series.headers;
  const std::size_t all = headers.size();
  const auto isIncomplete = [](const DicomHeader& header) {
    return !header.hasPixels || header.frames.empty() || !header.frames.front().pose.position_P;
  };
  const auto isLocked = [&](const DicomHeader& header) {
    return header.isEncrypted && isIncomplete(header);
  };
  if (const std::size_t locked = countOf(headers, isLocked); locked > 0)
    return Sentence{"%1 of %2 files are encrypted. Export the series again without encryption.",
                    locked, all};
  if (Sentence cut = cutObstacle(series); !cut.empty()) return cut;
  const auto isEmpty = [](const DicomHeader& header) {
    return !header.hasPixels || header.frames.empty();
  };
  if (const std::size_t empty = countOf(headers, isEmpty); empty > 0)
    return Sentence{"%1 of %2 files hold no image. Export the series again.", empty, all};
  for (const DicomHeader& header : headers)
    if (header.coding == PixelCoding::unknown)
      return Sentence{
          "Its voxels are stored in a way this program cannot decode (transfer syntax %1). Export "
          "the series uncompressed, or convert it with gdcmconv --raw.",
          (header.transferSyntax.empty() ? "missing" : header.transferSyntax)};
  return {};
}

/// Whether all slices have one size, spacing and kernel.
Sentence sizeObstacle(const DicomSeries& series)
{
  const DicomHeader& first = series.headers[series.slices.front().header];
  const auto spacing = first.frames[series.slices.front().frame].pixelSpacing_mm;
  for (const SliceSource& slice : series.slices) {
    const DicomHeader& header = series.headers[slice.header];
    if (header.rows != first.rows || header.columns != first.columns)
      return Sentence{
          "Its slices are of several sizes, %1 x %2 and %3 x %4 voxels. Export each size as a "
          "series of its own.",
          first.columns, first.rows, header.columns, header.rows};
    if (header.kernel != first.kernel)
      return Sentence{
          "Its slices are of several reconstruction kernels, %1 and %2. Export each reconstruction "
          "as a series of its own.",
          first.kernel, header.kernel};
    const auto& own = header.frames[slice.frame].pixelSpacing_mm;
    if (!own)
      return Sentence{
          "Its slices have no pixel spacing, so no length can be measured in them. Export the "
          "series again as original images."};
    if (((*own - *spacing).cwiseAbs().array() > maxSpacingChange * spacing->array()).any())
      return Sentence{
          "Its slices have several pixel spacings, %1 mm and %2 mm. Export each as a series of its "
          "own.",
          spacingText((*spacing)[0]), spacingText((*own)[0])};
  }
  const double voxels =
      static_cast<double>(first.rows) * first.columns * static_cast<double>(series.slices.size());
  if (voxels > static_cast<double>(maxCtVoxels))
    return Sentence{
        "It has %1 million voxels; at most %2 million are read. Export the region of the temporal "
        "bone.",
        std::lround(voxels / 1e6), maxCtVoxels / 1'000'000};
  return {};
}

/// Makers of cone-beam scanners, in the beginning of Manufacturer (0008,0070), in lower case.
constexpr const char* coneBeamMakers[] = {
    "carestream", "curvebeam", "dentium", "genoray", "imaging sciences", "instrumentarium",
    "j.morita",   "j. morita", "kavo",    "kodak",   "newtom",           "owandy",
    "planmeca",   "prexion",   "qr ",     "ray co",  "sirona",           "soredex",
    "trophy",     "vatech",    "verity",  "xoran"};

bool isConeBeam(const std::string& scanner)
{
  std::string lower;
  for (const char c : scanner)
    lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return std::any_of(std::begin(coneBeamMakers), std::end(coneBeamMakers),
                     [&lower](const char* maker) { return lower.starts_with(maker); });
}

}  // namespace

std::string statedModality(const DicomHeader& header)
{
  return header.modality.empty() ? modalityOfClass(header.sopClass) : header.modality;
}

Sentence obstacleOf(const DicomSeries& series)
{
  for (const auto check : {deflatedObstacle, kindObstacle, faultObstacle, fileObstacle,
                           patientObstacle, slopeObstacle, bitsObstacle, sizeObstacle})
    if (Sentence obstacle = check(series); !obstacle.empty()) return obstacle;
  return {};
}

Changes changesOf(const DicomSeries& series, std::size_t setting)
{
  Changes changes;
  std::vector<std::string> left;
  std::string last;
  for (const std::vector<std::size_t>& place : series.stack->places) {
    const DicomHeader& header = series.headers[series.slices[place.front()].header];
    const std::string& own = header.settings.at(setting).second;
    if (own.empty() || own == last) continue;
    if (!last.empty()) {
      ++changes.count;
      changes.example = {last, own};
      left.push_back(last);
    }
    changes.returns = changes.returns || std::find(left.begin(), left.end(), own) != left.end();
    last = own;
  }
  return changes;
}

Sentence orderObstacleOf(const DicomSeries& series)
{
  constexpr std::size_t fewest = 3;  // one slice that differs makes two
  const auto& settings = series.headers[series.slices.front().header].settings;
  for (std::size_t i = 0; i < settings.size(); ++i)
    if (const Changes changes = changesOf(series, i); changes.returns && changes.count >= fewest)
      return "Its slices alternate in " + settings[i].first +
             ", as those of two reconstructions in one series do. Export each reconstruction as a "
             "series of its own.";
  return {};
}

Sentence grayValueWarning(const DicomSeries& series)
{
  const DicomHeader& first = series.headers[series.slices.front().header];
  Sentence why;
  std::string type = first.rescaleType;
  for (char& c : type) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  const std::string ofClass = modalityOfClass(first.sopClass);
  if (isCapture(first))
    why = Sentence(warnings::capture);
  else if (isFlatPanel(series.summary.modality) || isFlatPanel(ofClass))
    why = Sentence(warnings::flatPanel);
  else if (!type.empty() && type != "HU")
    why = Sentence{"RescaleType (0028,1054) is %1", first.rescaleType};
  else if (isConeBeam(first.scanner))
    why = Sentence(warnings::coneBeam);
  if (why.empty()) return {};
  return Sentence(warnings::grayValues, {why});
}

}  // namespace perilymph::imaging
