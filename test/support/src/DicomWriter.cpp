// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/DicomWriter.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace perilymph::test {
namespace {

constexpr int storedZero = 1024;  // stored values are Hounsfield units plus this

void putNumber(std::string& bytes, std::uint32_t value, int count)
{
  for (int k = 0; k < count; ++k) bytes += static_cast<char>(value >> (8 * k) & 0xFF);
}

std::string padded(std::string value, char with)
{
  if (value.size() % 2 != 0) value += with;
  return value;
}

std::string decimal(const std::vector<double>& values)
{
  std::string text;
  for (const double value : values) {
    char number[32];
    std::snprintf(number, sizeof number, "%.10g", value);
    text += (text.empty() ? "" : "\\") + std::string(number);
  }
  return text;
}

std::string element(DicomTag tag, const std::string& type, const std::string& value)
{
  std::string bytes;
  putNumber(bytes, tag >> 16, 2);
  putNumber(bytes, tag & 0xFFFF, 2);
  bytes += type;
  const bool isLong = type == "OB" || type == "OW" || type == "SQ" || type == "UN" || type == "UT";
  if (isLong) putNumber(bytes, 0, 2);
  // A compressed image has no length of its own.
  const bool isOpen = tag == 0x7FE00010 && type == "OB";
  putNumber(bytes, isOpen ? 0xFFFFFFFF : static_cast<std::uint32_t>(value.size()), isLong ? 4 : 2);
  return bytes + value;
}

Eigen::Vector3d column(const ct::CtVolume& volume, Eigen::Index axis)
{
  return volume.lpsFromIndex().block<3, 1>(0, axis);
}

std::vector<double> orientation(const ct::CtVolume& volume)
{
  const Eigen::Vector3d row = column(volume, 0).normalized();
  const Eigen::Vector3d down = column(volume, 1).normalized();
  return {row.x(), row.y(), row.z(), down.x(), down.y(), down.z()};
}

std::vector<double> position(const ct::CtVolume& volume, int k)
{
  const Eigen::Vector3d place = volume.toLps({0.0, 0.0, static_cast<double>(k)});
  return {place.x(), place.y(), place.z()};
}

std::vector<std::uint16_t> stored(const ct::CtVolume& volume, int first, int last)
{
  std::vector<std::uint16_t> values;
  for (int k = first; k < last; ++k)
    for (int j = 0; j < volume.size()[1]; ++j)
      for (int i = 0; i < volume.size()[0]; ++i) {
        const int value = volume.voxel(i, j, k) + storedZero;
        if (value < 0) throw std::runtime_error("A voxel is below -1024 HU.");
        values.push_back(static_cast<std::uint16_t>(value));
      }
  return values;
}

/// What every image of a CT says.
DicomData common(const ct::CtVolume& volume, const std::string& seriesUid)
{
  DicomData data;
  data.setText(0x00080008, "CS", "ORIGINAL\\PRIMARY\\AXIAL");
  data.setText(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.2");
  data.setText(0x00080060, "CS", "CT");
  data.setText(0x00080070, "LO", "Perilymph");
  data.setText(0x00081090, "LO", "Phantom");
  data.setText(0x00100010, "PN", "Secretname^Patient");
  data.setText(0x00100020, "LO", "SECRETID");
  data.setText(0x00100030, "DA", "19010203");
  data.setText(0x00181210, "SH", "Hr64");
  data.setText(0x0020000D, "UI", "1.2.3");
  data.setText(0x0020000E, "UI", seriesUid);
  data.setText(0x00200052, "UI", seriesUid + ".52");  // frame of reference
  data.setNumber(0x00280002, 1);
  data.setText(0x00280004, "CS", "MONOCHROME2");
  data.setNumber(0x00280010, static_cast<std::uint16_t>(volume.size()[1]));
  data.setNumber(0x00280011, static_cast<std::uint16_t>(volume.size()[0]));
  data.setNumber(0x00280100, 16);
  data.setNumber(0x00280101, 16);
  data.setNumber(0x00280102, 15);
  data.setNumber(0x00280103, 0);
  return data;
}

std::vector<double> pixelSpacing(const ct::CtVolume& volume)
{
  return {column(volume, 1).norm(), column(volume, 0).norm()};  // rows first
}

}  // namespace

void DicomData::setBytes(DicomTag tag, const std::string& type, std::string bytes)
{
  elements_[tag] = {type, std::move(bytes)};
}

void DicomData::setText(DicomTag tag, const std::string& type, const std::string& value)
{
  setBytes(tag, type, padded(value, type == "UI" ? '\0' : ' '));
}

void DicomData::setNumber(DicomTag tag, std::uint16_t value)
{
  std::string bytes;
  putNumber(bytes, value, 2);
  setBytes(tag, "US", bytes);
}

void DicomData::setNumbers(DicomTag tag, const std::vector<double>& values)
{
  setText(tag, "DS", decimal(values));
}

void DicomData::setSequence(DicomTag tag, const std::vector<DicomData>& items)
{
  std::string bytes;
  for (const DicomData& item : items) {
    const std::string content = item.elements();
    putNumber(bytes, 0xE000FFFE, 4);
    putNumber(bytes, static_cast<std::uint32_t>(content.size()), 4);
    bytes += content;
  }
  setBytes(tag, "SQ", bytes);
}

void DicomData::setPixels(const std::vector<std::uint16_t>& values)
{
  std::string bytes;
  bytes.reserve(2 * values.size());
  for (const std::uint16_t value : values) putNumber(bytes, value, 2);
  setBytes(0x7FE00010, "OW", std::move(bytes));
}

std::string DicomData::elements() const
{
  std::string bytes;
  for (const auto& [tag, value] : elements_) bytes += element(tag, value.first, value.second);
  return bytes;
}

std::string DicomData::file(const std::string& transferSyntax) const
{
  DicomData meta;
  meta.setBytes(0x00020001, "OB", std::string("\0\1", 2));
  const auto sopClass = elements_.find(0x00080016);
  meta.setText(
      0x00020002, "UI",
      sopClass == elements_.end() ? "1.2.840.10008.5.1.4.1.1.2" : sopClass->second.second.c_str());
  meta.setText(0x00020003, "UI", "1.2.3.4.5");
  meta.setText(0x00020010, "UI", transferSyntax);
  meta.setText(0x00020012, "UI", "1.2.3.6");
  // a class that is stated for the meta information alone belongs there
  DicomData rest = *this;
  if (const auto stated = rest.elements_.extract(0x00020002); !stated.empty())
    meta.setText(0x00020002, "UI", stated.mapped().second.c_str());
  const std::string header = meta.elements();
  std::string length;
  putNumber(length, static_cast<std::uint32_t>(header.size()), 4);
  return std::string(128, '\0') + "DICM" + element(0x00020000, "UL", length) + header +
         rest.elements();
}

std::vector<DicomData> dicomSlices(const ct::CtVolume& volume, const std::string& seriesUid)
{
  std::vector<DicomData> slices;
  for (int k = 0; k < volume.size()[2]; ++k) {
    DicomData data = common(volume, seriesUid);
    data.setText(0x00080018, "UI", seriesUid + "." + std::to_string(k + 1));
    data.setNumbers(0x00180050, {column(volume, 2).norm()});
    data.setText(0x00200013, "IS", std::to_string(k + 1));
    data.setNumbers(0x00200032, position(volume, k));
    data.setNumbers(0x00200037, orientation(volume));
    data.setNumbers(0x00280030, pixelSpacing(volume));
    data.setNumbers(0x00281052, {-storedZero});
    data.setNumbers(0x00281053, {1.0});
    data.setPixels(stored(volume, k, k + 1));
    slices.push_back(std::move(data));
  }
  return slices;
}

DicomData enhancedDicom(const ct::CtVolume& volume, const std::string& seriesUid)
{
  DicomData data = common(volume, seriesUid);
  data.setText(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.2.1");
  data.setText(0x00280008, "IS", std::to_string(volume.size()[2]));
  const auto group = [](DicomTag tag, const DicomData& content) {
    DicomData item;
    item.setSequence(tag, {content});
    return item;
  };
  DicomData measures, values, plane, shared;
  measures.setNumbers(0x00280030, pixelSpacing(volume));
  values.setNumbers(0x00281052, {-storedZero});
  values.setNumbers(0x00281053, {1.0});
  plane.setNumbers(0x00200037, orientation(volume));
  shared.setSequence(0x00209116, {plane});
  shared.setSequence(0x00289110, {measures});
  shared.setSequence(0x00289145, {values});
  data.setSequence(0x52009229, {shared});
  std::vector<DicomData> frames;
  for (int k = 0; k < volume.size()[2]; ++k) {
    DicomData place;
    place.setNumbers(0x00200032, position(volume, k));
    frames.push_back(group(0x00209113, place));
  }
  data.setSequence(0x52009230, frames);
  data.setPixels(stored(volume, 0, volume.size()[2]));
  return data;
}

void writeDicomFiles(const std::vector<DicomData>& files, const std::filesystem::path& folder)
{
  std::filesystem::create_directories(folder);
  // 7919 is a prime, so that no two names are the same.
  for (std::size_t i = 0; i < files.size(); ++i) {
    std::ofstream stream(folder / ("IM" + std::to_string((i + 1) * 7919 % 100'003)),
                         std::ios::binary);
    stream << files[i].file();
    if (!stream) throw std::runtime_error("A DICOM file could not be written.");
  }
}

}  // namespace perilymph::test
