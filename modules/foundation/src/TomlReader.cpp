#include "perilymph/foundation/TomlReader.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <set>
#include <utility>

#include "Suggestion.h"
#include "TomlText.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph {

using tomltext::shortest;
using tomltext::shown;

namespace {

/// What a range allows, as the end of a sentence.
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

std::string listed(const std::vector<std::string>& words)
{
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
  return all;
}

/// A number of TOML's, integer or float; nothing if it is neither or not finite.
std::optional<double> finiteNumber(const toml::node& node)
{
  const std::optional<double> value = node.value<double>();
  if (!node.is_number() || !value || !std::isfinite(*value)) return std::nullopt;
  return value;
}

bool isWithin(double value, Range allowed) { return value >= allowed.low && value <= allowed.high; }

/// Something finite and within the range, to go on with after a mistake.
double anyWithin(Range allowed)
{
  if (std::isfinite(allowed.low)) return allowed.low;
  return std::isfinite(allowed.high) ? allowed.high : 0.0;
}

}  // namespace

/// One table, what was asked of it and the first mistake in it.
struct TomlReader::Content {
  struct Mistake {
    std::string sentence;
    std::string missingKey;  ///< The key whose absence it is; empty for others.
  };

  std::string name;
  std::string path;  ///< Of this table in the file, such as "stylet."; empty for the file itself.
  int line = 0;      ///< Where the table starts; 0 for the file itself.
  toml::table table;
  std::set<std::string, std::less<>> asked;
  std::map<std::string, std::string, std::less<>>
      changed;  ///< By set(): the value as it was given.
  std::optional<Mistake> mistake;
  std::vector<std::shared_ptr<Content>> inner;

  /// The node of a key, which counts as asked for.
  const toml::node* ask(std::string_view key)
  {
    asked.emplace(key);
    return table.get(key);
  }

  /// Where a key stands, to begin a sentence: "my.toml:7: ".
  std::string place(std::string_view key) const
  {
    const auto change = changed.find(key);
    if (change != changed.end())
      return "--set " + path + std::string(key) + "=" + shown(change->second) + ": ";
    const int keyLine = lineOf(key);
    return placeOfLine(keyLine != 0 ? keyLine : line);
  }

  /// The line of a key; 0 if it is not there or did not come from the file.
  int lineOf(std::string_view key) const
  {
    const auto entry = table.find(key);
    return entry != table.end() ? static_cast<int>(entry->first.source().begin.line) : 0;
  }

  std::string placeOfLine(int number) const
  {
    return name + (number != 0 ? ":" + std::to_string(number) : "") + ": ";
  }

  void keep(std::string sentence)
  {
    if (!mistake) mistake = Mistake{std::move(sentence), ""};
  }

  void keepMissing(std::string_view key, const std::string& mustBe)
  {
    if (mistake) return;
    mistake = Mistake{placeOfLine(line) + "key '" + path + std::string(key) +
                          "' is missing; it must be " + mustBe + ".",
                      std::string(key)};
  }

  void keepWrong(std::string_view key, const toml::node& node, const std::string& mustBe)
  {
    keep(place(key) + path + std::string(key) + " is " + shown(node) + "; it must be " + mustBe +
         ".");
  }

  /// The keys of the file that nobody asked for.
  std::vector<std::string> unknownKeys() const
  {
    std::vector<std::string> unknown;
    for (const auto& [key, value] : table)
      if (asked.count(key.str()) == 0) unknown.emplace_back(key.str());
    return unknown;
  }

  std::string unknownKey(const std::string& key) const
  {
    const std::string meant = nearestWord(key, {asked.begin(), asked.end()});
    std::string sentence = place(key) + "unknown key '" + path + shown(key) + "'; ";
    if (!meant.empty()) return sentence + "did you mean " + path + meant + "?";
    if (asked.empty()) return sentence + "no keys are known here.";
    return sentence + "known are " + listed({asked.begin(), asked.end()}) + ".";
  }

  /// The first mistake in this table and those in it; empty if there is none.
  std::string firstMistake() const
  {
    const std::vector<std::string> unknown = unknownKeys();

    // A misspelled key is why the right one is missing: the misspelling says more.
    if (mistake && !mistake->missingKey.empty())
      for (const std::string& key : unknown)
        if (!nearestWord(key, {mistake->missingKey}).empty()) return unknownKey(key);

    if (mistake) return mistake->sentence;
    for (const auto& content : inner) {
      const std::string sentence = content->firstMistake();
      if (!sentence.empty()) return sentence;
    }
    return unknown.empty() ? std::string() : unknownKey(unknown.front());
  }

  /// A table in this one, which keeps its own mistakes and is looked at by firstMistake() of this.
  std::shared_ptr<Content> addInner(const toml::table& innerTable, const std::string& innerPath,
                                    std::string_view key)
  {
    auto content = std::make_shared<Content>();
    content->name = name;
    content->path = path + innerPath + ".";
    content->table = innerTable;
    content->line = static_cast<int>(innerTable.source().begin.line);
    const std::string prefix = std::string(key) + ".";
    for (const auto& [name_, value] : changed)
      if (name_.compare(0, prefix.size(), prefix) == 0)
        content->changed[name_.substr(prefix.size())] = value;
    inner.push_back(content);
    return content;
  }
};

TomlReader::TomlReader(std::shared_ptr<Content> content) : content_(std::move(content)) {}
TomlReader::TomlReader(TomlReader&&) noexcept = default;
TomlReader& TomlReader::operator=(TomlReader&&) noexcept = default;
TomlReader::~TomlReader() = default;

Result<TomlReader> TomlReader::open(const std::filesystem::path& file)
{
  const Result<std::string> text = readWhole(file);
  if (!text) return text.error();
  return parse(*text, file.string());
}

Result<TomlReader> TomlReader::parse(std::string_view text, std::string name)
{
  if (const auto line = tomltext::lineNotUtf8(text))
    return Error{name + ":" + std::to_string(*line) +
                 ": this is not UTF-8 text. Check that it is the right file and save it as UTF-8."};
  if (const auto line = tomltext::lineNestedTooDeep(text))
    return Error{name + ":" + std::to_string(*line) +
                 ": a key has more than 16 parts between dots; no file of this program nests so "
                 "deep."};
  auto content = std::make_shared<Content>();
  try {
    content->table = toml::parse(text);
  } catch (const toml::parse_error& error) {
    const auto place = error.source().begin;
    std::string reason(error.description());
    if (reason.empty() || reason.back() != '.') reason += '.';
    return Error{name + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) +
                 ": this is not TOML: " + reason};
  } catch (const std::exception& error) {
    return Error{name + ": this is not TOML: " + error.what() + "."};
  }
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
  content_->keepWrong(
      key, *node, node->is_number() ? allowedText(allowed) : "a number, " + allowedText(allowed));
  return fallback;
}

long TomlReader::integer(std::string_view key, long low, long high, long fallback)
{
  const toml::node* node = content_->ask(key);
  if (node == nullptr) return fallback;
  const auto value = node->value_exact<std::int64_t>();
  if (value && *value >= low && *value <= high) return static_cast<long>(*value);
  content_->keepWrong(
      key, *node, "a whole number between " + std::to_string(low) + " and " + std::to_string(high));
  return fallback;
}

bool TomlReader::flag(std::string_view key, bool fallback)
{
  const toml::node* node = content_->ask(key);
  if (node == nullptr) return fallback;
  if (const auto value = node->value_exact<bool>()) return *value;
  content_->keepWrong(key, *node, "true or false");
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

  // On the command line nobody quotes: --set label=12 means the text.
  const auto change = content_->changed.find(key);
  if (change != content_->changed.end()) return change->second;
  content_->keepWrong(key, *node, "text in quotation marks");
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
  content_->keepWrong(key, *node, mustBe);
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
    content_->keepWrong(key, *node, mustBe);
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
    content_->keepWrong(key, *node, "tables, each under [[" + std::string(key) + "]]");
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
    content_->keepWrong(key, *node, "a table under [" + std::string(key) + "]");
  const toml::table empty;
  const toml::table& found = inner != nullptr ? *inner : empty;
  return TomlReader(content_->addInner(found, std::string(key), key));
}

void TomlReader::refuse(std::string_view key, const std::string& sentence)
{
  content_->keep(content_->place(key) + sentence);
}

void TomlReader::set(const std::string& key, const std::string& value)
{
  // The tables on the way, for a key such as stylet.from_tip_mm.
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

  // TOML if it is exactly one value, else text.
  Result<TomlReader> parsed = parse("value = " + value, "value");
  if (parsed && parsed->content_->table.size() == 1)
    table->insert_or_assign(last, *parsed->content_->table.get("value"));
  else
    table->insert_or_assign(last, value);
}

Result<Done> TomlReader::finish()
{
  const std::string sentence = content_->firstMistake();
  if (!sentence.empty()) return Error{sentence};
  return Done{};
}

const std::string& TomlReader::name() const { return content_->name; }

std::string TomlReader::dump() const { return tomltext::written(content_->table); }

}  // namespace perilymph
