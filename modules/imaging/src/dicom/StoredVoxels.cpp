// SPDX-License-Identifier: BSD-3-Clause
#include "StoredVoxels.h"

#include <bit>
#include <fstream>
#include <span>

namespace perilymph::imaging {
namespace {

constexpr const char* bigEndianSyntax = "1.2.840.10008.1.2.2";

int storedBits(const DicomHeader& header)
{
  return header.bitsStored > 0 ? header.bitsStored : header.bitsAllocated;
}

/// The lowest bits set.
std::uint32_t lowestBits(int bits)
{
  return bits >= 32 ? 0xFFFFFFFFU : (std::uint32_t{1} << bits) - 1U;
}

using Bytes = std::span<const unsigned char>;

/// Words of whole bytes.
template <std::size_t perWord>
void putBytes(Bytes bytes, bool isBigEndian, std::vector<std::uint32_t>& words)
{
  const unsigned char* place = bytes.data();
  for (std::uint32_t& word : words) {
    std::uint32_t little = 0, big = 0;
    for (std::size_t k = 0; k < perWord; ++k, ++place) {
      little |= static_cast<std::uint32_t>(*place) << 8 * k;
      big = big << 8 | *place;
    }
    word = isBigEndian ? big : little;
  }
}

/// Words of 12 bits, the lowest bits first, two in three bytes (PS3.5, annex D).
void putPacked(Bytes bytes, std::vector<std::uint32_t>& words)
{
  for (std::size_t i = 0; i < words.size(); ++i) {
    const unsigned char* const place = bytes.data() + i * 3 / 2;
    const std::uint32_t low = place[0], high = place[1];
    words[i] = i % 2 == 0 ? low | (high & 0x0F) << 8 : low >> 4 | high << 4;
  }
}

/// Undoes the order of 16-bit words that a big-endian file has its bytes in.
void swapPairs(std::vector<unsigned char>& bytes)
{
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) std::swap(bytes[i], bytes[i + 1]);
}

/// Whether PixelData of an explicit file is stated as 16-bit words.
bool isOfWords(std::ifstream& stream, std::int64_t start)
{
  char type[2] = {};
  stream.seekg(start - 8);
  stream.read(type, 2);
  return type[0] == 'O' && type[1] == 'W';
}

}  // namespace

std::optional<std::vector<std::uint32_t>> readWords(const DicomHeader& header)
{
  const int bits = header.bitsAllocated;
  if ((bits != 8 && bits != 12 && bits != 16 && bits != 32) || header.samples != 1)
    return std::nullopt;
  const std::size_t count = static_cast<std::size_t>(header.rows) *
                            static_cast<std::size_t>(header.columns) * header.frames.size();
  std::vector<unsigned char> bytes((count * static_cast<std::size_t>(bits) + 7) / 8);
  std::ifstream stream(header.file, std::ios::binary);
  stream.seekg(header.pixelStart);
  if (!stream.read(reinterpret_cast<char*>(bytes.data()),
                   static_cast<std::streamsize>(bytes.size())))
    return std::nullopt;
  const bool isBigEndian = header.transferSyntax == bigEndianSyntax;
  if (isBigEndian && bits < 16 && isOfWords(stream, header.pixelStart)) swapPairs(bytes);
  std::vector<std::uint32_t> words(count);
  switch (bits) {
    case 8:
      putBytes<1>(bytes, isBigEndian, words);
      break;
    case 12:
      putPacked(bytes, words);
      break;
    case 16:
      putBytes<2>(bytes, isBigEndian, words);
      break;
    default:
      putBytes<4>(bytes, isBigEndian, words);
  }
  return words;
}

ValueBits::ValueBits(const DicomHeader& header)
    : mask_(lowestBits(storedBits(header))),
      sign_(header.isSigned ? std::uint32_t{1} << (storedBits(header) - 1) : 0),
      extension_(lowestBits(header.bitsAllocated) & ~mask_),
      wrap_(static_cast<std::int64_t>(mask_) + 1),
      hasOverlay_(header.hasOverlayBits)
{
}

int ValueBits::bitsNeeded() const
{
  if (hasOverlay_) return 0;
  if (used_ != 0) return std::bit_width(used_);
  // one of them is no sign: the value needs a bit more
  return isAnyExtended_ && isAnyBare_ && extension_ != 0 ? std::bit_width(mask_) + 1 : 0;
}

}  // namespace perilymph::imaging
