// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/TomlReader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <utility>

#include "TomlContent.h"
#include "TomlText.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/RenamedKeys.h"

namespace perilymph {

using tomltext::listed;
using tomltext::shortest;
using tomltext::shown;

namespace {

/// The allowed range, as the end of a sentence.
std::string allowedText(Range allowed)
{
  const bool hasLow = std::isfinite(allowed.low);
  const bool hasHigh = std::isfinite(allowed.high);
  if (hasLow && hasHigh)
    return "between " + shortest(allowed.low) + " and " + shortest(allowed.high);
  if (hasLow) return "at least " + shortest(allowed.low);
  if (hasHigh) return "at most " + shortest(allowed.high);
  return "a finite number";
}

/// A TOML number, integer or float; empty if it is neither or not finite.
std::optional<double> finiteNumber(const toml::node& node)
{
  const std::optional<double> value = node.value<double>();
  if (!node.is_number() || !value || !std::isfinite(*value)) return std::nullopt;
  return value;
}

bool isWithin(double value, Range allowed) { return value >= allowed.low && value <= allowed.high; }

/// A finite value within the range, returned after an error.
double anyWithin(Range allowed)
{
  if (std::isfinite(allowed.low)) return allowed.low;
  return std::isfinite(allowed.high) ? allowed.high : 0.0;
}

/// A number, text, true or false as it would follow `--set key=`; empty for any other node.
std::optional<std::string> scalarText(const toml::node& node)
{
  if (const auto text = node.value_exact<std::string>()) return *text;
  if (const auto flag = node.value_exact<bool>()) return *flag ? "true" : "false";
  if (const auto whole = node.value_exact<std::int64_t>()) return std::to_string(*whole);
  if (const auto number = finiteNumber(node)) return shortest(*number);
  return std::nullopt;
}

/// Renames the keys of a table and its inner tables to their current names and lists the old ones.
/// A key given under both names is an error.
Result<void> renameKeys(toml::table& table, const std::string& name, const std::string& path,
                        std::vector<RenamedKeyUse>& renamed)
{
  std::vector<std::string> old;
  for (auto&& [key, node] : table)
    if (currentKey(key.str()) != key.str()) old.emplace_back(key.str());
  for (const std::string& before : old) {
    const auto entry = table.find(before);
    const std::string now(currentKey(before));
    const toml::source_region source = entry->first.source();
    const std::string place = name + ":" + std::to_string(source.begin.line) + ": ";
    if (table.contains(now))
      return Error{"%1the key '%2%3' is the old name of '%4', which is given, too. Remove '%3'.",
                   place, path, before, now};
    table.insert(toml::key(now, source), std::move(entry->second));
    table.erase(before);
    renamed.push_back({place, path + before, now});
  }
  for (auto&& [key, node] : table) {
    const std::string inner = path + std::string(key.str());
    if (toml::table* const one = node.as_table())
      if (const auto done = renameKeys(*one, name, inner + ".", renamed); !done) return done;
    toml::array* const list = node.as_array();
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i)
      if (toml::table* const one = (*list)[i].as_table()) {
        const std::string numbered = inner + "[" + std::to_string(i + 1) + "].";
        if (const auto done = renameKeys(*one, name, numbered, renamed); !done) return done;
      }
  }
  return {};
}

}  // namespace

TomlReader::TomlReader(std::shared_ptr<Content> content) : content_(std::move(content)) {}
TomlReader::TomlReader(TomlReader&&) noexcept = default;
TomlReader& TomlReader::operator=(TomlReader&&) noexcept = default;
TomlReader::~TomlReader() = default;

Result<TomlReader> TomlReader::open(const std::filesystem::path& file)
{
  const Result<std::string> text = readWhole(file);
  if (!text) return text.error();
  auto reader = parse(*text, file.string());
  if (!reader) return reader;
  for (const RenamedKeyUse& use : reader->content_->renamed) warn(use.warning());
  return reader;
}

Result<TomlReader> TomlReader::parse(std::string_view text, std::string name)
{
  if (const auto line = tomltext::lineNotUtf8(text))
    return Error{
        "%1:%2: this is not UTF-8 text. Check that it is the right file and save it as UTF-8.",
        name, *line};
  if (const auto line = tomltext::lineNestedTooDeep(text))
    return Error{
        "%1:%2: a key has more than 16 parts between dots; no file of this program nests so deep.",
        name, *line};
  auto content = std::make_shared<Content>();
  try {
    content->table = toml::parse(text);
  } catch (const toml::parse_error& error) {
    const auto place = error.source().begin;
    std::string reason(error.description());
    if (reason.empty() || reason.back() != '.') reason += '.';
    return Error{"%1:%2:%3: this is not TOML: %4", name, place.line, place.column, reason};
  } catch (const std::exception& error) {
    return Error{"%1: this is not TOML: %2.", name, error.what()};
  }
  const auto renamed = renameKeys(content->table, name, "", content->renamed);
  if (!renamed) return renamed.error();
  content->name = std::move(name);
  return TomlReader(std::move(content));
}

bool TomlReader::has(std::string_view key) const { return content_->table.contains(key); }

double TomlReader::number(std::string_view key, Range allowed)
{
  const toml::node* node = content_->ask(key);
  if (node != nullptr) return number(key, allowed, anyWithin(allowed));
  content_->keepMissing(key, allowedText(allowed));
  return anyWithin(allowed);
}

double TomlReader::number(std::string_view key, Range allowed, double fallback)
{
  const toml::node* node = content_->ask(key);
  if (node == nullptr) return fallback;
  const std::optional<double> value = finiteNumber(*node);
  if (value && isWithin(*value, allowed)) return *value;
  content_->keepInvalid(
      key, *node, node->is_number() ? allowedText(allowed) : "a number, " + allowedText(allowed));
  return fallback;
}

long TomlReader::integer(std::string_view key, long low, long high, long fallback)
{
  const toml::node* node = content_->ask(key);
  if (node == nullptr) return fallback;
  const auto value = node->value_exact<std::int64_t>();
  if (value && *value >= low && *value <= high) return static_cast<long>(*value);
  content_->keepInvalid(
      key, *node, "a whole number between " + std::to_string(low) + " and " + std::to_string(high));
  return fallback;
}

bool TomlReader::flag(std::string_view key, bool fallback)
{
  const toml::node* node = content_->ask(key);
  if (node == nullptr) return fallback;
  if (const auto value = node->value_exact<bool>()) return *value;
  content_->keepInvalid(key, *node, "true or false");
  return fallback;
}

std::string TomlReader::text(std::string_view key)
{
  if (content_->ask(key) == nullptr) content_->keepMissing(key, "text");
  return text(key, "");
}

std::string TomlReader::text(std::string_view key, std::string fallback)
{
  const toml::node* node = content_->ask(key);
  if (node == nullptr) return fallback;
  if (const auto value = node->value_exact<std::string>()) return *value;

  // On the command line values are not quoted: --set label=12 means the text.
  const auto change = content_->changed.find(key);
  if (change != content_->changed.end()) return change->second;
  content_->keepInvalid(key, *node, "text in quotation marks");
  return fallback;
}

std::string TomlReader::choice(std::string_view key, const std::vector<std::string>& choices,
                               std::optional<std::string> fallback)
{
  const std::string other = fallback ? *fallback : choices.empty() ? "" : choices.front();
  const toml::node* node = content_->ask(key);
  const std::string mustBe = "one of " + listed(choices);
  if (node == nullptr) {
    if (!fallback) content_->keepMissing(key, mustBe);
    return other;
  }
  const auto change = content_->changed.find(key);
  std::string value = node->value_exact<std::string>().value_or("");
  if (!node->is_string() && change != content_->changed.end()) value = change->second;
  if (std::find(choices.begin(), choices.end(), value) != choices.end()) return value;
  content_->keepInvalid(key, *node, mustBe);
  return other;
}

std::vector<double> TomlReader::numbers(std::string_view key, Range allowed, std::size_t fewest)
{
  const std::string mustBe =
      "a list of at least " + std::to_string(fewest) + " numbers, each " + allowedText(allowed);
  const std::vector<double> other(fewest, anyWithin(allowed));
  const toml::node* node = content_->ask(key);
  if (node == nullptr) {
    content_->keepMissing(key, mustBe);
    return other;
  }
  const toml::array* list = node->as_array();
  if (list == nullptr) {
    content_->keepInvalid(key, *node, mustBe);
    return other;
  }
  const std::string place = content_->place(key) + content_->path + std::string(key);
  if (list->size() < fewest) {
    content_->keep(place + " has " + std::to_string(list->size()) + " numbers; it must be " +
                   mustBe + ".");
    return other;
  }
  std::vector<double> values;
  for (const toml::node& entry : *list) {
    const std::optional<double> value = finiteNumber(entry);
    if (!value || !isWithin(*value, allowed)) {
      content_->keep(place + " has " + shown(entry) + " as number " +
                     std::to_string(values.size() + 1) + "; it must be " + mustBe + ".");
      return other;
    }
    values.push_back(*value);
  }
  return values;
}

std::vector<std::string> TomlReader::keys() const
{
  std::vector<std::string> names;
  for (auto&& [key, node] : content_->table) names.emplace_back(key.str());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> TomlReader::values(std::string_view key)
{
  std::vector<std::string> texts;
  const toml::node* node = content_->ask(key);
  const toml::array* list = node != nullptr ? node->as_array() : nullptr;
  const std::string mustBe = "a list of at least one number, text, true or false";
  if (list == nullptr || list->empty()) {
    if (node == nullptr)
      content_->keepMissing(key, mustBe);
    else
      content_->keepInvalid(key, *node, mustBe);
    return texts;
  }
  for (const toml::node& entry : *list) {
    const auto text = scalarText(entry);
    if (!text) {
      content_->keepInvalid(key, *node, mustBe);
      return {};
    }
    texts.push_back(*text);
  }
  return texts;
}

std::string TomlReader::value(std::string_view key)
{
  const toml::node* node = content_->ask(key);
  const std::string mustBe = "a number, text, true or false";
  const auto text = node != nullptr ? scalarText(*node) : std::nullopt;
  if (node == nullptr)
    content_->keepMissing(key, mustBe);
  else if (!text)
    content_->keepInvalid(key, *node, mustBe);
  return text.value_or("");
}

std::vector<TomlReader> TomlReader::tables(std::string_view key)
{
  std::vector<TomlReader> readers;
  const toml::node* node = content_->ask(key);
  if (node == nullptr) return readers;
  const toml::array* list = node->as_array();
  const bool areTables =
      list != nullptr &&
      std::all_of(list->begin(), list->end(), [](const auto& entry) { return entry.is_table(); });
  if (!areTables) {
    content_->keepInvalid(key, *node, "tables, each under [[" + std::string(key) + "]]");
    return readers;
  }
  for (const toml::node& entry : *list) {
    const std::string path = std::string(key) + "[" + std::to_string(readers.size() + 1) + "]";
    readers.push_back(TomlReader(content_->addInner(*entry.as_table(), path, path)));
  }
  return readers;
}

TomlReader TomlReader::table(std::string_view key)
{
  const toml::node* node = content_->ask(key);
  const toml::table* inner = node != nullptr ? node->as_table() : nullptr;
  if (node != nullptr && inner == nullptr)
    content_->keepInvalid(key, *node, "a table under [" + std::string(key) + "]");
  const toml::table empty;
  const toml::table& found = inner != nullptr ? *inner : empty;
  return TomlReader(content_->addInner(found, std::string(key), key));
}

void TomlReader::refuse(std::string_view key, const std::string& sentence)
{
  content_->keep(content_->place(key) + sentence);
}

void TomlReader::remove(std::string_view key) { content_->table.erase(key); }

void TomlReader::set(const std::string& given, const std::string& value)
{
  std::string key;
  for (std::size_t begin = 0; begin <= given.size();) {
    const std::size_t end = std::min(given.find('.', begin), given.size());
    const std::string part = given.substr(begin, end - begin);
    const std::string now(currentKey(part));
    if (now != part)
      warn(RenamedKeyUse{"--set " + given + "=" + value + ": ", given, now}.warning());
    key += (begin > 0 ? "." : "") + now;
    begin = end + 1;
  }

  if (tomltext::lineNotUtf8(value)) {
    content_->keep("--set " + shown(key) + "=" + shown(value) + ": this is not UTF-8 text.");
    return;
  }
  // The intermediate tables, for a key such as stylet.from_tip_mm.
  toml::table* table = &content_->table;
  std::size_t begin = 0;
  for (std::size_t dot = key.find('.'); dot != std::string::npos; dot = key.find('.', begin)) {
    const std::string part = key.substr(begin, dot - begin);
    toml::node* next = table->get(part);
    if (next == nullptr) next = &table->insert(part, toml::table()).first->second;
    if (!next->is_table()) {
      content_->keep("--set " + shown(key) + "=" + shown(value) + ": " + shown(part) +
                     " is not a table.");
      return;
    }
    table = next->as_table();
    begin = dot + 1;
  }
  const std::string last = key.substr(begin);
  content_->changed[key] = value;

  // TOML if the text is exactly one value, else text.
  Result<TomlReader> parsed = parse("value = " + value, "value");
  if (parsed && parsed->content_->table.size() == 1)
    table->insert_or_assign(last, *parsed->content_->table.get("value"));
  else
    table->insert_or_assign(last, value);
}

Result<void> TomlReader::finish()
{
  const std::string sentence = content_->firstError();
  if (!sentence.empty()) return Error{sentence};
  return {};
}

const std::string& TomlReader::name() const { return content_->name; }

std::string TomlReader::dump() const { return tomltext::written(content_->table); }

}  // namespace perilymph
