// SPDX-License-Identifier: BSD-3-Clause
#include "SeriesDoubts.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "../statements/Warnings.h"
#include "DicomStatements.h"
#include "SeriesChecks.h"

namespace perilymph::imaging {
namespace {

constexpr Phrase aSeries{"The series"};

/// A slice in the order of the stack.
struct Placed {
  std::size_t place;
  const DicomHeader& header;
  const DicomFrame& frame;

  Sentence which(std::size_t count) const
  {
    return Sentence{" of slice %1 of %2 (%3)", place + 1, count, nameOf(header)};
  }
};

std::vector<Placed> inOrder(const DicomSeries& series)
{
  std::vector<Placed> slices;
  for (std::size_t k = 0; k < series.stack->places.size(); ++k)
    for (const std::size_t i : series.stack->places[k]) {
      const SliceSource& slice = series.slices[i];
      const DicomHeader& header = series.headers[slice.header];
      slices.push_back({k, header, header.frames[slice.frame]});
    }
  return slices;
}

std::string lengthText(double value)
{
  std::array<char, 40> text{};
  const auto done =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 4);
  return {text.data(), done.ptr};
}

using Doubt = std::optional<Sentence>;

/// Headers of a tilted gantry give the step of the table or the distance of the planes.
double nearer(double value, const ct::SliceStack& stack)
{
  const double plane = stack.planeDistance_mm(), table = stack.step_P.norm();
  return std::fabs(value - plane) <= std::fabs(value - table) ? plane : table;
}

Doubt stepDoubt(const DicomSeries& series, const std::vector<Placed>& slices)
{
  for (const Placed& slice : slices) {
    if (!slice.frame.spacing_mm) continue;
    const double stated = std::fabs(*slice.frame.spacing_mm);
    if (auto found =
            disagreement(Sentence(aSeries), dicomPairs::step, nearer(stated, *series.stack), stated,
                         slice.which(series.stack->places.size())))
      return found;
  }
  return std::nullopt;
}

/// Slices may overlap by much and still be right; what lies between thinner ones was not measured.
Doubt thicknessDoubt(const DicomSeries& series, const std::vector<Placed>& slices)
{
  constexpr double gap = 0.995, overlap = 5.0;
  for (const Placed& slice : slices) {
    if (!slice.frame.thickness_mm) continue;
    const double thickness = *slice.frame.thickness_mm;
    const double step = nearer(thickness, *series.stack);
    if (thickness >= gap * step && thickness <= overlap * step) continue;
    return Sentence(thickness < step ? warnings::gaps : warnings::overlap,
                    {std::to_string(slice.place + 1), std::to_string(series.stack->places.size()),
                     nameOf(slice.header), lengthText(thickness), lengthText(step)});
  }
  return std::nullopt;
}

Doubt locationDoubt(const DicomSeries& series, const std::vector<Placed>& slices)
{
  std::vector<Placed> located;
  for (const Placed& slice : slices)
    if (slice.frame.location_mm) located.push_back(slice);
  if (located.size() < 2 || located.front().place == located.back().place) return std::nullopt;
  const Placed& first = located.front();
  const double span = *located.back().frame.location_mm - *first.frame.location_mm;
  const auto steps = static_cast<double>(located.back().place - first.place);
  const double step = nearer(std::fabs(span) / steps, *series.stack);
  if (auto found =
          disagreement(Sentence(aSeries), dicomPairs::location, steps * step, std::fabs(span)))
    return found;
  for (const Placed& slice : located) {
    const double up =
        (span < 0.0 ? -1.0 : 1.0) * (*slice.frame.location_mm - *first.frame.location_mm);
    if (auto found = disagreement(Sentence(aSeries), dicomPairs::locationOfSlice,
                                  step * static_cast<double>(slice.place - first.place), up,
                                  slice.which(series.stack->places.size())))
      return found;
  }
  return std::nullopt;
}

Doubt fieldDoubt(const DicomSeries&, const std::vector<Placed>& slices)
{
  for (const Placed& slice : slices) {
    const auto& diameter = slice.header.reconstructionDiameter_mm;
    if (!diameter || !slice.frame.pixelSpacing_mm) continue;
    const double width = slice.header.columns * slice.frame.pixelSpacing_mm->x();
    const double height = slice.header.rows * slice.frame.pixelSpacing_mm->y();
    const bool isHeight = std::fabs(height - *diameter) < std::fabs(width - *diameter);
    if (auto found = disagreement(Sentence(aSeries), dicomPairs::fieldOfView,
                                  isHeight ? height : width, *diameter))
      return found;
  }
  return std::nullopt;
}

Doubt imagerDoubt(const DicomSeries&, const std::vector<Placed>& slices)
{
  for (const Placed& slice : slices) {
    const auto& imager = slice.header.imagerSpacing_mm;
    const auto& own = slice.frame.pixelSpacing_mm;
    if (!imager || !own) continue;
    if (auto found =
            disagreement(Sentence(aSeries), dicomPairs::imagerColumns, own->x(), imager->x()))
      return found;
    if (auto found = disagreement(Sentence(aSeries), dicomPairs::imagerRows, own->y(), imager->y()))
      return found;
  }
  return std::nullopt;
}

Doubt tiltDoubt(const DicomSeries& series, const std::vector<Placed>& slices)
{
  for (const Placed& slice : slices)
    if (slice.header.gantryTilt_deg)
      if (auto found = disagreement(Sentence(aSeries), dicomPairs::tilt, series.stack->tilt_deg,
                                    std::fabs(*slice.header.gantryTilt_deg)))
        return found;
  return std::nullopt;
}

/// The value of a setting, by the beginning of its name.
std::string setting(const DicomHeader& header, const char* name)
{
  for (const auto& [tag, value] : header.settings)
    if (tag.starts_with(name)) return value;
  return {};
}

Doubt countDoubt(const DicomSeries& series, const std::vector<Placed>&)
{
  std::map<std::string, std::size_t> images;
  for (const DicomHeader& header : series.headers)
    images[setting(header, "AcquisitionNumber")] += header.frames.size();
  for (const DicomHeader& header : series.headers)
    if (header.imagesInAcquisition && *header.imagesInAcquisition > 0)
      if (auto found =
              disagreement(Sentence(aSeries), dicomPairs::imagesInAcquisition,
                           static_cast<double>(images[setting(header, "AcquisitionNumber")]),
                           static_cast<double>(*header.imagesInAcquisition)))
        return found;
  return std::nullopt;
}

/// Settings of one reconstruction that change somewhere. The number of an acquisition may, but not back.
Doubt settingsDoubt(const DicomSeries& series, const std::vector<Placed>& slices)
{
  const auto& settings = slices.front().header.settings;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const Changes changes = changesOf(series, i);
    if (changes.count == 0) continue;
    if (settings[i].first.starts_with("AcquisitionNumber") && !changes.returns) continue;
    return Sentence(warnings::settings,
                    {settings[i].first, changes.example.first, changes.example.second});
  }
  return std::nullopt;
}

Doubt modalityDoubt(const DicomSeries& series, const std::vector<Placed>&)
{
  if (!series.headers.front().modality.empty()) return std::nullopt;
  return Sentence(warnings::noModality,
                  {series.summary.modality.empty() ? "OT" : series.summary.modality});
}

Doubt classDoubt(const DicomSeries& series, const std::vector<Placed>&)
{
  for (const DicomHeader& header : series.headers)
    if (!header.mediaClass.empty() && !header.sopClass.empty())
      if (auto found = disagreement(Sentence(aSeries), dicomPairs::mediaClass, header.sopClass,
                                    header.mediaClass, Sentence{" in %1", nameOf(header)}))
        return found;
  return std::nullopt;
}

Doubt grayDoubt(const DicomSeries& series, const std::vector<Placed>&)
{
  Sentence warning = grayValueWarning(series);
  return warning.empty() ? Doubt() : Doubt(std::move(warning));
}

/// The letter of the patient's direction that an axis points along most.
char letterOf(const Eigen::Vector3d& axis_P)
{
  constexpr std::array<std::array<char, 2>, 3> letters{{{'R', 'L'}, {'A', 'P'}, {'F', 'H'}}};
  Eigen::Index along = 0;
  axis_P.cwiseAbs().maxCoeff(&along);
  return letters[static_cast<std::size_t>(along)][axis_P[along] > 0.0 ? 1 : 0];
}

/// Oblique axes may be named by any direction that they are within 60 degrees of.
bool pointsTo(const Eigen::Vector3d& axis_P, char letter)
{
  constexpr double minimum = 0.5;
  const std::string positive = "LPH", negative = "RAF";
  if (const auto i = positive.find(letter); i != std::string::npos)
    return axis_P[static_cast<Eigen::Index>(i)] >= minimum;
  if (const auto i = negative.find(letter); i != std::string::npos)
    return axis_P[static_cast<Eigen::Index>(i)] <= -minimum;
  return true;  // the orientation of animals
}

Doubt directionDoubt(const DicomSeries& series, const std::vector<Placed>& slices)
{
  for (const Placed& slice : slices) {
    const std::string& stated = slice.header.patientOrientation;
    const auto split = stated.find('\\');
    if (split == std::string::npos || split == 0 || split + 1 == stated.size()) continue;
    const auto& axes = *slice.frame.pose.axes_P;
    if (pointsTo(axes.col(0), stated[0]) && pointsTo(axes.col(1), stated[split + 1])) continue;
    const std::string own{letterOf(axes.col(0)), '\\', letterOf(axes.col(1))};
    return disagreement(Sentence(aSeries), dicomPairs::directions, own, stated,
                        slice.which(series.stack->places.size()));
  }
  return std::nullopt;
}

/// The numbers of a stack's images run up or down along it, with gaps where images were left out.
Doubt orderDoubt(const DicomSeries& series, const std::vector<Placed>& slices)
{
  std::vector<double> numbers;
  for (const Placed& slice : slices) {
    if (slice.header.frames.size() != 1 || !slice.header.instanceNumber) return std::nullopt;
    if (slice.place == numbers.size()) numbers.push_back(*slice.header.instanceNumber);
  }
  if (numbers.size() < 2) return std::nullopt;
  const bool isFalling = numbers.back() < numbers.front();
  for (const Placed& slice : slices) {
    const double own = numbers[slice.place];
    const auto before = std::count_if(numbers.begin(), numbers.end(), [&](double each) {
      return isFalling ? each > own : each < own;
    });
    if (auto found = disagreement(
            Sentence(aSeries), dicomPairs::imageNumber, static_cast<double>(slice.place + 1),
            static_cast<double>(before + 1), slice.which(series.stack->places.size())))
      return found;
  }
  return std::nullopt;
}

Doubt instanceDoubt(const DicomSeries& series, const std::vector<Placed>& slices)
{
  std::map<std::string, std::size_t> places;
  for (const Placed& slice : slices) {
    if (slice.header.frames.size() != 1 || slice.header.instanceUid.empty()) continue;
    const auto [known, isNew] = places.try_emplace(slice.header.instanceUid, slice.place);
    if (isNew || known->second == slice.place) continue;
    return Sentence(warnings::sameInstance,
                    {std::to_string(known->second + 1), std::to_string(slice.place + 1),
                     std::to_string(series.stack->places.size())});
  }
  return std::nullopt;
}

Doubt sideDoubt(const DicomSeries&, const std::vector<Placed>& slices)
{
  for (const Placed& slice : slices)
    if (!slice.header.laterality.empty() && !slice.header.imageLaterality.empty())
      if (auto found = disagreement(Sentence(aSeries), dicomPairs::side, slice.header.laterality,
                                    slice.header.imageLaterality))
        return found;
  return std::nullopt;
}

Doubt realWorldDoubt(const DicomSeries&, const std::vector<Placed>& slices)
{
  for (const Placed& slice : slices) {
    const auto& scale = slice.header.realWorldScale;
    if (!scale) continue;
    if (auto found = disagreement(Sentence(aSeries), dicomPairs::realWorldSlope, slice.frame.slope,
                                  (*scale)[0]))
      return found;
    if (auto found = disagreement(Sentence(aSeries), dicomPairs::realWorldIntercept,
                                  slice.frame.intercept, (*scale)[1]))
      return found;
  }
  return std::nullopt;
}

}  // namespace

std::vector<Sentence> doubtsOf(const DicomSeries& series)
{
  const std::vector<Placed> slices = inOrder(series);
  std::vector<Sentence> doubts;
  for (const auto check :
       {modalityDoubt, classDoubt, grayDoubt, stepDoubt, thicknessDoubt, locationDoubt, fieldDoubt,
        imagerDoubt, tiltDoubt, countDoubt, settingsDoubt, directionDoubt, orderDoubt,
        instanceDoubt, sideDoubt, realWorldDoubt})
    if (auto found = check(series, slices)) doubts.push_back(*std::move(found));
  return doubts;
}

}  // namespace perilymph::imaging
