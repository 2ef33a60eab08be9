// SPDX-License-Identifier: BSD-3-Clause

// A table of the errors of found contacts: implanted phantoms with many seeds. Not a test: it prints a row for each
// ear and a summary of each class, without limits.
//
//     perilymph-outcome-table FIRST LAST [STEP [own|real]]
//                              every STEP-th seed from FIRST to LAST - 1: arrays, scanners, ears, folds and
//                              translocations follow from the seed; with `own` the ear is measured in the CT after
//                              surgery itself; with `real` the array is added to the CT of a real ear, of the folder
//                              that PERILYMPH_EARS names, without folds and translocations
//
// Lengths count from the opening. A class is the scanner and whether its contacts are seen singly: the array's median
// pitch is at least 1.3 times the blur's width (singly), below 0.8 times (array), or between.

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

#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/foundation/Quantile.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/outcome/FoundArray.h"
#include "perilymph/test/ImplantPhantom.h"
#include "perilymph/test/RealEarTruth.h"
#include "perilymph/test/RealEars.h"

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
  double covered = 0.0, angleError_deg = 0.0, lengthError_mm = 0.0, seconds = 0.0;
  bool isAngleCovered = false, foldFound = false, hasFold = false, translocationFound = false,
       hasTranslocation = false;
};

/// All rows of one class.
class Summary {
public:
  void add(Row row) { rows_.push_back(std::move(row)); }
  void print(const std::string& name) const
  {
    std::vector<double> errors, ofEar, angles, lengths, covered, seconds;
    std::size_t found = 0, right = 0, silent = 0, rightFlagged = 0, regions = 0, angleIn = 0,
                folds = 0, foldsFound = 0, crossed = 0, crossedFound = 0, falseFolds = 0,
                falseCrossed = 0;
    for (const Row& row : rows_) {
      if (!row.isFound) continue;
      ++found;
      seconds.push_back(row.seconds);
      if (!row.isRight && !row.isFlagged) ++silent;
      if (row.isRight) {
        // errors of ears with right numbers: of the others they are those of the numbers
        ++right;
        if (row.isFlagged) ++rightFlagged;
        errors.insert(errors.end(), row.errors.begin(), row.errors.end());
        ofEar.push_back(*std::max_element(row.errors.begin(), row.errors.end()));
        angles.push_back(std::fabs(row.angleError_deg));
        lengths.push_back(std::fabs(row.lengthError_mm));
        covered.push_back(row.covered);
        regions += row.covered >= 0.9 ? 1 : 0;
        angleIn += row.isAngleCovered ? 1 : 0;
      }
      folds += row.hasFold ? 1 : 0, foldsFound += row.hasFold && row.foldFound ? 1 : 0,
          falseFolds += !row.hasFold && row.foldFound ? 1 : 0;
      crossed += row.hasTranslocation ? 1 : 0,
          crossedFound += row.hasTranslocation && row.translocationFound ? 1 : 0,
          falseCrossed += !row.hasTranslocation && row.translocationFound ? 1 : 0;
    }
    std::printf(
        "%s: %zu ears, %zu refused, %zu right (%zu of them flagged), wrong and not flagged %zu; "
        "fold %zu of %zu "
        "(false %zu), translocation %zu of %zu (false %zu)",
        name.c_str(), rows_.size(), rows_.size() - found, right, rightFlagged, silent, foldsFound,
        folds, falseFolds, crossedFound, crossed, falseCrossed);
    if (right == 0) {
      std::printf("\n");
      return;
    }
    double sum = 0.0;
    for (const double each : errors) sum += each;
    std::printf(
        "; where right: contact mean %.3f mm, 95th %.3f, largest of an ear median %.2f; angle "
        "median %.1f deg, its "
        "95 %% covers %zu; length median %.2f mm, largest %.2f; 95 %% regions cover 0.9 of the "
        "contacts in %zu; "
        "%.1f s median, %.1f s largest\n",
        sum / static_cast<double>(errors.size()), quantile(errors, 0.95), quantile(ofEar, 0.5),
        quantile(angles, 0.5), angleIn, quantile(lengths, 0.5), quantile(lengths, 1.0), regions,
        quantile(seconds, 0.5), quantile(seconds, 1.0));
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

Row judged(const outcome::FoundArray& found, const test::ImplantTruth& trueArray,
           const electrode::ArrayDesign& array)
{
  Row row;
  const double pitch = pitch_mm(array);
  for (const outcome::FoundContact& contact : found.contacts) {
    const test::TrueContact& truth =
        trueArray.contacts[static_cast<std::size_t>(contact.number) - 1];
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
                    flag == outcome::Flag::registrationPoor || flag == outcome::Flag::earFitPoor;
  row.angleError_deg = found.angularInsertionDepth_deg.value - trueArray.angularInsertionDepth_deg;
  row.lengthError_mm = found.insertedLength_mm - trueArray.insertedLength_mm -
                       inMillimeters(anatomy::Cochlea{}.leadIn);
  const auto [low, high] = found.angularInsertionDepth_deg.interval95();
  row.isAngleCovered =
      trueArray.angularInsertionDepth_deg >= low && trueArray.angularInsertionDepth_deg <= high;
  row.hasFold = trueArray.isFolded;
  row.foldFound = found.isFolded;
  row.hasTranslocation = trueArray.translocation_deg.has_value();
  row.translocationFound = found.has(outcome::Flag::possibleTranslocation);
  row.seconds = found.seconds;
  return row;
}

std::string classOf(const electrode::ArrayDesign& array, double fwhm)
{
  const double ratio = pitch_mm(array) / fwhm;
  return ratio >= 1.3 ? "singly" : ratio >= 0.8 ? "between" : "array";
}

enum class Source { phantom, own, real };

/// A CT after surgery with its truth, and the ear in it.
struct Implanted {
  ct::CtVolume postoperative;
  test::ImplantTruth truth;
  electrode::ArrayDesign array;
  Result<outcome::Ear> ear;
};

Implanted implanted(std::uint64_t seed, Case& each, Source source)
{
  ct::MeasureRequest click;
  if (source == Source::real) {
    const auto folder = test::realEarFolder();
    if (!folder)
      throw std::runtime_error("PERILYMPH_EARS names no folder with ears: set it, and try again.");
    const std::vector<std::string> names = test::realEarNames(*folder);
    const test::RealEar real = test::loadRealEar(*folder, names.at(seed % names.size()));
    each.condition.isFolded = each.condition.hasOldLead = false;
    each.condition.translocationAngle_deg.reset();
    click.click_P = test::clickOf(real);
    const auto measured = ct::measureCochlea(real.ct, click);
    if (!measured) throw std::runtime_error(measured.error().message);
    test::ImplantedEar made =
        test::implantInto(real.ct, *measured, seed, each.scan, each.condition);
    auto ear = outcome::registeredEar(made.postoperative, real.ct, *measured);
    return {std::move(made.postoperative), made.truth, made.array, std::move(ear)};
  }
  test::ImplantPhantom made = test::makeImplantPhantom(seed, each.scan, each.condition);
  click.click_P = source == Source::own ? made.truth.inside_P : made.preoperative.inside_P;
  Result<outcome::Ear> ear = Error{"none"};
  if (source == Source::own) {
    ear = outcome::measuredEar(made.postoperative, click);
  } else {
    const auto measured = ct::measureCochlea(made.preoperative.volume, click);
    ear = measured ? outcome::registeredEar(made.postoperative, made.preoperative.volume, *measured)
                   : Result<outcome::Ear>(measured.error());
  }
  return {std::move(made.postoperative), made.truth, made.array, std::move(ear)};
}

int table(std::uint64_t first, std::uint64_t last, std::uint64_t step, Source source)
{
  std::vector<std::string> arrays = shippedNames("plugins/electrodes");
  std::sort(arrays.begin(), arrays.end());
  std::map<std::string, Summary> classes;
  for (std::uint64_t seed = first; seed < last; seed += step) {
    Case each = caseOf(seed, arrays);
    try {
      const auto begun = std::chrono::steady_clock::now();
      const Implanted one = implanted(seed, each, source);
      const double made =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
      std::string name = each.scanner;
      const auto refuse = [&](const std::string& what, const std::string& why) {
        std::printf("%llu %s %s: refused: %s\n", static_cast<unsigned long long>(seed),
                    each.array.c_str(), name.c_str(), why.c_str());
        Row refused;
        refused.isFound = false;
        classes[name + what].add(refused);
      };
      if (!one.ear) {
        refuse(" ear refused", one.ear.error().message);
        continue;
      }
      outcome::ContactsRequest request;
      request.array = one.array;
      request.arrayName = each.array;
      const auto found = outcome::findContacts(one.postoperative, *one.ear, request);
      if (!found) {
        refuse(" refused", found.error().message);
        continue;
      }
      const Row row = judged(*found, one.truth, one.array);
      name += " " + classOf(one.array, found->fwhm_mm) + (row.hasFold ? " folded" : "");
      double sum = 0.0, largest = 0.0;
      for (const double error : row.errors) sum += error, largest = std::max(largest, error);
      std::string flags;
      for (const outcome::Flag flag : found->flags)
        flags += std::string(" ") + outcome::nameOf(flag);
      const Eigen::Vector3d window = one.ear->measures.roundWindow_P - one.truth.roundWindow_P;
      std::printf(
          "%llu %s %s clip %d%s%s%s out %d: mean %.3f max %.3f %s angle %.1f (%.1f) sd %.1f length "
          "%.1f (%+.1f) cover "
          "%.2f fwhm %.2f residual %.2f window %.2f made %.0f s found %.1f s%s\n",
          static_cast<unsigned long long>(seed), each.array.c_str(), name.c_str(),
          each.scan.isClipped ? 1 : 0, row.hasFold ? " FOLD" : "",
          row.hasTranslocation ? " TRANS" : "", each.condition.hasOldLead ? " LEAD" : "",
          static_cast<int>(one.truth.contacts.size()) - one.truth.contactsInside,
          sum / static_cast<double>(row.errors.size()), largest,
          row.isRight     ? "right"
          : row.isFlagged ? "flagged"
                          : "SILENT",
          found->angularInsertionDepth_deg.value, one.truth.angularInsertionDepth_deg,
          found->angularInsertionDepth_deg.sd, found->insertedLength_mm, row.lengthError_mm,
          row.covered, found->fwhm_mm, found->residual_mm, window.norm(), made, row.seconds,
          flags.c_str());
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
    std::fprintf(stderr, "perilymph-outcome-table FIRST LAST [STEP [own|real]]\n");
    return 2;
  }
  const auto number = [&](int at) { return std::strtoull(arguments[at], nullptr, 10); };
  const std::string word = count > 4 ? arguments[4] : "";
  if (!word.empty() && word != "own" && word != "real") {
    std::fprintf(stderr, "'%s' is neither own nor real.\n", word.c_str());
    return 2;
  }
  return perilymph::table(number(1), number(2), count > 3 ? std::max(1ULL, number(3)) : 1,
                          word == "own"    ? perilymph::Source::own
                          : word == "real" ? perilymph::Source::real
                                           : perilymph::Source::phantom);
}
