#pragma once

// Reads people's text files (scenarios, patients, arrays, devices) and says in one sentence what is
// wrong with them: file, line, key, value, range.

#include <cstddef>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph {

/// The values a number may take, ends included. The unit is part of the key's name.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// One table of a TOML file that is being read. Every key must be asked for by name; finish()
/// refuses the keys nobody asked for. The first mistake found is kept and later calls give
/// fallbacks, so a reader asks for all its keys in a row and looks at finish() once.
///
/// Keys of physical values wear their unit (`length_mm`): a key asked for without one cannot exist.
class TomlReader {
public:
  /// Opens a file. Nothing is wrong yet if it is well-formed TOML of at most 16 MiB. Keys that it
  /// gives under an old name (RenamedKeys.h) are read under the new one, with a warning.
  static Result<TomlReader> open(const std::filesystem::path& file);
  /// The same for text that came another way, without warnings; `name` stands for the file in
  /// messages.
  static Result<TomlReader> parse(std::string_view text, std::string name);

  TomlReader(TomlReader&&) noexcept;
  TomlReader& operator=(TomlReader&&) noexcept;
  ~TomlReader();

  bool has(std::string_view key) const;

  /// A finite number within the range; missing is a mistake.
  double number(std::string_view key, Range allowed);
  /// A finite number within the range, or the fallback when the key is absent.
  double number(std::string_view key, Range allowed, double fallback);
  /// A whole number within the range, or the fallback when the key is absent.
  long integer(std::string_view key, long low, long high, long fallback);
  bool flag(std::string_view key, bool fallback);
  /// Text; missing is a mistake.
  std::string text(std::string_view key);
  std::string text(std::string_view key, std::string fallback);
  /// Text that must be one of the choices; missing is a mistake unless a fallback is given.
  std::string choice(std::string_view key, const std::vector<std::string>& choices,
                     std::optional<std::string> fallback = std::nullopt);
  /// A list of finite numbers, each within the range, of at least `fewest` entries.
  std::vector<double> numbers(std::string_view key, Range allowed, std::size_t fewest);

  /// The tables of `[[key]]`, each to be read and finished like a file of its own; empty if absent.
  std::vector<TomlReader> tables(std::string_view key);
  /// The table `[key]`; an empty one if absent.
  TomlReader table(std::string_view key);

  /// Keeps a mistake that only the caller can see, at the line of `key`, unless one is kept
  /// already.
  void refuse(std::string_view key, const std::string& sentence);

  /// Changes or adds one value before it is read: `--set key=value` of the command line. The value
  /// is TOML ("2.0", "true") or, failing that, text.
  void set(const std::string& given, const std::string& value);

  /// Takes a value of this table away before it is read, as if the text did not give it.
  void remove(std::string_view key);

  /// The first mistake, an unknown key being one; or success. Child tables report here, too.
  Result<Done> finish();

  /// The file, or what stands for it.
  const std::string& name() const;
  /// The table as TOML text, keys sorted: what a recording keeps of a scenario.
  std::string dump() const;

private:
  struct Content;
  explicit TomlReader(std::shared_ptr<Content> content);

  // Shared with the reader of the table around this one, whose finish() looks at both.
  std::shared_ptr<Content> content_;
};

}  // namespace perilymph
