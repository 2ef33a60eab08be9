// SPDX-License-Identifier: BSD-3-Clause

// How long a CT of 512 x 512 x 200 voxels takes to open, and three oblique views of it to sample; and how
// long a cochlea takes to be measured.

#include <benchmark/benchmark.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <vector>

#include "perilymph/ct/Measures.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/imaging/PlaneSampler.h"
#include "perilymph/test/CtPhantom.h"
#include "perilymph/test/DicomWriter.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph {
namespace {

/// A smooth volume with a fine pattern, 0.3 x 0.3 x 0.4 mm.
const ct::CtVolume& largeCt()
{
  static const ct::CtVolume made = [] {
    const std::array<int, 3> size{512, 512, 200};
    std::vector<std::int16_t> voxels;
    voxels.reserve(std::size_t{512} * 512 * 200);
    for (int k = 0; k < size[2]; ++k)
      for (int j = 0; j < size[1]; ++j)
        for (int i = 0; i < size[0]; ++i)
          voxels.push_back(static_cast<std::int16_t>((i * j + 7 * k * k) % 2500 - 500));
    Eigen::Matrix4d lps = Eigen::Matrix4d::Identity();
    lps.diagonal() << 0.3, 0.3, 0.4, 1.0;
    return *ct::CtVolume::make(size, lps, std::move(voxels));
  }();
  return made;
}

/// Axial, coronal and sagittal views of 512 x 512 pixels, turned obliquely, the crosshair moving.
void threeViews(benchmark::State& state)
{
  const auto volume = std::make_shared<const ct::CtVolume>(largeCt());
  imaging::PlaneSampler sampler(volume);
  imaging::PlanePicture picture;
  picture.width = picture.height = 512;
  picture.pixel_mm = 0.25;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.35, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  int frame = 0;
  for (auto _ : state) {
    const Eigen::Vector3d center =
        volume->center_P() + Eigen::Vector3d::Constant(0.1 * (frame++ % 40));
    for (ct::ViewPlane plane : ct::patientPlanes(center)) {
      plane.right_P = turn * plane.right_P;
      plane.down_P = turn * plane.down_P;
      picture.plane = plane;
      benchmark::DoNotOptimize(sampler.sample(picture).data());
    }
  }
  state.counters["frames_per_s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(threeViews)
    ->Name("ct/three_views/512x512x200")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// A folder of 200 uncompressed slices.
void open(benchmark::State& state)
{
  const test::TemporaryFolder folder;
  test::writeDicomFiles(test::dicomSlices(largeCt()), folder.path());
  for (auto _ : state) {
    const auto loaded = imaging::readCt(folder.path());
    if (!loaded) return state.SkipWithError(loaded.error().message.c_str());
    benchmark::DoNotOptimize(loaded->volume.voxels().data());
  }
}
BENCHMARK(open)->Name("ct/open/512x512x200")->Unit(benchmark::kMillisecond)->UseRealTime();

/// What the page CT does with a folder: list it, read a series, a picture of each.
void openInWindow(benchmark::State& state)
{
  const test::TemporaryFolder folder;
  test::writeDicomFiles(test::dicomSlices(largeCt()), folder.path());
  for (auto _ : state) {
    const auto list = imaging::findSeries(folder.path());
    if (!list) return state.SkipWithError(list.error().message.c_str());
    const auto loaded = imaging::readCt(*list);
    if (!loaded) return state.SkipWithError(loaded.error().message.c_str());
    benchmark::DoNotOptimize(loaded->volume.voxels().data());
    benchmark::DoNotOptimize(imaging::readThumbnails(*list, 48).data());
  }
}
BENCHMARK(openInWindow)
    ->Name("ct/open_in_window/512x512x200")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// A phantom of 0.3 mm, in which the cochlea is searched for, or where it was clicked.
void measure(benchmark::State& state, bool isClicked)
{
  static const test::CtPhantom phantom = test::makeCtPhantom(302, test::highResolutionScan());
  ct::MeasureRequest request;
  if (isClicked) request.click_P = test::jitteredClick(phantom, 302);
  for (auto _ : state) {
    auto found = ct::measureCochlea(phantom.volume, request);
    if (!found) return state.SkipWithError(found.error().message.c_str());
    benchmark::DoNotOptimize(found->a.value);
  }
}
BENCHMARK_CAPTURE(measure, search, false)
    ->Name("ct/measure")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(measure, click, true)
    ->Name("ct/measure/click")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace perilymph
