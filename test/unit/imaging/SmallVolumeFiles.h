// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Small NIfTI, NRRD and MetaImage files of one oblique CT.

#include <zlib.h>

#include <bit>
#include <cstring>
#include <stdexcept>
#include <string>

#include "SmallCt.h"

namespace perilymph::imaging {

/// Bytes of a value in one of the two orders.
class Bytes {
public:
  explicit Bytes(std::size_t size, bool isBigEndian = false)
      : content(size, '\0'), isBig(isBigEndian)
  {
  }

  template <class Value>
  void put(std::size_t at, Value value)
  {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);  // this machine's order, little-endian
    for (std::size_t k = 0; k < sizeof value; ++k)
      content[at + k] = bytes[isBig ? sizeof value - 1 - k : k];
  }

  std::string content;
  bool isBig;
};

inline Eigen::Matrix3d obliqueAxes()
{
  return Eigen::AngleAxisd(0.4, Eigen::Vector3d(0.3, -0.8, 0.5).normalized()).toRotationMatrix();
}

/// A CT with an oblique matrix.
inline ct::CtVolume obliqueCt() { return smallCt(obliqueAxes(), {0.3, 0.4, 0.6}); }

template <class Value>
void putVoxels(Bytes& bytes, std::size_t from, const ct::CtVolume& volume, double slope = 1.0,
               double intercept = 0.0)
{
  std::size_t at = from;
  for (int k = 0; k < volume.size()[2]; ++k)
    for (int j = 0; j < volume.size()[1]; ++j)
      for (int i = 0; i < volume.size()[0]; ++i, at += sizeof(Value))
        bytes.put(at, static_cast<Value>((volume.voxel(i, j, k) - intercept) / slope));
}

enum class Form { sform, qform, both, none };

inline constexpr std::size_t firstVoxel = 352, voxelCount = 12 * 10 * 8;

/// A NIfTI-1 file of 16-bit voxels, or of voxels that the caller gives.
inline Bytes niftiFile(const ct::CtVolume& volume, Form form, bool isBigEndian = false)
{
  Bytes bytes(firstVoxel + 2 * voxelCount, isBigEndian);
  bytes.put<std::int32_t>(0, 348);
  bytes.put<std::int16_t>(40, 3);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bytes.put<std::int16_t>(42 + 2 * axis, static_cast<std::int16_t>(volume.size()[axis]));
    bytes.put<float>(80 + 4 * axis,
                     static_cast<float>(volume.spacing_mm()[static_cast<Eigen::Index>(axis)]));
  }
  bytes.put<std::int16_t>(70, 4);
  bytes.put<std::int16_t>(72, 16);
  bytes.put<float>(76, 1.0F);
  bytes.put<float>(108, firstVoxel);
  bytes.content[123] = 2;
  std::memcpy(bytes.content.data() + 344, "n+1", 4);
  Eigen::Matrix4d ras = volume.lpsFromIndex();
  ras.topRows<2>() *= -1.0;
  if (form == Form::sform || form == Form::both) {
    bytes.put<std::int16_t>(254, 1);
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < 4; ++column)
        bytes.put<float>(280 + 16 * row + 4 * column,
                         static_cast<float>(ras(static_cast<Eigen::Index>(row),
                                                static_cast<Eigen::Index>(column))));
  }
  if (form == Form::qform || form == Form::both) {
    Eigen::Matrix3d axes = ras.topLeftCorner<3, 3>();
    for (Eigen::Index axis = 0; axis < 3; ++axis) axes.col(axis).normalize();
    if (axes.determinant() < 0.0) {
      axes.col(2) = -axes.col(2);
      bytes.put<float>(76, -1.0F);
    }
    Eigen::Quaterniond turn(axes);
    if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
    bytes.put<std::int16_t>(252, 1);
    const Eigen::Vector3d vector = turn.vec();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      bytes.put<float>(256 + 4 * axis, static_cast<float>(vector[a]));
      bytes.put<float>(268 + 4 * axis, static_cast<float>(ras(a, 3)));
    }
  }
  putVoxels<std::int16_t>(bytes, firstVoxel, volume);
  return bytes;
}

inline std::string nrrdHeader(const std::string& type, const std::string& encoding,
                              const std::string& space, double sign)
{
  const Eigen::Matrix4d lps = obliqueCt().lpsFromIndex();
  const auto vector = [&](Eigen::Index column) {
    return "(" + std::to_string(sign * lps(0, column)) + "," +
           std::to_string(sign * lps(1, column)) + "," + std::to_string(lps(2, column)) + ")";
  };
  return "NRRD0004\n# made by hand\ntype: " + type + "\ndimension: 3\nspace: " + space +
         "\nsizes: 12 10 8\nspace directions: " + vector(0) + " " + vector(1) + " " + vector(2) +
         "\nkinds: domain domain domain\nendian: little\n" + "encoding: " + encoding +
         "\nspace origin: " + vector(3) + "\nkey:=value\n\n";
}

inline std::string gzipped(const std::string& content)
{
  z_stream stream = {};
  deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  std::string packed(content.size() + 1000, '\0');
  std::string given = content;
  stream.next_in = reinterpret_cast<unsigned char*>(given.data());
  stream.avail_in = static_cast<unsigned>(given.size());
  stream.next_out = reinterpret_cast<unsigned char*>(packed.data());
  stream.avail_out = static_cast<unsigned>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

/// Packed as MetaImage does, by zlib.
inline std::string zipped(const std::string& content)
{
  uLongf size = compressBound(content.size());
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &size,
           reinterpret_cast<const Bytef*>(content.data()), content.size());
  packed.resize(size);
  return packed;
}

/// A MetaImage header of the same volume, with more lines before the last one.
inline std::string metaHeader(const std::string& more = "", const std::string& data = "LOCAL")
{
  const Eigen::Matrix4d lps = obliqueCt().lpsFromIndex();
  const Eigen::Vector3d spacing = obliqueCt().spacing_mm();
  std::string text =
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
      "TransformMatrix =";
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    for (Eigen::Index row = 0; row < 3; ++row)
      text += " " + std::to_string(lps(row, axis) / spacing[axis]);
  text += "\nOffset =";
  for (Eigen::Index row = 0; row < 3; ++row) text += " " + std::to_string(lps(row, 3));
  return text + "\nElementSpacing = 0.3 0.4 0.6\nDimSize = 12 10 8\n" + more +
         "ElementType = MET_SHORT\nElementDataFile = " + data + "\n";
}

/// Its voxels, 16 bits little-endian.
inline std::string obliqueVoxels()
{
  Bytes voxels(2 * voxelCount);
  putVoxels<std::int16_t>(voxels, 0, obliqueCt());
  return voxels.content;
}

/// A text with one part replaced by another.
inline std::string replaced(std::string text, const std::string& part, const std::string& by)
{
  const std::size_t at = text.find(part);
  if (at == std::string::npos) throw std::runtime_error(part + " is not there");
  return text.replace(at, part.size(), by);
}

}  // namespace perilymph::imaging
