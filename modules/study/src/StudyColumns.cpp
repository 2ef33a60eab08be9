// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/study/StudyColumns.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <set>
#include <stop_token>
#include <utility>

#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::study {

namespace {

using Number = double (*)(const StudyResult&);

/// The first of ownQuantities that an insertion has only if it ran.
constexpr std::size_t firstOfInsertion = 4;

/// The numbers that every study has, in the order in which people ask for them.
constexpr std::pair<const char*, Number> ownQuantities[] = {
    {"A_mm", [](const StudyResult& one) { return one.a_mm; }},
    {"B_mm", [](const StudyResult& one) { return one.b_mm; }},
    {"cdl_oc_mm", [](const StudyResult& one) { return one.ductLength_mm(); }},
    {"st_length_mm", [](const StudyResult& one) { return one.scalaLength_mm; }},
    {"angle_deg", [](const StudyResult& one) { return inDegrees(one.insertion.apical); }},
    {"coverage_percent", [](const StudyResult& one) { return 100.0 * one.insertion.coverage; }},
    {"depth_mm", [](const StudyResult& one) { return inMillimeters(one.insertion.depth); }},
    {"max_depth_mm", [](const StudyResult& one) { return inMillimeters(one.insertion.maxDepth); }},
    {"peak_mN", [](const StudyResult& one) { return inMillinewtons(one.insertion.peak.force); }},
    {"peak_depth_mm",
     [](const StudyResult& one) { return inMillimeters(one.insertion.peak.depth); }},
    {"end_mN", [](const StudyResult& one) { return inMillinewtons(one.insertion.endForce); }},
    {"partition_mN",
     [](const StudyResult& one) { return inMillinewtons(one.insertion.partition); }},
};

/// A number with more characters was drawn from a range (choice, high).
constexpr std::size_t maxListedDigits = 9;

std::optional<double> decimalIn(const std::string& text)
{
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() ? std::optional(value)
                                                                  : std::nullopt;
}

/// The name of an array, or of a file without its folder; any other value as it is.
std::string nameIn(const std::vector<StudyFileValue>& files, const std::string& key,
                   const std::string& value)
{
  for (const StudyFileValue& each : files)
    if (each.name == "array_name" && each.key == key && each.value == value) return each.content;
  if (key == "array")  // in studies of earlier versions
    if (const auto file = findByName("electrode array", "plugins/electrodes", value))
      if (const auto array = electrode::loadArray(*file)) return array->name;
  const std::filesystem::path file = value;
  return file.extension() == ".toml" ? file.stem().string() : value;
}

/// StudyFactor::shown.
std::vector<std::string> shownLevels(const std::vector<StudyFileValue>& files,
                                     const StudyFactor& factor)
{
  std::vector<std::string> names;
  for (const std::string& level : factor.levels)
    names.push_back(level.empty() ? "as in the scenario" : nameIn(files, factor.key, level));
  std::vector<std::string> shown;
  for (std::size_t i = 0; i < names.size(); ++i)
    shown.push_back(std::ranges::count(names, names[i]) == 1 ? names[i] : factor.levels[i]);
  return shown;
}

/// The level of each text; nothing if there are fewer than two or too many.
std::optional<StudyFactor> factorOf(const std::vector<StudyFileValue>& files,
                                    const std::string& key, const std::vector<std::string>& texts)
{
  StudyFactor factor{key, {}, {}, {}};
  factor.level.reserve(texts.size());
  for (const std::string& text : texts) {
    const auto found = std::find(factor.levels.begin(), factor.levels.end(), text);
    factor.level.push_back(static_cast<std::uint16_t>(found - factor.levels.begin()));
    if (found == factor.levels.end()) factor.levels.push_back(text);
    if (factor.levels.size() > StudyColumns::maxLevels) return std::nullopt;
  }
  if (factor.levels.size() < 2) return std::nullopt;
  // Numbers drawn from a range have all their digits, those that people list do not.
  if (std::any_of(factor.levels.begin(), factor.levels.end(), [](const std::string& level) {
        return level.size() > maxListedDigits && decimalIn(level);
      }))
    return std::nullopt;
  factor.shown = shownLevels(files, factor);
  return factor;
}

/// A setting whose numbers are shown in another unit: forces in mN, as those of the insertion.
struct SettingInUnit {
  const char *setting, *quantity;
  double factor;
};
constexpr SettingInUnit settingsInUnits[] = {{"stop_force_N", "stop_force_mN", 1e3}};

/// The numbers of a setting; nothing if a value is no number or all are the same.
std::optional<StudyQuantity> quantityOf(const std::string& key,
                                        const std::vector<std::string>& texts)
{
  StudyQuantity quantity{key, {}};
  quantity.values.reserve(texts.size());
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const std::string& text : texts) {
    const auto value =
        text.empty() ? std::optional(std::numeric_limits<double>::quiet_NaN()) : decimalIn(text);
    if (!value) return std::nullopt;
    quantity.values.push_back(*value);
    low = std::min(low, *value);
    high = std::max(high, *value);
  }
  if (!(high > low)) return std::nullopt;
  for (const SettingInUnit& each : settingsInUnits) {
    if (key != each.setting) continue;
    quantity.key = each.quantity;
    for (double& value : quantity.values) value *= each.factor;
  }
  return quantity;
}

}  // namespace

std::string StudyFactor::shownOf(const std::string& value) const
{
  const auto found = std::ranges::find(levels, value);
  return found == levels.end() ? value : shown[static_cast<std::size_t>(found - levels.begin())];
}

std::string settingOf(const StudyResult& result, const std::string& key)
{
  for (const auto& [name, value] : result.settings)
    if (name == key) return value;
  return {};
}

Result<StudyColumns> StudyColumns::read(const std::filesystem::path& file,
                                        const std::stop_token& stop, std::size_t max)
{
  const auto opened = StudyFile::open(file);
  if (!opened) return opened.error();
  const StudyFileFacts& facts = opened->facts();
  if (facts.end - facts.first > max)
    return Error{
        "%1 has %2 insertions; at most %3 can be shown. Open one of its shards, or query it with "
        "SQL.",
        file, facts.end - facts.first, max};
  std::vector<StudyResult> results;
  const auto read = opened->read([&](StudyResult result) -> Result<void> {
    if (stop.stop_requested()) return Error{"Canceled."};
    result.insertion.contacts = {};
    result.insertion.profile = {};
    results.push_back(std::move(result));
    return {};
  });
  if (!read) return read.error();
  if (results.empty())
    return Error{
        "%1 has no insertions yet. Run 'perilymph-cli study run' or merge its shards first.", file};
  return StudyColumns(facts, std::move(results));
}

StudyColumns::StudyColumns(StudyFileFacts facts, std::vector<StudyResult> results)
    : facts_(std::move(facts)), results_(std::move(results))
{
  addQuantities();
  addSettings();
}

void StudyColumns::addQuantities()
{
  for (std::size_t i = 0; i < std::size(ownQuantities); ++i) {
    const auto& [key, number] = ownQuantities[i];
    StudyQuantity quantity{key, {}};
    quantity.values.reserve(size());
    for (const StudyResult& result : results_) {
      const bool isMissing =
          i >= firstOfInsertion && result.insertion.end == analysis::InsertionEnd::refused;
      quantity.values.push_back(isMissing ? std::numeric_limits<double>::quiet_NaN()
                                          : number(result));
    }
    quantities_.push_back(std::move(quantity));
  }
}

void StudyColumns::addSettings()
{
  std::vector<std::string> texts(size());
  for (std::size_t i = 0; i < size(); ++i) texts[i] = haptics::nameOf(results_[i].insertion.end);
  if (auto factor = factorOf(facts_.fileValues, "ending", texts))
    factors_.push_back(*std::move(factor));
  std::set<std::string> keys;
  for (const StudyResult& result : results_)
    for (const auto& [key, value] : result.settings) keys.insert(key);
  for (const std::string& key : keys) {
    for (std::size_t i = 0; i < size(); ++i) texts[i] = settingOf(results_[i], key);
    if (auto factor = factorOf(facts_.fileValues, key, texts))
      factors_.push_back(*std::move(factor));
    if (auto quantity = quantityOf(key, texts)) quantities_.push_back(*std::move(quantity));
  }
  settingsEnd_ = quantities_.size();
  for (const std::string& name : fileColumns()) {
    for (std::size_t i = 0; i < size(); ++i) texts[i] = fileValueOf(results_[i], name);
    if (auto quantity = quantityOf(name, texts)) quantities_.push_back(*std::move(quantity));
  }
}

std::vector<std::string> StudyColumns::fileColumns() const
{
  std::set<std::string> names;
  for (const StudyFileValue& each : facts_.fileValues) names.insert(each.name);
  return {names.begin(), names.end()};
}

std::string StudyColumns::fileValueOf(const StudyResult& result, const std::string& name) const
{
  for (const StudyFileValue& each : facts_.fileValues)
    if (each.name == name && settingOf(result, each.key) == each.value) return each.content;
  return {};
}

const StudyQuantity* StudyColumns::quantity(const std::string& key) const
{
  const auto found = std::find_if(quantities_.begin(), quantities_.end(),
                                  [&key](const StudyQuantity& each) { return each.key == key; });
  return found == quantities_.end() ? nullptr : &*found;
}

const StudyFactor* StudyColumns::factor(const std::string& key) const
{
  const auto found = std::find_if(factors_.begin(), factors_.end(),
                                  [&key](const StudyFactor& each) { return each.key == key; });
  return found == factors_.end() ? nullptr : &*found;
}

std::vector<std::string> StudyColumns::ranges() const
{
  const auto settingOfQuantity = [](const std::string& key) {
    for (const SettingInUnit& each : settingsInUnits)
      if (key == each.quantity) return std::string(each.setting);
    return key;
  };
  std::vector<std::string> keys;
  for (std::size_t i = std::size(ownQuantities); i < settingsEnd_; ++i)
    if (factor(settingOfQuantity(quantities_[i].key)) == nullptr)
      keys.push_back(quantities_[i].key);
  return keys;
}

std::vector<std::uint32_t> StudyColumns::rows(const StudyFilter& filter) const
{
  std::vector<char> isSelected(size(), 1);
  for (std::size_t k = 0; k < std::min(factors_.size(), filter.levels.size()); ++k) {
    const std::vector<bool>& wanted = filter.levels[k];
    if (wanted.empty()) continue;
    const StudyFactor& factor = factors_[k];
    for (std::size_t i = 0; i < size(); ++i)
      if (factor.level[i] >= wanted.size() || !wanted[factor.level[i]]) isSelected[i] = 0;
  }
  std::vector<std::uint32_t> rows;
  rows.reserve(size());
  for (std::size_t i = 0; i < size(); ++i)
    if (isSelected[i] != 0 && results_[i].a_mm >= filter.minA_mm &&
        results_[i].a_mm <= filter.maxA_mm)
      rows.push_back(static_cast<std::uint32_t>(i));
  return rows;
}

}  // namespace perilymph::study
