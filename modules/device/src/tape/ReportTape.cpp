// SPDX-License-Identifier: BSD-3-Clause
#include "tape/ReportTape.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <optional>

#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::device {

namespace {

constexpr std::array<std::pair<char, TapeEvent>, 6> letters = {{{'E', TapeEvent::input},
                                                                {'W', TapeEvent::written},
                                                                {'F', TapeEvent::refused},
                                                                {'S', TapeEvent::featureSet},
                                                                {'G', TapeEvent::featureGot},
                                                                {'U', TapeEvent::gone}}};
constexpr std::size_t maxTapeBytes = std::size_t{256} << 20;
constexpr const char* lostMark = "# lost ";

/// Splits a line into words.
class Tokens {
public:
  explicit Tokens(std::string_view line) : rest_(line) {}

  std::string_view next()
  {
    const std::size_t from = std::min(rest_.find_first_not_of(" \t"), rest_.size());
    const std::size_t end = std::min(rest_.find_first_of(" \t", from), rest_.size());
    const std::string_view word = rest_.substr(from, end - from);
    rest_.remove_prefix(end);
    return word;
  }
  std::string_view rest()
  {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t"), rest_.size()));
    return rest_;
  }
  bool isOver() { return rest().empty(); }

  std::optional<std::uint64_t> number(int base, std::uint64_t maximum)
  {
    const std::string_view word = next();
    std::uint64_t value = 0;
    const auto read = std::from_chars(word.data(), word.data() + word.size(), value, base);
    const bool isWhole = !word.empty() && read.ec == std::errc() &&
                         read.ptr == word.data() + word.size() && value <= maximum;
    return isWhole ? std::optional(value) : std::nullopt;
  }
  /// Seconds with at most nine decimals, as nanoseconds.
  std::optional<std::int64_t> time()
  {
    const std::string_view word = next();
    const std::size_t dot = std::min(word.find('.'), word.size());
    std::string decimals(word.substr(std::min(dot + 1, word.size())));
    if (decimals.size() > 9) return std::nullopt;
    decimals.resize(9, '0');
    Tokens whole(word.substr(0, dot)), part(decimals);
    const auto seconds = whole.number(10, 1'000'000'000);
    const auto nanoseconds = part.number(10, 999'999'999);
    if (!seconds || !nanoseconds) return std::nullopt;
    return static_cast<std::int64_t>(*seconds * 1'000'000'000 + *nanoseconds);
  }
  /// A count followed by that many bytes.
  std::optional<std::vector<std::uint8_t>> bytes(std::size_t maximum)
  {
    const auto size = number(10, maximum);
    if (!size) return std::nullopt;
    std::vector<std::uint8_t> bytes;
    for (std::uint64_t i = 0; i < *size; ++i) {
      const auto byte = number(16, 0xff);
      if (!byte) return std::nullopt;
      bytes.push_back(static_cast<std::uint8_t>(*byte));
    }
    return bytes;
  }

private:
  std::string_view rest_;
};

class TapeReader {
public:
  explicit TapeReader(std::string name) : name_(std::move(name)) {}

  Result<ReportTape> read(std::string_view text)
  {
    while (!text.empty()) {
      const std::size_t end = text.find('\n');
      // An incomplete last line of a truncated tape is ignored.
      if (end == std::string_view::npos && !tape_.entries.empty()) break;
      std::string_view line = text.substr(0, end);
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
      ++lineNumber_;
      if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
      const std::string error = take(line);
      if (!error.empty())
        return Error{
            "%1, line %2: %3 A tape is written by 'perilymph-cli devices --capture' or "
            "hid-recorder.",
            name_, lineNumber_, error};
    }
    if (lineNumber_ == 0 || (tape_.entries.empty() && tape_.descriptor.empty()))
      return Error{
          "%1 holds no report of a device. A tape is written by 'perilymph-cli devices --capture' "
          "or hid-recorder.",
          name_};
    finish();
    return std::move(tape_);
  }

private:
  /// Parses a line; returns an error message, empty if there is none.
  std::string take(std::string_view line)
  {
    if (line.starts_with(lostMark)) {
      Tokens tokens(line.substr(std::string_view(lostMark).size()));
      tape_.lost += tokens.number(10, ~std::uint64_t{0}).value_or(0);
    }
    if (line.empty() || line.front() == '#') return {};
    if (line.size() < 2 || line[1] != ':')
      return "'" + std::string(line.substr(0, 20)) + "' is not a line of a tape.";
    Tokens tokens(line.substr(2));
    const char letter = line.front();
    if (letter == 'D') return takeDevice(tokens);
    if (letter == 'N') tape_.name = tokens.rest();
    if (letter == 'I') return takeIdentity(tokens);
    if (letter == 'R') return takeDescriptor(tokens);
    for (const auto& [known, event] : letters)
      if (known == letter) return takeEntry(event, tokens);
    return {};  // newer versions of hid-recorder have more letters
  }

  static std::string takeDevice(Tokens& tokens)
  {
    const auto number = tokens.number(10, 1000);
    if (number && *number == 0) return {};
    return "a tape is of one device, number 0.";
  }

  std::string takeIdentity(Tokens& tokens)
  {
    const auto bus = tokens.number(16, 0xffff);
    const auto vendor = tokens.number(16, 0xffff);
    const auto product = tokens.number(16, 0xffff);
    if (!bus || !vendor || !product)
      return "the identity must be bus, vendor and product, hexadecimal.";
    tape_.bus = static_cast<std::uint32_t>(*bus);
    tape_.identity.vendor = static_cast<std::uint16_t>(*vendor);
    tape_.identity.product = static_cast<std::uint16_t>(*product);
    return {};
  }

  std::string takeDescriptor(Tokens& tokens)
  {
    auto bytes = tokens.bytes(4096);
    if (!bytes || !tokens.isOver())
      return "the descriptor must be its size (at most 4096) and as many hexadecimal bytes.";
    tape_.descriptor = *std::move(bytes);
    return {};
  }

  std::string takeEntry(TapeEvent event, Tokens& tokens)
  {
    TapeEntry entry;
    entry.event = event;
    const auto time = tokens.time();
    if (!time) return "the time must be seconds, with at most nine decimals.";
    entry.time = *time;
    if (event != TapeEvent::input && event != TapeEvent::gone) {
      const auto took = tokens.time();
      if (!took) return "how long it took must be seconds, with at most nine decimals.";
      entry.took = *took;
    }
    if (event != TapeEvent::gone) {
      auto bytes = tokens.bytes(longestReport - 1);
      if (!bytes || bytes->empty())
        return "a report must be its size (1 to " + std::to_string(longestReport - 1) +
               ") and as many hexadecimal bytes.";
      entry.bytes = *std::move(bytes);
    }
    if (!tokens.isOver()) return "there is more on the line than its size says.";
    tape_.entries.push_back(std::move(entry));
    return {};
  }

  void finish()
  {
    const auto descriptor = ReportDescriptor::parse(tape_.descriptor);
    const bool isNumbered = descriptor && descriptor->isNumbered();
    for (TapeEntry& entry : tape_.entries)
      if (!isNumbered && entry.event != TapeEvent::gone) entry.bytes.insert(entry.bytes.begin(), 0);
    std::stable_sort(
        tape_.entries.begin(), tape_.entries.end(),
        [](const TapeEntry& one, const TapeEntry& other) { return one.time < other.time; });
  }

  std::string name_;
  std::size_t lineNumber_ = 0;
  ReportTape tape_;
};

std::string seconds(std::int64_t nanoseconds)
{
  char text[40];
  const auto time = static_cast<unsigned long long>(std::max<std::int64_t>(nanoseconds, 0));
  std::snprintf(text, sizeof text, "%06llu.%09llu", time / 1'000'000'000, time % 1'000'000'000);
  return text;
}

std::string hexadecimal(std::span<const std::uint8_t> bytes)
{
  std::string text = std::to_string(bytes.size());
  char byte[8];
  for (const std::uint8_t value : bytes) {
    std::snprintf(byte, sizeof byte, " %02x", value);
    text += byte;
  }
  return text;
}

}  // namespace

Result<ReportTape> parseTape(std::string_view text, const std::string& name)
{
  return TapeReader(name).read(text);
}

Result<ReportTape> loadTape(const std::filesystem::path& file)
{
  const auto text = readWhole(file, maxTapeBytes);
  if (!text) return text.error();
  return parseTape(*text, file.string());
}

std::string tapeHead(const ReportTape& tape)
{
  char identity[64];
  std::snprintf(identity, sizeof identity, "%04x %04x %04x", tape.bus, tape.identity.vendor,
                tape.identity.product);
  return "# Reports of a device. D, R, N, I and E as hid-recorder writes them; then seconds, how\n"
         "# long it took, size and bytes of what was W written, F refused, S set or G got as a\n"
         "# feature; U unplugged.\nD: 0\nR: " +
         hexadecimal(tape.descriptor) + "\nN: " + tape.name + "\nI: " + identity + "\n";
}

std::string tapeLine(TapeEvent event, std::int64_t time, std::int64_t took, const RawReport& report)
{
  std::string line;
  for (const auto& [letter, known] : letters)
    if (known == event) line = letter;
  line += ": " + seconds(time);
  if (event == TapeEvent::gone) return line + "\n";
  if (event != TapeEvent::input) line += " " + seconds(took);
  auto bytes = report.view();
  if (!bytes.empty() && bytes[0] == 0) bytes = bytes.subspan(1);  // not on the wire
  return line + " " + hexadecimal(bytes) + "\n";
}

}  // namespace perilymph::device
