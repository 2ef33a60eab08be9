// SPDX-License-Identifier: BSD-3-Clause

// A table of the errors of found contacts: implanted phantoms with many seeds. Not a test: it prints a row for each
// ear and a summary of each class, without limits.
//
//     perilymph-outcome-table FIRST LAST [STEP [own]]
//                              every STEP-th seed from FIRST to LAST - 1: arrays, scanners, ears, folds and
//                              translocations follow from the seed; with `own` the ear is measured in the CT after
//                              surgery itself

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <string>
#include <vector>

#include "perilymph/analysis/SampleStatistics.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/outcome/FoundArray.h"
#include "perilymph/test/ImplantPhantom.h"

namespace perilymph {
namespace {

constexpr double chiSquare95 = 7.8147;  // three degrees of freedom

struct Case {
  std::string array, scanner;
  test::ImplantScan scan;
  test::ImplantCondition condition;
};

/// The case of a seed: scanner by its last two bits, array in turn, every eighth folded, every ninth translocated.
Case caseOf(std::uint64_t seed, const std::vector<std::string>& arrays)
{
  Case each;
  const std::array scans{test::fineImplantScan(), test::coneBeamImplantScan(),
                         test::highResolutionImplantScan(), test::clinicalImplantScan()};
  constexpr std::array names{"0.125", "0.2", "0.3", "0.4x0.6"};
  each.scan = scans[seed % 4];
  each.scanner = names[seed % 4];
  each.scan.isClipped = (seed / 4) % 2 == 0;
  each.scan.hasMetalCorrection = seed % 10 == 3;
  each.scan.motion_mm = seed % 6 == 5 ? 0.2 : 0.0;
  each.scan.isBoneKernel = seed % 3 != 0;
  each.array = arrays[(seed / 4) % arrays.size()];
  each.condition.array = each.array;
  each.condition.insertedFraction = 0.85 + 0.15 * static_cast<double>((seed * 7) % 10) / 9.0;
  if (seed % 8 == 6) each.condition.isFolded = true;
  if (seed % 9 == 4 && !each.condition.isFolded)
    each.condition.translocationAngle_deg = 150.0 + static_cast<double>(seed % 5) * 20.0;
  if (seed % 11 == 7) each.condition.contactsOutside = 1 + static_cast<int>(seed % 3);
  if (seed % 13 == 5) each.condition.hasOldLead = true;
  return each;
}

struct Row {
  bool isRight = true, isFlagged = false, isFound = true;
  std::vector<double> errors;
  double covered = 0.0, angleError_deg = 0.0, seconds = 0.0;
  bool isAngleCovered = false, foldFound = false, hasFold = false, translocationFound = false,
       hasTranslocation = false;
};

/// All rows of one class.
class Summary {
public:
  void add(Row row) { rows_.push_back(std::move(row)); }
  void print(const std::string& name) const
  {
    std::vector<double> errors, angles, covered, seconds;
    std::size_t found = 0, right = 0, silent = 0, angleIn = 0, folds = 0, foldsFound = 0,
                crossed = 0, crossedFound = 0, falseFolds = 0, falseCrossed = 0;
    for (const Row& row : rows_) {
      if (!row.isFound) continue;
      ++found;
      if (row.isRight) ++right;
      if (!row.isRight && !row.isFlagged) ++silent;
      errors.insert(errors.end(), row.errors.begin(), row.errors.end());
      angles.push_back(std::fabs(row.angleError_deg));
      covered.push_back(row.covered);
      seconds.push_back(row.seconds);
      angleIn += row.isAngleCovered ? 1 : 0;
      folds += row.hasFold ? 1 : 0, foldsFound += row.hasFold && row.foldFound ? 1 : 0,
          falseFolds += !row.hasFold && row.foldFound ? 1 : 0;
      crossed += row.hasTranslocation ? 1 : 0,
          crossedFound += row.hasTranslocation && row.translocationFound ? 1 : 0,
          falseCrossed += !row.hasTranslocation && row.translocationFound ? 1 : 0;
    }
    if (errors.empty()) {
      std::printf("%s: %zu ears, none found\n", name.c_str(), rows_.size());
      return;
    }
    const auto quantile = [](std::vector<double> values, double part) {
      std::sort(values.begin(), values.end());
      return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
    };
    double sum = 0.0, cover = 0.0;
    for (const double each : errors) sum += each;
    for (const double each : covered) cover += each;
    std::printf(
        "%s: %zu ears, %zu refused; mean %.3f mm, median %.3f, 95th %.3f; assigned %zu, wrong and "
        "not flagged %zu; "
        "angle median %.1f deg, its 95 %% covers %zu; 95 %% regions cover %.0f %% of contacts in "
        "the mean ear; "
        "fold %zu of %zu (false %zu), translocation %zu of %zu (false %zu); %.1f s\n",
        name.c_str(), rows_.size(), rows_.size() - found, sum / static_cast<double>(errors.size()),
        quantile(errors, 0.5), quantile(errors, 0.95), right, silent, quantile(angles, 0.5),
        angleIn, 100.0 * cover / static_cast<double>(covered.size()), foldsFound, folds, falseFolds,
        crossedFound, crossed, falseCrossed, quantile(seconds, 0.5));
  }

private:
  std::vector<Row> rows_;
};

/// The median pitch of an array [mm].
double pitch_mm(const electrode::ArrayDesign& array)
{
  std::vector<double> pitch;
  for (std::size_t i = 0; i + 1 < array.contactsFromTip.size(); ++i)
    pitch.push_back(inMillimeters(array.contactsFromTip[i + 1] - array.contactsFromTip[i]));
  std::sort(pitch.begin(), pitch.end());
  return pitch[pitch.size() / 2];
}

Row judged(const outcome::FoundArray& found, const test::ImplantPhantom& phantom)
{
  Row row;
  const double pitch = pitch_mm(phantom.array);
  for (const outcome::FoundContact& contact : found.contacts) {
    const test::TrueContact& truth =
        phantom.truth.contacts[static_cast<std::size_t>(contact.number) - 1];
    const Eigen::Vector3d off = contact.position_P - truth.position_P;
    row.errors.push_back(off.norm());
    row.isRight = row.isRight && off.norm() < 0.5 * pitch;
    if (off.dot(contact.covariance_P.inverse() * off) < chiSquare95)
      row.covered += 1.0 / static_cast<double>(found.contacts.size());
  }
  for (const outcome::Flag flag : found.flags)
    row.isFlagged = row.isFlagged || flag == outcome::Flag::secondAssignment ||
                    flag == outcome::Flag::missingContacts || flag == outcome::Flag::extraMetal ||
                    flag == outcome::Flag::arrayDoesNotFit || flag == outcome::Flag::fold ||
                    flag == outcome::Flag::kink || flag == outcome::Flag::clipped ||
                    flag == outcome::Flag::registrationPoor;
  row.angleError_deg =
      found.angularInsertionDepth_deg.value - phantom.truth.angularInsertionDepth_deg;
  const auto [low, high] = found.angularInsertionDepth_deg.interval95();
  row.isAngleCovered = phantom.truth.angularInsertionDepth_deg >= low &&
                       phantom.truth.angularInsertionDepth_deg <= high;
  row.hasFold = phantom.truth.isFolded;
  row.foldFound = found.isFolded;
  row.hasTranslocation = phantom.truth.translocation_deg.has_value();
  row.translocationFound = found.has(outcome::Flag::possibleTranslocation);
  row.seconds = found.seconds;
  return row;
}

std::string classOf(const test::ImplantPhantom& phantom, double fwhm)
{
  const double ratio = pitch_mm(phantom.array) / fwhm;
  return ratio >= 1.3 ? "singly" : ratio >= 0.8 ? "between" : "array";
}

int table(std::uint64_t first, std::uint64_t last, std::uint64_t step, bool isOwn)
{
  std::vector<std::string> arrays = shippedNames("plugins/electrodes");
  std::sort(arrays.begin(), arrays.end());
  std::map<std::string, Summary> classes;
  for (std::uint64_t seed = first; seed < last; seed += step) {
    const Case each = caseOf(seed, arrays);
    try {
      const auto begun = std::chrono::steady_clock::now();
      const test::ImplantPhantom phantom =
          test::makeImplantPhantom(seed, each.scan, each.condition);
      const double made =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
      ct::MeasureRequest click;
      click.click_P = isOwn ? phantom.truth.inside_P : phantom.preoperative.inside_P;
      Result<outcome::Ear> ear = Error{"none"};
      if (isOwn) {
        ear = outcome::measuredEar(phantom.postoperative, click);
      } else {
        const auto measured = ct::measureCochlea(phantom.preoperative.volume, click);
        ear = measured ? outcome::registeredEar(phantom.postoperative, phantom.preoperative.volume,
                                                *measured)
                       : Result<outcome::Ear>(measured.error());
      }
      std::string name = each.scanner;
      if (!ear) {
        std::printf("%llu %s %s: refused: %s\n", static_cast<unsigned long long>(seed),
                    each.array.c_str(), name.c_str(), ear.error().message.c_str());
        Row refused;
        refused.isFound = false;
        classes[name + " ear refused"].add(refused);
        continue;
      }
      outcome::ContactsRequest request;
      request.array = phantom.array;
      request.arrayName = each.array;
      const auto found = outcome::findContacts(phantom.postoperative, *ear, request);
      if (!found) {
        std::printf("%llu %s %s: refused: %s\n", static_cast<unsigned long long>(seed),
                    each.array.c_str(), name.c_str(), found.error().message.c_str());
        Row refused;
        refused.isFound = false;
        classes[name + " refused"].add(refused);
        continue;
      }
      const Row row = judged(*found, phantom);
      name += " " + classOf(phantom, found->fwhm_mm);
      double sum = 0.0, largest = 0.0;
      for (const double error : row.errors) sum += error, largest = std::max(largest, error);
      std::string flags;
      for (const outcome::Flag flag : found->flags)
        flags += std::string(" ") + outcome::nameOf(flag);
      const Eigen::Vector3d window = ear->measures.roundWindow_P - phantom.truth.roundWindow_P;
      std::printf(
          "%llu %s %s clip %d%s%s%s out %d: mean %.3f max %.3f %s angle %.1f (%.1f) sd %.1f cover "
          "%.2f fwhm %.2f residual %.2f window %.2f made %.0f s%s\n",
          static_cast<unsigned long long>(seed), each.array.c_str(), name.c_str(),
          each.scan.isClipped ? 1 : 0, row.hasFold ? " FOLD" : "",
          row.hasTranslocation ? " TRANS" : "", each.condition.hasOldLead ? " LEAD" : "",
          static_cast<int>(phantom.truth.contacts.size()) - phantom.truth.contactsInside,
          sum / static_cast<double>(row.errors.size()), largest,
          row.isRight     ? "right"
          : row.isFlagged ? "flagged"
                          : "SILENT",
          found->angularInsertionDepth_deg.value, phantom.truth.angularInsertionDepth_deg,
          found->angularInsertionDepth_deg.sd, row.covered, found->fwhm_mm, found->residual_mm,
          window.norm(), made, flags.c_str());
      std::fflush(stdout);
      classes[name].add(row);
    } catch (const std::exception& problem) {
      std::printf("%llu %s: not made: %s\n", static_cast<unsigned long long>(seed),
                  each.array.c_str(), problem.what());
    }
  }
  for (const auto& [name, summary] : classes) summary.print(name);
  return 0;
}

}  // namespace
}  // namespace perilymph

int main(int count, char** arguments)
{
  if (count < 3) {
    std::fprintf(stderr, "perilymph-outcome-table FIRST LAST [STEP [own]]\n");
    return 2;
  }
  const auto number = [&](int at) { return std::strtoull(arguments[at], nullptr, 10); };
  return perilymph::table(number(1), number(2), count > 3 ? std::max(1ULL, number(3)) : 1,
                          count > 4 && std::string(arguments[4]) == "own");
}
