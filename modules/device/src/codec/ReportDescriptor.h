// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The HID report descriptor, parsed by the rules of "Device Class Definition for HID 1.11", section
// 6.2.2.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::device {

/// A usage with its page: the purpose of a field or a collection ("HID Usage Tables").
struct Usage {
  std::uint16_t page = 0;
  std::uint16_t id = 0;
  friend bool operator==(const Usage&, const Usage&) = default;
};

enum class ReportKind : std::uint8_t { input, output, feature };

/// A group of fields; groups are nested.
struct ReportCollection {
  Usage usage;
  std::uint8_t type = 0;     ///< 0 physical, 1 application, 2 logical, ...
  std::int32_t parent = -1;  ///< Index of the enclosing collection; -1 at the top.
};

/// Usages of consecutive elements, both ends included.
struct UsageRange {
  Usage first;
  std::uint16_t last = 0;  ///< On the page of `first`.
};

/// Elements of equal layout declared by one main item.
struct ReportField {
  ReportKind kind = ReportKind::input;
  std::uint8_t report = 0;      ///< Report number; 0 if reports are not numbered.
  std::uint32_t bitOffset = 0;  ///< Offset of the first element after the report's number.
  std::uint32_t bitsEach = 0;   ///< 1 to 32.
  std::uint32_t count = 0;      ///< Number of elements.
  bool isArray = false;         ///< Elements contain the index of a usage, not the usage's value.
  bool isConstant = false;      ///< Padding.
  bool isRelative = false;
  std::int64_t logicalLow = 0;
  std::int64_t logicalHigh = 0;  ///< A field is signed if logicalLow is negative.
  std::int64_t physicalLow = 0;
  std::int64_t physicalHigh = 0;
  int unitExponent = 0;          ///< Power of ten, -8 to 7.
  std::uint32_t unit = 0;        ///< As in the descriptor; 0 is none.
  std::int32_t collection = -1;  ///< Index of the innermost collection.
  std::vector<UsageRange> usages;
};

/// Position of one number in a report.
struct ReportSlot {
  std::uint8_t report = 0;
  std::uint32_t bitOffset = 0;  ///< After the report number.
  std::uint32_t bits = 0;       ///< 1 to 32.
  bool isSigned = false;
  std::int64_t low = 0;   ///< Logical range.
  std::int64_t high = 0;  ///< 0 together with `low` if not declared.
};

/// A slot and the value that selects a usage there: 1 in a slot of its own, its index in an array.
struct UsageChoice {
  ReportSlot slot;
  std::int64_t value = 1;
};

class ReportDescriptor {
public:
  /// Maximum length of a descriptor [bytes]; the limit of Linux.
  static constexpr std::size_t longest = 4096;

  ReportDescriptor() = default;

  /// Parses a descriptor. The error for a malformed one names the offending byte. Memory and time
  /// are bounded by the descriptor's length, whatever it declares.
  static Result<ReportDescriptor> parse(std::span<const std::uint8_t> bytes);

  const std::vector<ReportField>& fields() const noexcept { return fields_; }
  const std::vector<ReportCollection>& collections() const noexcept { return collections_; }
  /// Usage of the first application collection: the type of the device.
  std::optional<Usage> application() const noexcept;
  bool hasApplication(Usage usage) const noexcept;
  /// Whether reports begin with their number.
  bool isNumbered() const noexcept { return isNumbered_; }

  /// Length of a report without its number [bytes]; 0 for a report that does not exist.
  std::size_t reportBytes(ReportKind kind, std::uint8_t report) const noexcept;

  /// The slot of a variable with this usage; if `within` is given, inside a collection of that
  /// usage, at any depth. The first one declared.
  std::optional<ReportSlot> find(ReportKind kind, Usage usage,
                                 std::optional<Usage> within = std::nullopt) const noexcept;

  /// How to select `usage` inside a collection of the usage `within`: as an array's element or as a
  /// variable of its own. An array's value follows the order in which its usages are declared.
  std::optional<UsageChoice> choice(ReportKind kind, Usage usage, Usage within) const noexcept;

private:
  friend class ReportDescriptorReader;

  bool isInside(std::int32_t collection, Usage usage) const noexcept;

  std::vector<ReportField> fields_;
  std::vector<ReportCollection> collections_;
  bool isNumbered_ = false;
};

}  // namespace perilymph::device
