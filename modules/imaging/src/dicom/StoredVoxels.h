// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Uncompressed voxels as integers (DICOM PS3.5, section 8 and annex D).

#include <cstdint>
#include <optional>
#include <vector>

#include "DicomHeader.h"

namespace perilymph::imaging {

/// Words of an uncompressed file, each of BitsAllocated bits: 8, 12, 16 or 32, in the file's order of bytes. None
/// where the file cannot be read, or allocates another number of bits.
std::optional<std::vector<std::uint32_t>> readWords(const DicomHeader& header);

/// The stored values in words, and whether the words hold more than the header says.
class ValueBits {
public:
  explicit ValueBits(const DicomHeader& header);

  std::int64_t valueIn(std::uint32_t word)
  {
    const std::uint32_t own = word & mask_, beyond = word & ~mask_;
    if ((own & sign_) != 0) {
      if (beyond == extension_)
        isAnyExtended_ = true;
      else if (beyond == 0)
        isAnyBare_ = true;
      else
        used_ |= word;
      return static_cast<std::int64_t>(own) - wrap_;
    }
    if (beyond != 0) used_ |= word;
    return own;
  }

  /// The lowest and the highest stored value that there may be.
  std::int64_t lowest() const { return sign_ != 0 ? -static_cast<std::int64_t>(sign_) : 0; }
  std::int64_t highest() const { return sign_ != 0 ? sign_ - std::int64_t{1} : mask_; }

  /// Bits that the words need where those are more than BitsStored, and no overlay explains them; else 0.
  int bitsNeeded() const;

private:
  std::uint32_t mask_, sign_, extension_;
  std::int64_t wrap_;
  bool hasOverlay_;
  bool isAnyExtended_ = false, isAnyBare_ = false;
  std::uint32_t used_ = 0;
};

}  // namespace perilymph::imaging
