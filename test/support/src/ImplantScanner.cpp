// SPDX-License-Identifier: BSD-3-Clause
#include "ImplantScanner.h"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "CtPhantomAnatomy.h"
#include "XrayBeam.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::test {
namespace {

constexpr double fieldOfView_mm = 22.0;
// The anatomy is known to this distance from the axis of rotation; it fades within the last millimeter.
constexpr double detailRadius_mm = 15.0;
constexpr int views = 600;
constexpr double fineStep_mm = 0.05;
constexpr double softTissue = 60.0;  // [HU]
constexpr double meanBone = 0.5;  // of the homogeneous temporal bone, in parts of the beam's bone
constexpr double scatterLeft = 0.2;  // of the scatter after its correction: choice, low
constexpr int polynomial = 5;

/// A homogeneous ellipse of the head, its center from the ear [mm].
struct Ellipse {
  double x, y, a, b;

  double chord(double cosine, double sine, double u) const
  {
    const double s2 = a * a * cosine * cosine + b * b * sine * sine;
    const double t = u - x * cosine - y * sine;
    return t * t < s2 ? 2.0 * a * b * std::sqrt(s2 - t * t) / s2 : 0.0;
  }
};

/// Line integrals through water and bone [mm].
struct Path {
  double water = 0.0, bone = 0.0;
};

/// A head of 144 by 184 mm with a skull of 6 mm and both temporal bones; sizes are choices, confidence medium.
class Head {
public:
  explicit Head(bool isRight) : toMiddle_(isRight ? 45.0 : -45.0) {}

  Path through(double cosine, double sine, double u) const
  {
    const Ellipse outer{toMiddle_, 5.0, 72.0, 92.0}, inner{toMiddle_, 5.0, 66.0, 86.0};
    const Ellipse ear{0.0, 0.0, 20.0, 18.0}, other{2.0 * toMiddle_, 0.0, 20.0, 18.0};
    const double all = outer.chord(cosine, sine, u);
    const double bone = 0.8 * (all - inner.chord(cosine, sine, u)) +
                        meanBone * (ear.chord(cosine, sine, u) + other.chord(cosine, sine, u));
    return {(1.0 + 1e-3 * softTissue) * (all - bone), bone};
  }

private:
  double toMiddle_;
};

/// Makes a logged projection proportional to the length of water.
class WaterCorrection {
public:
  explicit WaterCorrection(const XrayBeam& beam)
  {
    constexpr int samples = 120;
    constexpr double step_mm = 5.0;
    Eigen::MatrixXd powers(samples, polynomial);
    Eigen::VectorXd wanted(samples);
    for (int i = 0; i < samples; ++i) {
      const double length = step_mm * i;
      double left = 0.0;
      for (std::size_t e = 0; e < XrayBeam::bins; ++e)
        left += static_cast<double>(beam.weight[e]) *
                std::exp(-static_cast<double>(beam.water[e]) * length);
      double power = 1.0;
      for (int k = 0; k < polynomial; ++k) powers(i, k) = power *= -std::log(left);
      wanted[i] = beam.reference() * length;
    }
    const Eigen::VectorXd solved = powers.colPivHouseholderQr().solve(wanted);
    for (int k = 0; k < polynomial; ++k)
      factors_[static_cast<std::size_t>(k)] = static_cast<float>(solved[k]);
  }

  float operator()(float logged) const
  {
    float sum = 0.0F;
    for (std::size_t k = polynomial; k-- > 0;) sum = (sum + factors_[k]) * logged;
    return sum;
  }

private:
  std::array<float, polynomial> factors_{};
};

/// The sampled kernel of the filtered back projection, for taps from -(count - 1) to count - 1 [1/mm].
std::vector<float> filterTaps(int count, double pitch, bool isBoneKernel)
{
  std::vector<float> taps;
  const double nyquist = 0.5 / pitch;
  constexpr int pieces = 2000;
  for (int n = -(count - 1); n < count; ++n) {
    double sum = 0.0;
    for (int i = 0; i < pieces; ++i) {
      const double x = (i + 0.5) / pieces;
      // Soft: Hann's window. Bone: middle frequencies are raised, up to twofold.
      const double window = isBoneKernel ? std::cos(0.5 * pi * x) * (1.0 + 7.0 * x * x)
                                         : std::pow(std::cos(0.5 * pi * x), 2);
      sum += x * window * std::cos(pi * n * x);
    }
    taps.push_back(static_cast<float>(2.0 * nyquist * nyquist * sum / pieces));
  }
  return taps;
}

/// Columns along the axis of rotation: one row of `slices` values for each place in the plane.
struct Columns {
  int slices;
  std::vector<float> values;
  float* row(std::size_t i) { return values.data() + i * static_cast<std::size_t>(slices); }
  const float* row(std::size_t i) const
  {
    return values.data() + i * static_cast<std::size_t>(slices);
  }
};

Columns columns(std::size_t rows, int slices)
{
  return {slices, std::vector<float>(rows * static_cast<std::size_t>(slices), 0.0F)};
}

/// Places in the plane, from the axis of rotation [mm].
struct Place {
  double x, y;
};

class Scanner {
public:
  Scanner(const ImplantScene& scene, const ImplantScan& scan, std::uint64_t seed)
      : scene_(scene),
        scan_(scan),
        dice_(seed ^ 0x5ca9U),
        beam_(tubeBeam()),
        correction_(beam_),
        reference_(beam_.reference()),
        meanHu_(softTissue + meanBone * (beam_.boneHu() - softTissue)),
        head_(scene.isRight),
        across_(static_cast<int>(fieldOfView_mm / scan.spacing_mm.x())),
        slices_(static_cast<int>(fieldOfView_mm / scan.spacing_mm.z())),
        pitch_(scan.detector_mm),
        elements_(2 * static_cast<int>(std::ceil((detailRadius_mm + 0.5) / scan.detector_mm)) + 1)
  {
    finePerElement_ = static_cast<int>(std::lround(pitch_ / fineStep_mm));
    finePerSlice_ = static_cast<int>(std::lround(scan.sliceProfile_mm / fineStep_mm));
    for (double& part : motion_) part = dice_.uniform(0.0, 2.0 * pi);
  }

  ct::CtVolume volume()
  {
    sampleAnatomy();
    const std::size_t rays = static_cast<std::size_t>(views) * static_cast<std::size_t>(elements_);
    sinogram_ = columns(rays, slices_);
    for (int view = 0; view < views; ++view) measure(view);
    Columns image = reconstructed(sinogram_);
    if (scan_.hasMetalCorrection) image = corrected(image);
    return made(image);
  }

private:
  double angleOf(int view) const { return pi * view / views; }
  double place(int element) const { return (element - elements_ / 2) * pitch_; }

  /// The head's shift along the detector during a view: a slow sway in the plane of the slices.
  double sway(int view) const
  {
    const double t = 2.0 * pi * view / views;
    const double x = std::sin(t + motion_[0]), y = std::sin(0.7 * t + motion_[1]);
    return 0.5 * scan_.motion_mm * (x * std::cos(angleOf(view)) + y * std::sin(angleOf(view)));
  }

  /// The anatomy as parts of water and bone, less the homogeneous temporal bone.
  void sampleAnatomy()
  {
    cell_ = std::min(0.2, pitch_);
    const int half = static_cast<int>(detailRadius_mm / cell_);
    for (int j = -half; j <= half; ++j)
      for (int i = -half; i <= half; ++i)
        if (std::hypot(i, j) * cell_ < detailRadius_mm) places_.push_back({i * cell_, j * cell_});
    water_ = columns(places_.size(), slices_);
    bone_ = columns(places_.size(), slices_);
    const double boneHu = beam_.boneHu();
    const int times = std::max(1, static_cast<int>(std::ceil(scan_.spacing_mm.z() / 0.2)));
    for (std::size_t p = 0; p < places_.size(); ++p) {
      const double r = std::hypot(places_[p].x, places_[p].y);
      const double seen = std::clamp(detailRadius_mm - r, 0.0, 1.0);
      for (int k = 0; k < slices_; ++k)
        for (int c = 0; c < times; ++c) {
          const double z = (k + (c + 0.5) / times - 0.5 * slices_) * scan_.spacing_mm.z();
          const double hu = scene_.intensity(
              scene_.center_P + Eigen::Vector3d(places_[p].x, places_[p].y, z), cell_);
          const double bone = std::max(0.0, (hu - softTissue) / (boneHu - softTissue));
          const double water = (1.0 - bone) * (1.0 + 1e-3 * std::min(hu, softTissue));
          const double meanWater = (1.0 - meanBone) * (1.0 + 1e-3 * softTissue);
          water_.row(p)[k] += static_cast<float>(seen * (water - meanWater) / times);
          bone_.row(p)[k] += static_cast<float>(seen * (bone - meanBone) / times);
        }
    }
  }

  /// Adds a material's line integrals, at the detector's elements.
  void project(const Columns& map, int view, Columns& onto) const
  {
    const double cosine = std::cos(angleOf(view)), sine = std::sin(angleOf(view)),
                 shift = sway(view);
    const auto area = static_cast<float>(cell_ * cell_ / pitch_);
    for (std::size_t p = 0; p < places_.size(); ++p) {
      const double at =
          (places_[p].x * cosine + places_[p].y * sine + shift) / pitch_ + elements_ / 2;
      const int low = static_cast<int>(std::floor(at));
      const auto high = static_cast<float>(at - low);
      const float* const from = map.row(p);
      float* const a = onto.row(static_cast<std::size_t>(low));
      float* const b = onto.row(static_cast<std::size_t>(low) + 1);
      const float first = area * (1.0F - high), second = area * high;
      for (int k = 0; k < slices_; ++k) {
        a[k] += first * from[k];
        b[k] += second * from[k];
      }
    }
  }

  /// Spreads a material's line integrals by the width of the focal spot.
  void spread(Columns& paths) const
  {
    const double part =
        std::min(0.25, scan_.focalSpot_mm * scan_.focalSpot_mm / 12.0 / (2.0 * pitch_ * pitch_));
    const auto side = static_cast<float>(part);
    const Columns sharp = paths;
    for (int i = 1; i + 1 < elements_; ++i)
      for (int k = 0; k < slices_; ++k) {
        const auto at = static_cast<std::size_t>(i);
        paths.row(at)[k] +=
            side * (sharp.row(at - 1)[k] + sharp.row(at + 1)[k] - 2.0F * sharp.row(at)[k]);
      }
  }

  /// The part of each energy that the metal takes from each element, by rows of elements and energies.
  void projectMetal(int view)
  {
    const int fineAcross = elements_ * finePerElement_, fineAlong = slices_ * finePerSlice_;
    const auto whole = static_cast<std::size_t>(fineAcross) * static_cast<std::size_t>(fineAlong);
    if (fineContacts_.empty()) {
      fineContacts_.assign(whole, 0.0F);
      fineWires_.assign(whole, 0.0F);
      blocked_.assign(
          static_cast<std::size_t>(elements_) * static_cast<std::size_t>(slices_) * XrayBeam::bins,
          0.0F);
    }
    std::fill(blocked_.begin(), blocked_.end(), 0.0F);
    isMetal_.assign(static_cast<std::size_t>(elements_) * static_cast<std::size_t>(slices_), 0);
    const double cosine = std::cos(angleOf(view)), sine = std::sin(angleOf(view)),
                 shift = sway(view);
    const double zStep = scan_.spacing_mm.z() / finePerSlice_;
    touched_.clear();
    for (const MetalPiece& piece : scene_.metal) {
      const Eigen::Vector3d at = piece.point - scene_.center_P;
      const double u =
          (at.x() * cosine + at.y() * sine + shift) / fineStep_mm + 0.5 * fineAcross - 0.5;
      const double z = at.z() / zStep + 0.5 * fineAlong - 0.5;
      const int i = static_cast<int>(std::floor(u)), k = static_cast<int>(std::floor(z));
      if (i < 0 || i + 1 >= fineAcross || k < 0 || k + 1 >= fineAlong) continue;
      std::vector<float>& map = piece.isContact ? fineContacts_ : fineWires_;
      const double length = piece.volume_mm3 / (fineStep_mm * zStep);
      for (int c = 0; c < 2; ++c)
        for (int a = 0; a < 2; ++a) {
          const auto cell = static_cast<std::size_t>(k + c) * static_cast<std::size_t>(fineAcross) +
                            static_cast<std::size_t>(i + a);
          if (fineContacts_[cell] == 0.0F && fineWires_[cell] == 0.0F) touched_.push_back(cell);
          map[cell] += static_cast<float>(length * std::abs(1.0 - a - (u - i)) *
                                          std::abs(1.0 - c - (z - k)));
        }
    }
    const double spot = std::max(scan_.focalSpot_mm, 1e-3);
    const float share = 1.0F / static_cast<float>(finePerElement_ * finePerSlice_);
    for (const std::size_t cell : touched_) {
      const int i = static_cast<int>(cell % static_cast<std::size_t>(fineAcross));
      const int k = static_cast<int>(cell / static_cast<std::size_t>(fineAcross)) / finePerSlice_;
      // The focal spot spreads it over the elements that it overlaps.
      const double middle = (i + 0.5) * fineStep_mm / pitch_, reach = 0.5 * spot / pitch_;
      const int first = std::max(0, static_cast<int>(std::floor(middle - reach)));
      const int last = std::min(elements_ - 1, static_cast<int>(std::floor(middle + reach)));
      std::array<float, XrayBeam::bins> taken{};
      for (std::size_t e = 0; e < XrayBeam::bins; ++e)
        taken[e] = share * (1.0F - std::exp(-beam_.platinum[e] * fineContacts_[cell] -
                                            beam_.wire[e] * fineWires_[cell]));
      for (int element = first; element <= last; ++element) {
        const double overlap = std::min(middle + reach, element + 1.0) -
                               std::max(middle - reach, static_cast<double>(element));
        const auto ray = static_cast<std::size_t>(element) * static_cast<std::size_t>(slices_) +
                         static_cast<std::size_t>(k);
        isMetal_[ray] = 1;
        for (std::size_t e = 0; e < XrayBeam::bins; ++e)
          blocked_[ray * XrayBeam::bins + e] +=
              static_cast<float>(overlap / (2.0 * reach)) * taken[e];
      }
      fineContacts_[cell] = fineWires_[cell] = 0.0F;
    }
  }

  /// One view: what the detector measures, corrected for water, less the homogeneous head.
  void measure(int view)
  {
    Columns water = columns(static_cast<std::size_t>(elements_), slices_);
    Columns bone = columns(static_cast<std::size_t>(elements_), slices_);
    project(water_, view, water);
    project(bone_, view, bone);
    spread(water);
    spread(bone);
    projectMetal(view);

    const double cosine = std::cos(angleOf(view)), sine = std::sin(angleOf(view));
    Columns primary = columns(static_cast<std::size_t>(elements_), slices_);
    std::vector<float> plain(static_cast<std::size_t>(elements_));
    double sum = 0.0;
    for (int i = 0; i < elements_; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const Path path = head_.through(cosine, sine, place(i));
      std::array<float, XrayBeam::bins> left{};
      for (std::size_t e = 0; e < XrayBeam::bins; ++e) {
        left[e] = beam_.weight[e] * std::exp(-beam_.water[e] * static_cast<float>(path.water) -
                                             beam_.bone[e] * static_cast<float>(path.bone));
        plain[at] += left[e];
      }
      float* const signal = primary.row(at);
      const float *const w = water.row(at), *const b = bone.row(at);
      for (std::size_t e = 0; e < XrayBeam::bins; ++e)
        for (int k = 0; k < slices_; ++k) {
          const auto ray = at * static_cast<std::size_t>(slices_) + static_cast<std::size_t>(k);
          const float open = isMetal_[ray] != 0 ? 1.0F - blocked_[ray * XrayBeam::bins + e] : 1.0F;
          signal[k] += left[e] * open * std::exp(-beam_.water[e] * w[k] - beam_.bone[e] * b[k]);
        }
      for (int k = 0; k < slices_; ++k) sum += static_cast<double>(signal[k]);
    }
    const double mean = sum / (static_cast<double>(elements_) * slices_);
    const double scatter = mean * scan_.scatterFraction / (1.0 - scan_.scatterFraction);
    for (int i = 0; i < elements_; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const auto rest = static_cast<float>(scatterLeft * scatter);
      const float expected = correction_(-std::log(plain[at] + rest));
      float* const row =
          sinogram_.row(static_cast<std::size_t>(view) * static_cast<std::size_t>(elements_) + at);
      for (int k = 0; k < slices_; ++k) {
        const double photons = scan_.photons * (static_cast<double>(primary.row(at)[k]) + scatter);
        const double deviation =
            std::sqrt(photons + scan_.electronicNoise * scan_.electronicNoise) * dice_.normal();
        const double seen =
            std::max(1.0, photons - scan_.photons * (1.0 - scatterLeft) * scatter + deviation) /
            scan_.photons;
        row[k] = correction_(static_cast<float>(-std::log(seen))) - expected;
      }
    }
  }

  /// Filtered back projection, in the plane of the volume's voxels [1/mm].
  Columns reconstructed(const Columns& sinogram) const
  {
    const std::vector<float> taps = filterTaps(elements_, pitch_, scan_.isBoneKernel);
    const auto size = static_cast<std::size_t>(across_);
    Columns image = columns(size * size, slices_);
    Columns filtered = columns(static_cast<std::size_t>(elements_), slices_);
    for (int view = 0; view < views; ++view) {
      std::fill(filtered.values.begin(), filtered.values.end(), 0.0F);
      const auto first = static_cast<std::size_t>(view) * static_cast<std::size_t>(elements_);
      for (int i = 0; i < elements_; ++i)
        for (int j = 0; j < elements_; ++j) {
          const float tap =
              static_cast<float>(pitch_) * taps[static_cast<std::size_t>(i - j + elements_ - 1)];
          const float* const from = sinogram.row(first + static_cast<std::size_t>(j));
          float* const onto = filtered.row(static_cast<std::size_t>(i));
          for (int k = 0; k < slices_; ++k) onto[k] += tap * from[k];
        }
      const double cosine = std::cos(angleOf(view)), sine = std::sin(angleOf(view));
      for (int y = 0; y < across_; ++y)
        for (int x = 0; x < across_; ++x) {
          const double at = (inPlane(x) * cosine + inPlane(y) * sine) / pitch_ + elements_ / 2;
          const int low = std::clamp(static_cast<int>(std::floor(at)), 0, elements_ - 2);
          const auto high = static_cast<float>(std::clamp(at - low, 0.0, 1.0));
          const float* const a = filtered.row(static_cast<std::size_t>(low));
          const float* const b = filtered.row(static_cast<std::size_t>(low) + 1);
          float* const onto =
              image.row(static_cast<std::size_t>(y) * size + static_cast<std::size_t>(x));
          const float first_ = (1.0F - high) * static_cast<float>(pi / views);
          const float second = high * static_cast<float>(pi / views);
          for (int k = 0; k < slices_; ++k) onto[k] += first_ * a[k] + second * b[k];
        }
    }
    return image;
  }

  double inPlane(int index) const { return (index + 0.5 - 0.5 * across_) * scan_.spacing_mm.x(); }

  double huOf(float deviation) const
  {
    // The homogeneous bone that was subtracted.
    return meanHu_ + 1000.0 * static_cast<double>(deviation) / reference_;
  }

  /// Replaces the traces of metal, found in the image, by straight lines along the detector; metal is put back.
  Columns corrected(const Columns& image) const
  {
    constexpr double metal =
        3000.0;  // [HU]: choice, as published corrections have it; confidence medium
    Columns trace = columns(static_cast<std::size_t>(elements_), slices_);
    Columns inpainted = sinogram_;
    for (int view = 0; view < views; ++view) {
      std::fill(trace.values.begin(), trace.values.end(), 0.0F);
      const double cosine = std::cos(angleOf(view)), sine = std::sin(angleOf(view));
      const double reach =
          0.5 * scan_.spacing_mm.x() * (std::abs(cosine) + std::abs(sine)) / pitch_ + 0.5;
      for (int y = 0; y < across_; ++y)
        for (int x = 0; x < across_; ++x) {
          const float* const from =
              image.row(static_cast<std::size_t>(y) * static_cast<std::size_t>(across_) +
                        static_cast<std::size_t>(x));
          const double at = (inPlane(x) * cosine + inPlane(y) * sine) / pitch_ + elements_ / 2;
          for (int k = 0; k < slices_; ++k)
            if (huOf(from[k]) > metal)
              for (int i = static_cast<int>(std::ceil(at - reach)); i <= at + reach; ++i)
                if (i >= 0 && i < elements_) trace.row(static_cast<std::size_t>(i))[k] = 1.0F;
        }
      const auto first = static_cast<std::size_t>(view) * static_cast<std::size_t>(elements_);
      for (int k = 0; k < slices_; ++k)
        for (int i = 1; i < elements_; ++i) {
          if (trace.row(static_cast<std::size_t>(i))[k] == 0.0F) continue;
          int end = i;
          while (end + 1 < elements_ && trace.row(static_cast<std::size_t>(end))[k] != 0.0F) ++end;
          const float before = inpainted.row(first + static_cast<std::size_t>(i - 1))[k];
          const float after = inpainted.row(first + static_cast<std::size_t>(end))[k];
          for (int j = i; j < end; ++j)
            inpainted.row(first + static_cast<std::size_t>(j))[k] =
                before +
                (after - before) * static_cast<float>(j - i + 1) / static_cast<float>(end - i + 1);
          i = end;
        }
    }
    Columns without = reconstructed(inpainted);
    for (std::size_t i = 0; i < without.values.size(); ++i)
      if (huOf(image.values[i]) > metal) without.values[i] = image.values[i];
    return without;
  }

  ct::CtVolume made(const Columns& image) const
  {
    const std::array<int, 3> size{across_, across_, slices_};
    Eigen::Matrix4d lps = Eigen::Matrix4d::Identity();
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      lps(axis, axis) = scan_.spacing_mm[axis];
      const double last = size[static_cast<std::size_t>(axis)] - 1;
      lps(axis, 3) = scene_.center_P[axis] - 0.5 * last * scan_.spacing_mm[axis];
    }
    const double highest = scan_.isClipped ? 3071.0 : 30710.0;
    std::vector<std::int16_t> voxels;
    for (int k = 0; k < slices_; ++k)
      for (std::size_t p = 0;
           p < static_cast<std::size_t>(across_) * static_cast<std::size_t>(across_); ++p)
        voxels.push_back(static_cast<std::int16_t>(
            std::lround(std::clamp(huOf(image.row(p)[k]), -1024.0, highest))));
    auto volume = ct::CtVolume::make(size, lps, std::move(voxels), {"", "", "phantom"});
    if (!volume) throw std::runtime_error(volume.error().message);
    return *std::move(volume);
  }

  const ImplantScene& scene_;
  const ImplantScan& scan_;
  Dice dice_;
  XrayBeam beam_;
  WaterCorrection correction_;
  double reference_, meanHu_;
  Head head_;
  int across_, slices_;
  double pitch_;
  int elements_;
  int finePerElement_ = 1, finePerSlice_ = 1;
  std::array<double, 2> motion_{};
  double cell_ = 0.2;
  std::vector<Place> places_;
  Columns water_{}, bone_{}, sinogram_{};
  std::vector<float> fineContacts_, fineWires_, blocked_;
  std::vector<std::size_t> touched_;
  std::vector<char> isMetal_;
};

}  // namespace

ct::CtVolume scanned(const ImplantScene& scene, const ImplantScan& scan, std::uint64_t seed)
{
  return Scanner(scene, scan, seed).volume();
}

}  // namespace perilymph::test
