// SPDX-License-Identifier: BSD-3-Clause
#include "DicomSeries.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "../SeriesScore.h"
#include "../statements/Warnings.h"
#include "SeriesChecks.h"
#include "SeriesDoubts.h"
#include "SeriesGroups.h"
#include "perilymph/foundation/Sha256.h"

namespace perilymph::imaging {
namespace {

void doubt(DicomSeries& series, const Sentence& sentence)
{
  series.doubts.push_back(sentence);
  series.summary.warnings.push_back(sentence);
}

/// Directions that most slices have in common, and the size of most.
struct Usual {
  Eigen::Vector3d normal_P;
  std::pair<int, int> size;
};

const DicomFrame& frameOf(const DicomSeries& series, const SliceSource& slice)
{
  return series.headers[slice.header].frames[slice.frame];
}

std::optional<Eigen::Vector3d> normalOf(const DicomFrame& frame)
{
  if (!frame.pose.axes_P) return std::nullopt;
  return frame.pose.axes_P->col(0).cross(frame.pose.axes_P->col(1));
}

std::pair<int, int> sizeOf(const DicomSeries& series, const SliceSource& slice)
{
  const DicomHeader& header = series.headers[slice.header];
  return {header.columns, header.rows};
}

// A scout lies across the slices; the gantry of a series does not turn by this much.
constexpr double minAligned = 0.98;  // cosine of 11 degrees

/// A size and a normal that most slices have; none where there is no majority.
std::optional<Usual> usualOf(const DicomSeries& series)
{
  std::map<std::pair<int, int>, std::size_t> sizes;
  for (const SliceSource& slice : series.slices) ++sizes[sizeOf(series, slice)];
  const auto maximum = std::max_element(
      sizes.begin(), sizes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  const std::size_t all = series.slices.size();
  if (maximum == sizes.end() || 2 * maximum->second <= all) return std::nullopt;
  // one of any three that do not agree is of the majority, if there is one
  for (const std::size_t i : {std::size_t{0}, all / 3, all / 2, all - 1}) {
    const auto normal = normalOf(frameOf(series, series.slices[i]));
    if (!normal) continue;
    const auto aligned =
        std::count_if(series.slices.begin(), series.slices.end(), [&](const SliceSource& slice) {
          const auto own = normalOf(frameOf(series, slice));
          return own && own->dot(*normal) > minAligned;
        });
    if (2 * static_cast<std::size_t>(aligned) > all) return Usual{*normal, maximum->first};
  }
  return std::nullopt;
}

/// Leaves out a lone image or two of another size or lying across the slices, as unmarked scouts do.
void leaveOutLoneImages(DicomSeries& series)
{
  constexpr std::size_t maxLone = 2, slicesForEach = 4;
  const auto usual = usualOf(series);
  if (!usual) return;
  const auto isLone = [&](const SliceSource& slice) {
    const auto normal = normalOf(frameOf(series, slice));
    return sizeOf(series, slice) != usual->size ||
           (normal && std::fabs(normal->dot(usual->normal_P)) < minAligned);
  };
  std::vector<SliceSource> lone;
  std::copy_if(series.slices.begin(), series.slices.end(), std::back_inserter(lone), isLone);
  if (lone.empty() || lone.size() > maxLone || series.slices.size() < slicesForEach * lone.size())
    return;
  std::erase_if(series.slices, isLone);
  for (const SliceSource& slice : lone)
    doubt(series, Sentence(warnings::loneImage, {nameOf(series.headers[slice.header])}));
}

void setUp(DicomSeries& series)
{
  std::size_t scouts = 0;
  for (std::size_t h = 0; h < series.headers.size(); ++h)
    for (std::size_t f = 0; f < series.headers[h].frames.size(); ++f) {
      if (series.headers[h].frames[f].isLocalizer)
        ++scouts;
      else
        series.slices.push_back({h, f});
    }
  if (scouts > 0 && !series.slices.empty())
    series.summary.warnings.push_back(Sentence(warnings::scouts, {std::to_string(scouts)}));
  leaveOutLoneImages(series);
}

void stackUp(DicomSeries& series)
{
  CtSeries& summary = series.summary;
  std::vector<ct::SlicePose> poses;
  for (const SliceSource& slice : series.slices)
    poses.push_back(series.headers[slice.header].frames[slice.frame].pose);
  auto stack = ct::stackSlices(poses);
  if (!stack) {
    summary.obstacle = stack.error().message;
    return;
  }
  summary.size[2] = static_cast<int>(stack->places.size());
  summary.spacing_mm.z() = stack->planeDistance_mm();
  if (const std::size_t more = poses.size() - stack->places.size(); more > 0)
    summary.warnings.push_back(Sentence(warnings::samePlace, {std::to_string(more)}));
  if (stack->tilt_deg > maxTilt_deg) {
    char tilt[16];
    std::snprintf(tilt, sizeof tilt, "%.1f", stack->tilt_deg);
    summary.warnings.push_back(Sentence(warnings::tilted, {std::string(tilt)}));
  }
  series.stack = std::move(*stack);
}

void describe(DicomSeries& series)
{
  setUp(series);
  CtSeries& summary = series.summary;
  const DicomHeader& first = series.headers.front();
  summary.key = seriesKeyOf(summary.uid);
  summary.format = "DICOM";
  summary.modality = statedModality(first);
  summary.scanner = first.scanner;
  summary.kernel = first.kernel;
  summary.size = {first.columns, first.rows,
                  static_cast<int>(std::max(series.slices.size(), series.headers.size()))};
  if (!first.frames.empty() && first.frames.front().pixelSpacing_mm)
    summary.spacing_mm.head<2>() = *first.frames.front().pixelSpacing_mm;
  if (!series.slices.empty()) {
    const SliceSource& slice = series.slices.front();
    summary.size[0] = series.headers[slice.header].columns;
    summary.size[1] = series.headers[slice.header].rows;
    if (frameOf(series, slice).pixelSpacing_mm)
      summary.spacing_mm.head<2>() = *frameOf(series, slice).pixelSpacing_mm;
  }
  summary.obstacle = obstacleOf(series);
  if (!summary.obstacle.empty()) return;
  stackUp(series);
  if (!summary.obstacle.empty()) return;
  summary.obstacle = orderObstacleOf(series);
  if (!summary.obstacle.empty()) return;
  for (const Sentence& sentence : doubtsOf(series)) doubt(series, sentence);
  const auto isLossy = [](const DicomHeader& header) { return header.isLossy; };
  if (countOf(series.headers, isLossy) > 0) summary.warnings.push_back(Sentence(warnings::lossy));
  const auto isDerived = [](const DicomHeader& header) { return header.isDerived; };
  const bool isAnyDerived = countOf(series.headers, isDerived) > 0;
  if (isAnyDerived) summary.warnings.push_back(Sentence(warnings::derived));
  addSizeWarnings(summary);
  summary.score = scoreOf(summary, isAnyDerived);
}

/// Files in the folders of a series that are cut off so early that they name no series.
std::vector<Sentence> lostBeside(const std::vector<DicomHeader>& headers,
                                 const std::vector<std::filesystem::path>& stumps)
{
  std::vector<Sentence> sentences;
  for (const std::filesystem::path& stump : stumps) {
    const auto isBeside = [&stump](const DicomHeader& header) {
      return header.file.parent_path() == stump.parent_path();
    };
    if (std::none_of(headers.begin(), headers.end(), isBeside)) continue;
    DicomHeader named;
    named.file = stump;
    sentences.push_back(Sentence(warnings::stump, {nameOf(named)}));
  }
  return sentences;
}

}  // namespace

std::string seriesKeyOf(const std::string& uid)
{
  Sha256 hash;
  hash.add(std::string_view(uid));
  return hash.hex();
}

std::vector<DicomSeries> seriesOf(DicomFiles files)
{
  std::set<std::string> patients;
  for (const DicomHeader& header : files.headers) {
    if (!header.identity.patient.empty()) patients.insert(header.identity.patient);
    if (header.seriesUid.empty() && (header.isTruncated || !header.notParsed.empty()))
      files.stumps.push_back(header.file);
  }
  std::vector<DicomSeries> all;
  for (SeriesGroup& group : groupsOf(std::move(files.headers))) {
    DicomSeries series;
    series.summary.uid = std::move(group.uid);
    for (const Sentence& warning : files.warnings) doubt(series, warning);
    if (patients.size() > 1)
      doubt(series, Sentence(warnings::patients, {std::to_string(patients.size())}));
    if (!group.warning.empty()) doubt(series, group.warning);
    for (const Sentence& lost : lostBeside(group.headers, files.stumps)) doubt(series, lost);
    series.headers = std::move(group.headers);
    describe(series);
    all.push_back(std::move(series));
  }
  std::stable_sort(all.begin(), all.end(), [](const DicomSeries& a, const DicomSeries& b) {
    return a.summary.score > b.summary.score;
  });
  return all;
}

}  // namespace perilymph::imaging
