// SPDX-License-Identifier: BSD-3-Clause
#include "StoredBits.h"

#include "DicomStatements.h"
#include "Encapsulated.h"

namespace perilymph::imaging {
namespace {

std::int64_t bytesOf(const DicomHeader& header)
{
  const std::int64_t bits = static_cast<std::int64_t>(header.rows) * header.columns *
                            header.samples * header.bitsAllocated *
                            static_cast<std::int64_t>(header.frames.size());
  return (bits + 7) / 8;
}

void compare(DicomHeader& header, const StatedTwice& pair, double first, double second)
{
  if (auto found = disagreement(header, pair, first, second))
    header.faults.push_back(*std::move(found));
}

void checkFragments(DicomHeader& header)
{
  const auto fragments = fragmentsOf(header.file, header.pixelStart);
  if (!fragments) return;
  const auto frames = static_cast<double>(header.frames.size());
  if (fragments->offsets > 0)
    compare(header, dicomPairs::framesAndOffsets, frames, static_cast<double>(fragments->offsets));
  // a frame may lie in several fragments, which run lengths may not
  const bool isRunLengths = header.transferSyntax == "1.2.840.10008.1.2.5";
  const std::size_t images = isRunLengths ? fragments->count : fragments->starts;
  if (images > 0)
    compare(header, dicomPairs::framesAndFragments, frames, static_cast<double>(images));
}

}  // namespace

bool isCutOff(const DicomHeader& header, std::int64_t fileSize)
{
  if (header.coding == PixelCoding::compressed) return !fragmentsOf(header.file, header.pixelStart);
  return header.coding == PixelCoding::plain && header.pixelStart + bytesOf(header) > fileSize;
}

void checkStoredBits(DicomHeader& header)
{
  if (header.bitsStored > header.bitsAllocated) {
    header.faults.push_back(
        Sentence{"The file %1 stores %2 bits (0028,0101) of a voxel in the %3 that are allocated "
                 "(0028,0100); export the series again as original images.",
                 nameOf(header), header.bitsStored, header.bitsAllocated});
    return;
  }
  if (header.coding == PixelCoding::plain && !header.pixelBytes)
    header.faults.push_back(
        Sentence{"The file %1 holds compressed voxels and states that they are not (transfer "
                 "syntax %2); export the series again as original images.",
                 nameOf(header),
                 header.transferSyntax.empty() ? std::string("missing") : header.transferSyntax});
  if (header.bitsStored > 0)
    compare(header, dicomPairs::highBit, header.bitsStored - 1, header.highBit);
  if (header.coding == PixelCoding::plain && header.pixelBytes && header.bitsAllocated > 0)
    compare(header, dicomPairs::framesAndBytes, static_cast<double>(bytesOf(header)),
            static_cast<double>(*header.pixelBytes));
  if (header.coding == PixelCoding::compressed) checkFragments(header);
  if (header.aspectRatio && !header.frames.empty() && header.frames.front().pixelSpacing_mm) {
    const Eigen::Vector2d& spacing = *header.frames.front().pixelSpacing_mm;
    compare(header, dicomPairs::aspectRatio, spacing.y() / spacing.x(),
            header.aspectRatio->y() / header.aspectRatio->x());
  }
}

}  // namespace perilymph::imaging
