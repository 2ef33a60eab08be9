// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Reads a report descriptor item by item.

#include <array>
#include <string>

#include "codec/ReportDescriptor.h"

namespace perilymph::device {

class ReportDescriptorReader {
public:
  Result<ReportDescriptor> read(std::span<const std::uint8_t> bytes);

private:
  /// One short item: prefix and up to four bytes of data.
  struct Item {
    std::uint8_t tag = 0;
    std::uint8_t type = 0;
    std::uint32_t size = 0;  ///< Size of the data [bytes].
    std::uint32_t value = 0;
    std::int64_t asSigned() const noexcept;
  };

  /// State that persists until redefined (HID 1.11, 6.2.2.7).
  struct Globals {
    std::uint16_t usagePage = 0;
    Item logicalLow;
    Item logicalHigh;
    Item physicalLow;
    Item physicalHigh;
    int unitExponent = 0;
    std::uint32_t unit = 0;
    std::uint32_t bitsEach = 0;
    std::uint32_t count = 0;
    std::uint8_t report = 0;
  };

  /// A usage of a local item; without a page of its own it takes that of the main item.
  struct LocalUsage {
    std::uint32_t value = 0;
    bool hasPage = false;
    Usage with(std::uint16_t page) const noexcept;
  };
  struct LocalRange {
    LocalUsage first;
    LocalUsage last;
  };

  std::string readItem(const Item& item);
  std::string readMain(const Item& item);
  std::string readGlobal(const Item& item);
  std::string readLocal(const Item& item);
  std::string openCollection(const Item& item);
  std::string addField(ReportKind kind, const Item& item);
  void addUsage(LocalUsage first, LocalUsage last);
  void clearLocals();
  std::uint32_t& bitsOf(ReportKind kind, std::uint8_t report);

  static constexpr std::size_t deepest = 32;

  ReportDescriptor descriptor_;
  Globals globals_;
  std::vector<Globals> stack_;
  std::vector<LocalRange> usages_;
  std::optional<LocalUsage> usageLow_;
  std::optional<LocalUsage> usageHigh_;
  bool inDelimiter_ = false;
  bool hasAlternative_ = false;  ///< The first usage of a delimited set was taken.
  std::int32_t collection_ = -1;
  std::size_t depth_ = 0;
  bool hasUnnumbered_ = false;
  std::array<std::array<std::uint32_t, 256>, 3> bits_{};  ///< Size of each report so far [bits].
};

}  // namespace perilymph::device
