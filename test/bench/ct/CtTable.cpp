// SPDX-License-Identifier: BSD-3-Clause

// A table of the errors of A, B, H and the axis: phantoms with many seeds on three scanners, and
// the real ears of a folder. Not a test: it prints the errors without limits.
//
//     perilymph-ct-table phantoms FIRST LAST [STEP [TURNS]]
//                                                every STEP-th seed from FIRST to LAST - 1 on each
//                                                scanner; with TURNS a cavity beyond these
//     perilymph-ct-table ears [search]           the folder that PERILYMPH_EARS names; with
//                                                `search` without a click

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "perilymph/ct/Measures.h"
#include "perilymph/foundation/Normal.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/test/CtPhantom.h"
#include "perilymph/test/RealEarTruth.h"

namespace perilymph {
namespace {

double angle_deg(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return inDegrees(radians(std::acos(std::min(1.0, a.dot(b)))));
}

double secondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Errors of one scanner's phantoms, summed up.
class Summary {
public:
  void add(const ct::CochleaMeasures& found, const test::CtPhantom& truth)
  {
    const std::array<const ct::Measure*, 3> measures{&found.a, &found.b, &found.h};
    const std::array<double, 3> trueValues{truth.a, truth.b, truth.h};
    for (std::size_t i = 0; i < 3; ++i) {
      const double error = measures[i]->value - trueValues[i];
      sum_[i] += error;
      squares_[i] += error * error;
      in68_[i] += std::fabs(error) < measures[i]->sd() ? 1.0 : 0.0;
      in95_[i] += std::fabs(error) < halfWidth95 * measures[i]->sd() ? 1.0 : 0.0;
      if (std::fabs(error) > 3.0 * measures[i]->sd() && found.flags.empty()) ++silent_;
    }
    const double tilt = angle_deg(found.axis_P, truth.axis_P);
    tilt_ += tilt * tilt;
    within3_ += tilt < 3.0 ? 1.0 : 0.0;
    sides_ += (found.side == anatomy::Side::right) == truth.isRight ? 1 : 0;
    ++count_;
  }
  void addRefused() { ++refused_; }

  void print(const char* name) const
  {
    const double n = std::max(1, count_);
    std::printf("%s: %d measured, %d refused, side right in %d, beyond 3 sigma without a flag %d\n",
                name, count_, refused_, sides_, silent_);
    for (std::size_t i = 0; i < 3; ++i)
      std::printf("  %c: RMS %.3f mm, mean %+.3f, 68 %% interval covers %.0f %%, 95 %% %.0f %%\n",
                  "ABH"[i], std::sqrt(squares_[i] / n), sum_[i] / n, 100.0 * in68_[i] / n,
                  100.0 * in95_[i] / n);
    std::printf("  axis: RMS %.1f deg, within 3 deg %.0f %%\n", std::sqrt(tilt_ / n),
                100.0 * within3_ / n);
  }

private:
  std::array<double, 3> sum_{}, squares_{}, in68_{}, in95_{};
  double tilt_ = 0.0, within3_ = 0.0;
  int count_ = 0, refused_ = 0, sides_ = 0, silent_ = 0;
};

void printFlags(const ct::CochleaMeasures& found)
{
  for (const ct::Flag flag : found.flags) std::printf(" %s", ct::nameOf(flag));
  std::printf("\n");
  std::fflush(stdout);
}

void phantoms(std::uint64_t first, std::uint64_t last, std::uint64_t step,
              const test::PhantomCondition& condition)
{
  const std::vector<std::pair<const char*, test::PhantomScan>> scans{
      {"0.15 mm", test::coneBeamScan()},
      {"0.30 mm", test::highResolutionScan()},
      {"0.45 x 0.60 mm", test::clinicalScan()}};
  for (const auto& [name, scan] : scans) {
    Summary summary;
    for (std::uint64_t seed = first; seed < last; seed += step) {
      const test::CtPhantom phantom = test::makeCtPhantom(seed, scan, condition);
      ct::MeasureRequest request;
      request.click_P = test::jitteredClick(phantom, seed);
      const auto start = std::chrono::steady_clock::now();
      const auto found = ct::measureCochlea(phantom.volume, request);
      if (!found) {
        std::printf("%s seed %llu: %s\n", name, static_cast<unsigned long long>(seed),
                    found.error().message.c_str());
        summary.addRefused();
        continue;
      }
      std::printf(
          "%s seed %llu: A %.2f %+.2f (sd %.2f) B %.2f %+.2f (%.2f) H %.2f %+.2f (%.2f) axis %.1f "
          "misfit %.3f %.1f s%s",
          name, static_cast<unsigned long long>(seed), phantom.a, found->a.value - phantom.a,
          found->a.sd(), phantom.b, found->b.value - phantom.b, found->b.sd(), phantom.h,
          found->h.value - phantom.h, found->h.sd(), angle_deg(found->axis_P, phantom.axis_P),
          found->misfit, secondsSince(start),
          (found->side == anatomy::Side::right) == phantom.isRight ? "" : " WRONG SIDE");
      printFlags(*found);
      summary.add(*found, phantom);
    }
    summary.print(name);
  }
}

int ears(bool isSearch)
{
  const auto folder = test::realEarFolder();
  if (!folder) {
    std::fprintf(stderr, "PERILYMPH_EARS names no folder with ears: set it, and try again.\n");
    return 1;
  }
  for (const std::string& name : test::realEarNames(*folder)) {
    const test::RealEar ear = test::loadRealEar(*folder, name);
    ct::MeasureRequest request;
    if (!isSearch) request.click_P = test::clickOf(ear);
    const auto start = std::chrono::steady_clock::now();
    const auto found = ct::measureCochlea(ear.ct, request);
    if (!found) {
      std::printf("%s: %s\n", name.c_str(), found.error().message.c_str());
      continue;
    }
    const test::LabelMeasures truth = test::measureLabel(ear);
    std::printf(
        "%s %s%s A %.2f label %.2f (sd %.2f) B %.2f label %.2f (%.2f) H %.2f (%.2f) axis %.1f deg "
        "surface %.3f mm lumen %.0f misfit %.3f %.1f s",
        name.c_str(), found->side == anatomy::Side::right ? "right" : "left",
        (found->side == anatomy::Side::right) == ear.isRight ? "" : " WRONG SIDE", found->a.value,
        truth.a, found->a.sd(), found->b.value, truth.b, found->b.sd(), found->h.value,
        found->h.sd(), angle_deg(found->axis_P, ear.axes_PW.col(2)),
        test::meanDistanceToLabel(ear, *found), found->lumenLevel, found->misfit,
        secondsSince(start));
    printFlags(*found);
  }
  return 0;
}

int run(const std::vector<std::string>& text)
{
  if (text.size() >= 3 && text.size() <= 5 && text[0] == "phantoms") {
    test::PhantomCondition condition;
    condition.isCystic = text.size() == 5;
    if (condition.isCystic) condition.turns = std::strtod(text[4].c_str(), nullptr);
    const auto number = [](const std::string& word) {
      return std::strtoull(word.c_str(), nullptr, 10);
    };
    phantoms(number(text[1]), number(text[2]),
             text.size() > 3 ? std::max(1ULL, number(text[3])) : 1, condition);
    return 0;
  }
  if (!text.empty() && text[0] == "ears") return ears(text.size() > 1 && text[1] == "search");
  std::fprintf(stderr, "perilymph-ct-table phantoms FIRST LAST [STEP [TURNS]] | ears [search]\n");
  return 2;
}

}  // namespace
}  // namespace perilymph

int main(int count, char** text)
{
  return perilymph::run(std::vector<std::string>(text + 1, text + count));
}
