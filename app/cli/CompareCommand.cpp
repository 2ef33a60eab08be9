// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>

#include "CommandFiles.h"
#include "Commands.h"
#include "OutputFolder.h"
#include "Terminal.h"
#include "perilymph/analysis/ComparisonGroups.h"

namespace perilymph::cli {

namespace {

void printSummary(const std::vector<analysis::ComparedInsertion>& insertions)
{
  print("{:24} {:>8} {:>8} {:>8} {:>11} {:>9} {:>17}\n", "recording", "peak, mN", "at, mm",
        "work, mJ", "speed, mm/s", "reversals", "insertion time, s");
  for (const analysis::ComparedInsertion& each : insertions)
    print("{:24} {:>8} {:>8} {:>8} {:>11} {:>9} {:>17}\n", labelOf(each),
          fixed(inMillinewtons(newtons(each.profile.peak.force)), 1),
          fixed(inMillimeters(meters(each.profile.peak.travel)), 1),
          fixed(each.profile.work * 1e3, 2), fixed(each.motion.meanSpeed() * 1e3, 2),
          each.reversals, fixed(each.profile.duration, 2));
}

void printDifferences(const std::vector<analysis::ComparedInsertion>& insertions,
                      const std::vector<analysis::InsertionGroup>& groups)
{
  for (const analysis::InsertionGroup& group : groups) {
    print("{}: n = {}\n", group.title(), group.members.size());
    std::string differing;
    for (const Phrase& each : analysis::differingIn(insertions, group))
      differing += (differing.empty() ? "" : ", ") + std::string(each.english());
    if (!differing.empty())
      print("  mixes insertions that differ in {}; its mean is of no one of them\n", differing);
  }
  for (std::size_t i = 1; i < groups.size(); ++i) {
    print("\n{} - {}, 95 % interval of each of {} quantities, not corrected for their number:\n",
          groups[0].title(), groups[i].title(), analysis::comparedQuantities().size());
    for (const analysis::ComparedQuantity& quantity : analysis::comparedQuantities()) {
      const auto welch = analysis::welchDifference(valuesOf(insertions, groups[0], quantity),
                                                   valuesOf(insertions, groups[i], quantity));
      if (!welch) continue;
      const auto number = [&](double value) {
        return fixed(quantity.factor * value, std::min(quantity.decimals + 1, 2));
      };
      print("{:36} {:>9} ({} to {}) {}\n", quantity.name.english(), number(welch->difference.value),
            number(welch->difference.low), number(welch->difference.high), quantity.unit);
    }
  }
}

analysis::CurveAxis axisOf(const std::string& name)
{
  if (name == "depth") return analysis::CurveAxis::depth;
  return name == "angle" ? analysis::CurveAxis::angle : analysis::CurveAxis::travel;
}

/// In the order array, technique, patient, friction, speed, each once.
std::vector<analysis::GroupKey> keysOf(const std::vector<std::string>& names)
{
  using analysis::GroupKey;
  constexpr std::pair<const char*, GroupKey> all[] = {{"array", GroupKey::array},
                                                      {"technique", GroupKey::technique},
                                                      {"patient", GroupKey::patient},
                                                      {"friction", GroupKey::friction},
                                                      {"speed", GroupKey::speed}};
  std::vector<GroupKey> keys;
  for (const auto& [name, key] : all)
    if (std::ranges::find(names, name) != names.end()) keys.push_back(key);
  return keys;
}

}  // namespace

Result<void> compare(const CompareOptions& options, const CommandFiles& files)
{
  std::vector<analysis::ComparedInsertion> insertions;
  for (const std::string& file : options.files) {
    auto compared = analysis::readCompared(file);
    if (!compared) return compared.error();
    if (const std::string note = noteOn(compared->check, file); !note.empty())
      printError("{}\n", note);
    insertions.push_back(std::move(*compared));
  }
  analysis::tellApart(insertions);
  const analysis::CurveAxis axis = axisOf(options.over);
  const auto groups = analysis::groupsOf(insertions, keysOf(options.groups));
  FolderContent content;
  content.texts = {{"comparison.csv", analysis::comparisonCsv(insertions)},
                   {"comparison-dictionary.csv", analysis::comparisonDictionaryCsv()},
                   {"curves.csv", analysis::curvesCsv(insertions, axis)},
                   {"events.csv", analysis::eventsCsv(insertions)}};
  if (!groups.empty()) {
    content.texts.emplace_back("groups.csv", analysis::groupsCsv(insertions, groups));
    content.texts.emplace_back("differences.csv", analysis::differencesCsv(insertions, groups));
  }
  content.figures = {
      {"curves", draw(analysis::comparisonFigure(insertions, nullptr, axis, groups))}};
  if (const auto done = writeFolder(files, options.out, content); !done) return done.error();
  printSummary(insertions);
  if (!groups.empty()) printDifferences(insertions, groups);
  return {};
}

}  // namespace perilymph::cli
