// SPDX-License-Identifier: BSD-3-Clause

// The cochlea in a CT after surgery: carried over from the CT before it, or measured without the metal.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include "MetalSpiral.h"
#include "RigidMotion.h"
#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/anatomy/EarWords.h"
#include "perilymph/anatomy/Population.h"
#include "perilymph/outcome/FoundArray.h"

namespace perilymph::outcome {

namespace {

using Eigen::Vector3d;

constexpr double minCorrelation = 0.6,
                 maxResidual_mm = 0.6;  // below and above, the CTs agree badly
constexpr double aroundMetal_mm = 0.5;  // without weight beside metal: blooming
constexpr double metalGrain_mm = 0.4, aroundClick_mm = 10.0;
constexpr double averagedOver_mm = 0.25;  // on both sides
constexpr double brightest_mm3 = 15.0;    // contacts, as they are blurred
constexpr double boneFrom = 600.0;        // intensities of bone and metal
constexpr double boneQuantile = 0.9;

/// The scala tympani of measured A, B and H, as for a patient of them.
Result<std::shared_ptr<const anatomy::ScalaTympani>> scalaOf(const ct::CochleaMeasures& measures)
{
  anatomy::Cochlea cochlea;
  cochlea.source = anatomy::sourceScaledBy(anatomy::PatientMeasures::basalTurn);
  cochlea.patient.side = measures.side;
  cochlea.patient.basalTurn = anatomy::BasalTurn{millimeters(measures.a.value),
                                                 millimeters(measures.b.value), std::nullopt};
  const anatomy::Spread limits = anatomy::limitsOfH();
  const double h =
      std::clamp(measures.h.value, inMillimeters(limits.low), inMillimeters(limits.high));
  if (std::fabs(h - measures.h.value) < 2.0 * measures.h.sd())
    cochlea.patient.basalTurn->h = millimeters(h);
  if (!anatomy::checkPatient(cochlea.patient)) cochlea.patient.basalTurn->h = std::nullopt;
  return anatomy::buildAnatomy(cochlea, "the cochlea of this CT");
}

/// The measures in the frame of another CT.
ct::CochleaMeasures moved(ct::CochleaMeasures measures, const RigidMotion& motion)
{
  for (Vector3d* point : {&measures.center_P, &measures.roundWindow_P, &measures.anatomyOrigin_P})
    *point = motion.apply(*point);
  measures.axis_P = motion.rotation * measures.axis_P;
  measures.axes_PW = motion.rotation * measures.axes_PW;
  measures.anatomyAxes_PW = motion.rotation * measures.anatomyAxes_PW;
  for (Vector3d& point : measures.wall_P) point = motion.apply(point);
  measures.otherCochlea_P.reset();
  for (auto& mark : measures.marksByHand.points_P)
    if (mark) mark = motion.apply(*mark);
  return measures;
}

/// Voxels averaged over about half a millimeter, so that noise in bone is no metal; coarse voxels stay.
std::vector<std::int16_t> averaged(const ct::CtVolume& volume)
{
  const auto& size = volume.size();
  std::vector<std::int16_t> voxels(volume.voxels().begin(), volume.voxels().end());
  const std::array<std::size_t, 3> stride{
      1, static_cast<std::size_t>(size[0]),
      static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1])};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int reach =
        static_cast<int>(averagedOver_mm / volume.spacing_mm()[static_cast<int>(axis)]);
    if (reach == 0) continue;
    const std::vector<std::int16_t> before = voxels;
    const int count = size[axis];
    for (std::size_t at = 0; at < voxels.size(); ++at) {
      const int place = static_cast<int>((at / stride[axis]) % static_cast<std::size_t>(count));
      const int from = std::max(-reach, -place), to = std::min(reach, count - 1 - place);
      int sum = 0;
      for (int off = from; off <= to; ++off)
        sum +=
            before[at + static_cast<std::size_t>(static_cast<std::ptrdiff_t>(stride[axis]) * off)];
      voxels[at] = static_cast<std::int16_t>(sum / (to - from + 1));
    }
  }
  return voxels;
}

/// Intensity above which an averaged voxel is metal.
Result<double> metalLevel(const std::vector<std::int16_t>& voxels)
{
  std::vector<std::int16_t> bone;
  for (std::size_t i = 0; i < voxels.size(); i += 3)
    if (voxels[i] > boneFrom) bone.push_back(voxels[i]);
  if (bone.size() < 100) return Error{"The CT shows no bone. Choose a CT of the temporal bone."};
  const auto level = bone.begin() + static_cast<std::ptrdiff_t>(
                                        boneQuantile * static_cast<double>(bone.size() - 1));
  std::nth_element(bone.begin(), level, bone.end());
  return std::max(1.3 * *level, *level + 500.0);
}

/// Points of the brightest metal, which are contacts where no other implant is seen; those near a point if it is
/// given.
std::vector<Vector3d> brightestMetal(const ct::CtVolume& volume,
                                     const std::vector<std::int16_t>& voxels, double level,
                                     const std::optional<Vector3d>& near_P)
{
  struct Bright {
    std::int16_t value;
    Vector3d at_P;
  };
  const auto& size = volume.size();
  const Eigen::Matrix4d lpsFromIndex = volume.lpsFromIndex();
  std::vector<Bright> metal;
  std::size_t at = 0;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i, ++at) {
        if (voxels[at] <= level) continue;
        const Vector3d at_P = (lpsFromIndex * Eigen::Vector4d(i, j, k, 1.0)).head<3>();
        if (!near_P || (at_P - *near_P).norm() < aroundClick_mm)
          metal.push_back({voxels[at], at_P});
      }
  std::stable_sort(metal.begin(), metal.end(),
                   [](const Bright& a, const Bright& b) { return a.value > b.value; });
  const auto count =
      std::min(metal.size(), static_cast<std::size_t>(brightest_mm3 / volume.spacing_mm().prod()));
  std::set<std::array<int, 3>> taken;  // one point in a grain
  std::vector<Vector3d> points_P;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3d grain = (metal[i].at_P / metalGrain_mm).array().floor();
    if (taken
            .insert({static_cast<int>(grain[0]), static_cast<int>(grain[1]),
                     static_cast<int>(grain[2])})
            .second)
      points_P.push_back(metal[i].at_P);
  }
  return points_P;
}

/// The volume with metal and what is beside it marked as not measured.
/// @param averaged  Its voxels, averaged.
Result<ct::CtVolume> withoutMetal(const ct::CtVolume& volume,
                                  const std::vector<std::int16_t>& averaged, double level)
{
  std::vector<std::int16_t> voxels(volume.voxels().begin(), volume.voxels().end());
  const auto& size = volume.size();
  const Vector3d spacing = volume.spacing_mm();
  const std::array<int, 3> reach{static_cast<int>(aroundMetal_mm / spacing[0]),
                                 static_cast<int>(aroundMetal_mm / spacing[1]),
                                 static_cast<int>(aroundMetal_mm / spacing[2])};
  const auto place = [&size](int i, int j, int k) {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size[1]) +
            static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(size[0]) +
           static_cast<std::size_t>(i);
  };
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        if (averaged[place(i, j, k)] <= level) continue;
        for (int c = std::max(0, k - reach[2]); c <= std::min(size[2] - 1, k + reach[2]); ++c)
          for (int b = std::max(0, j - reach[1]); b <= std::min(size[1] - 1, j + reach[1]); ++b)
            for (int a = std::max(0, i - reach[0]); a <= std::min(size[0] - 1, i + reach[0]); ++a)
              voxels[place(a, b, c)] = ct::unmeasured;
      }
  return ct::CtVolume::make(size, volume.lpsFromIndex(), std::move(voxels), volume.provenance());
}

}  // namespace

Result<Ear> registeredEar(const ct::CtVolume& postoperative, const ct::CtVolume& preoperative,
                          const ct::CochleaMeasures& measured, const std::stop_token& stop,
                          const std::function<void(double)>& onProgress)
{
  const auto motion =
      registration(preoperative, measured.center_P, postoperative, stop, onProgress);
  if (!motion) return motion.error();
  Ear ear;
  ear.measures = moved(measured, *motion);
  auto scala = scalaOf(measured);
  if (!scala) return scala.error();
  ear.scala = *std::move(scala);
  ear.isRegistered = true;
  ear.residual_mm = motion->residual_mm;
  if (motion->correlation < minCorrelation || motion->residual_mm > maxResidual_mm)
    ear.flags.push_back(Flag::registrationPoor);
  if (measured.has(ct::Flag::poorFit)) ear.flags.push_back(Flag::earFitPoor);
  return ear;
}

Result<Ear> measuredEar(const ct::CtVolume& postoperative, const ct::MeasureRequest& request)
{
  const std::vector<std::int16_t> smooth = averaged(postoperative);
  const auto level = metalLevel(smooth);
  if (!level) return level.error();
  const auto masked = withoutMetal(postoperative, smooth, *level);
  if (!masked) return masked.error();
  // what is left of the lumen beside an array is found less surely than the array
  ct::MeasureRequest around = request;
  if (request.marks.isEmpty())
    around.starts = cochleaeAroundMetal(
        brightestMetal(postoperative, smooth, *level, request.click_P), request.side, request.stop);
  auto measures = ct::measureCochlea(*masked, around);
  if (!measures && !around.starts.empty() && !request.stop.stop_requested())
    measures = ct::measureCochlea(*masked, request);
  if (!measures && !request.stop.stop_requested()) {
    // without an array the brightest bone was taken for metal: the ear is there, and the search says what is not
    auto whole = ct::measureCochlea(postoperative, request);
    if (whole && !whole->has(ct::Flag::metal)) measures = std::move(whole);
  }
  if (!measures) return measures.error();
  Ear ear;
  auto scala = scalaOf(*measures);
  if (!scala) return scala.error();
  ear.scala = *std::move(scala);
  ear.measures = *std::move(measures);
  ear.flags.push_back(Flag::earFromThisCt);
  if (ear.measures.has(ct::Flag::poorFit)) ear.flags.push_back(Flag::earFitPoor);
  return ear;
}

std::optional<Sentence> differenceFrom(const Ear& ear, const anatomy::Patient& patient)
{
  if (ear.measures.side != patient.side)
    return Sentence{"This CT shows the %1, and the patient's is the %2.",
                    anatomy::earOf(ear.measures.side), anatomy::earOf(patient.side)};
  if (std::find(ear.flags.begin(), ear.flags.end(), Flag::registrationPoor) != ear.flags.end())
    return Sentence{"The CTs before and after surgery do not agree around the cochlea."};
  if (!patient.basalTurn) return std::nullopt;
  const auto differs = [](const ct::Measure& here, Length there, Length error) {
    constexpr double beyond = 3.0;
    return std::fabs(here.value - inMillimeters(there)) >
           beyond * std::hypot(here.sd(), inMillimeters(error));
  };
  constexpr Length usual = millimeters(0.1);
  const anatomy::BasalTurnErrors errors =
      patient.errors.value_or(anatomy::BasalTurnErrors{usual, usual});
  if (differs(ear.measures.a, patient.basalTurn->a, errors.a))
    return Sentence{"A is %1 mm in this CT, and %2 mm for the patient.",
                    ct::millimetersOf(ear.measures.a.value),
                    ct::millimetersOf(inMillimeters(patient.basalTurn->a))};
  if (differs(ear.measures.b, patient.basalTurn->b, errors.b))
    return Sentence{"B is %1 mm in this CT, and %2 mm for the patient.",
                    ct::millimetersOf(ear.measures.b.value),
                    ct::millimetersOf(inMillimeters(patient.basalTurn->b))};
  return std::nullopt;
}

}  // namespace perilymph::outcome
