// SPDX-License-Identifier: BSD-3-Clause
#include "FrameDecoder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <stop_token>

#include "CompressedFrames.h"
#include "DicomStatements.h"
#include "StoredVoxels.h"
#include "perilymph/ct/CtVolume.h"

namespace perilymph::imaging {
namespace {

Error undecodable()
{
  return Error{
      "The voxels of a file could not be decoded: it is damaged, or stored in a way this program "
      "does not know. Copy or export the series again, uncompressed if it can be."};
}

/// Above this, padding could be tissue: only what touches the border of its image is padding [HU].
constexpr double surelyAir_HU = -900.0;

/// Where the padding of a slice is to be masked.
class Padding {
public:
  Padding(const DicomHeader& header, const DicomFrame& frame)
      : range_(header.padding),
        rows_(static_cast<std::size_t>(header.rows)),
        columns_(static_cast<std::size_t>(header.columns))
  {
    if (!range_) return;
    const double a = frame.slope * (*range_)[0] + frame.intercept;
    const double b = frame.slope * (*range_)[1] + frame.intercept;
    isAir_ = std::max(a, b) <= surelyAir_HU;
  }

  /// Whether a stored value stands for no measurement.
  bool holds(double stored) const
  {
    return range_ && stored >= (*range_)[0] && stored <= (*range_)[1];
  }
  /// Whether it does so wherever it stands.
  bool isAir() const { return isAir_; }

  void mark(std::size_t place)
  {
    if (marked_.empty()) marked_.resize(rows_ * columns_);
    marked_[place] = true;
  }

  /// Masks the marked voxels of a slice that touch its border, directly or through each other.
  std::size_t maskFromBorder(std::int16_t* slice)
  {
    std::size_t masked = 0;
    std::vector<std::size_t> next;
    const auto visit = [&](std::size_t place) {
      if (!marked_[place]) return;
      marked_[place] = false;
      next.push_back(place);
    };
    for (std::size_t place = 0; place < marked_.size(); ++place) {
      const std::size_t row = place / columns_, column = place % columns_;
      if (row == 0 || row + 1 == rows_ || column == 0 || column + 1 == columns_) visit(place);
    }
    while (!next.empty()) {
      const std::size_t place = next.back();
      next.pop_back();
      slice[place] = ct::unmeasured;
      ++masked;
      if (place % columns_ > 0) visit(place - 1);
      if (place % columns_ + 1 < columns_) visit(place + 1);
      if (place >= columns_) visit(place - columns_);
      if (place + columns_ < marked_.size()) visit(place + columns_);
    }
    return masked;
  }

private:
  std::optional<std::array<double, 2>> range_;
  std::size_t rows_, columns_;
  bool isAir_ = false;
  std::vector<bool> marked_;
};

/// What becomes of a stored value.
enum class Kind : std::uint8_t { value, clipped, air, padding };

struct Gray {
  std::int16_t voxel;
  Kind kind;
};

/// Stored values to Hounsfield units of one frame, computed once for each value where a frame has more voxels than
/// there are values.
class GrayTable {
public:
  GrayTable(const DicomFrame& frame, const Padding& padding, std::int64_t lowest,
            std::int64_t highest, std::size_t voxels)
      : frame_(frame), padding_(padding), lowest_(lowest)
  {
    if (highest - lowest >= static_cast<std::int64_t>(voxels)) return;
    for (std::int64_t stored = lowest; stored <= highest; ++stored)
      table_.push_back(computed(static_cast<double>(stored)));
  }

  Gray of(std::int64_t stored) const
  {
    return table_.empty() ? computed(static_cast<double>(stored)) : table_.data()[stored - lowest_];
  }

private:
  Gray computed(double stored) const
  {
    constexpr double low = std::numeric_limits<std::int16_t>::min();
    constexpr double high = std::numeric_limits<std::int16_t>::max();
    const bool isPadding = padding_.holds(stored);
    if (isPadding && padding_.isAir()) return {ct::unmeasured, Kind::air};
    const double value = std::round(frame_.slope * stored + frame_.intercept);
    const Kind kind = isPadding                     ? Kind::padding
                      : value < low || value > high ? Kind::clipped
                                                    : Kind::value;
    return {static_cast<std::int16_t>(std::clamp(value, low, high)), kind};
  }

  const DicomFrame& frame_;
  const Padding& padding_;
  std::int64_t lowest_;
  std::vector<Gray> table_;
};

/// Stored values from `lowest` to `highest` to Hounsfield units, frame by frame.
template <class Next>
void rescale(const DicomHeader& header, DecodedFrames& decoded, std::int64_t lowest,
             std::int64_t highest, Next next)
{
  const std::size_t perFrame =
      static_cast<std::size_t>(header.rows) * static_cast<std::size_t>(header.columns);
  decoded.voxels.resize(perFrame * header.frames.size());
  std::int16_t* voxel = decoded.voxels.data();
  for (const DicomFrame& frame : header.frames) {
    Padding padding(header, frame);
    const GrayTable table(frame, padding, lowest, highest, perFrame);
    for (std::size_t i = 0; i < perFrame; ++i, ++voxel) {
      const Gray gray = table.of(next());
      *voxel = gray.voxel;
      if (gray.kind == Kind::value) continue;
      decoded.clipped += gray.kind == Kind::clipped ? 1 : 0;
      decoded.padded += gray.kind == Kind::air ? 1 : 0;
      if (gray.kind == Kind::padding) padding.mark(i);
    }
    decoded.padded += padding.maskFromBorder(voxel - perFrame);
  }
}

Result<DecodedFrames> needingMore(const DicomHeader& header, int bits)
{
  return Error{*disagreement(header, dicomPairs::bitsStored, header.bitsStored, bits)};
}

Result<DecodedFrames> decodePlain(const DicomHeader& header)
{
  const auto words = readWords(header);
  if (!words) return undecodable();
  DecodedFrames decoded;
  ValueBits bits(header);
  rescale(header, decoded, bits.lowest(), bits.highest(),
          [&bits, word = words->data()]() mutable { return bits.valueIn(*word++); });
  if (const int needed = bits.bitsNeeded(); needed > 0) return needingMore(header, needed);
  return decoded;
}

/// Bits of the widest of decoded values, without those of the sign.
template <class Stored>
int widest(std::span<const Stored> values, bool isSigned)
{
  std::int64_t maximum = 0;
  for (const Stored value : values) {
    const auto wide = static_cast<std::int64_t>(value);
    maximum |= wide < 0 ? ~wide << (isSigned ? 1 : 0) : wide;
  }
  int bits = 0;
  for (; maximum != 0; maximum >>= 1) ++bits;
  return bits;
}

template <class Stored>
Result<DecodedFrames> rescaled(std::span<const std::byte> bytes, const DicomHeader& header)
{
  const std::span<const Stored> stored(reinterpret_cast<const Stored*>(bytes.data()),
                                       bytes.size() / sizeof(Stored));
  if (header.bitsStored > 0 && !header.hasOverlayBits)
    if (const int needed = widest(stored, header.isSigned); needed > header.bitsStored)
      return needingMore(header, needed);
  DecodedFrames decoded;
  using Limits = std::numeric_limits<Stored>;
  rescale(header, decoded, Limits::min(), Limits::max(),
          [value = stored.data()]() mutable { return *value++; });
  return decoded;
}

Result<DecodedFrames> rescaledAs(StoredType type, std::span<const std::byte> bytes,
                                 const DicomHeader& header)
{
  switch (type) {
    case StoredType::int8:
      return rescaled<std::int8_t>(bytes, header);
    case StoredType::uint8:
      return rescaled<std::uint8_t>(bytes, header);
    case StoredType::int16:
      return rescaled<std::int16_t>(bytes, header);
    case StoredType::uint16:
      return rescaled<std::uint16_t>(bytes, header);
    case StoredType::int32:
      return rescaled<std::int32_t>(bytes, header);
    case StoredType::uint32:
      return rescaled<std::uint32_t>(bytes, header);
  }
  return undecodable();
}

}  // namespace

Result<DecodedFrames> decodeFrames(const DicomHeader& header, const std::stop_token& stop)
{
  if (header.coding != PixelCoding::compressed) return decodePlain(header);
  Result<DecodedFrames> decoded = undecodable();
  const auto use = [&](StoredType type, std::span<const std::byte> bytes) {
    decoded = rescaledAs(type, bytes, header);
  };
  if (!decodeCompressed(header, stop, use)) return undecodable();
  return decoded;
}

}  // namespace perilymph::imaging
