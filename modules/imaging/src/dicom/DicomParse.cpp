// SPDX-License-Identifier: BSD-3-Clause
#include "DicomParse.h"

#include <vtkDICOMParser.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "../VtkErrorCollector.h"
#include "perilymph/foundation/Utf8.h"

namespace perilymph::imaging {
namespace {

/// True for a file that begins as DICOM files do, with or without their preamble.
bool beginsAsDicom(const std::filesystem::path& file)
{
  std::array<char, 132> start{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(start.data(), start.size());
  const auto bytes = stream.gcount();
  if (bytes == 132 && std::equal(start.begin() + 128, start.end(), "DICM")) return true;
  return bytes >= 8 && (start[0] == 0x02 || start[0] == 0x08) && start[1] == 0 && start[3] == 0;
}

}  // namespace

std::optional<ParsedDicom> parseDicom(const std::filesystem::path& file, vtkDICOMMetaData* wanted)
{
  if (!beginsAsDicom(file)) return std::nullopt;
  const auto complaints = vtkSmartPointer<ErrorCollector>::New();
  const auto parser = vtkSmartPointer<vtkDICOMParser>::New();
  ParsedDicom parsed;
  parsed.values = vtkSmartPointer<vtkDICOMMetaData>::New();
  complaints->listenTo({parser, parsed.values});
  parser->SetMetaData(parsed.values);
  parser->SetQuery(wanted);
  parser->SetFileName(file.c_str());
  parser->Update();
  parsed.hasPixels = parser->GetPixelDataFound();
  parsed.isDamaged = complaints->isAny;
  parsed.pixelStart = parser->GetFileOffset();
  parsed.fileSize = parser->GetFileSize();
  parsed.pixelLength = parser->GetPixelDataVL();
  return parsed;
}

std::string textIn(const vtkDICOMValue& value)
{
  if (!value.IsValid()) return {};
  std::string text = onOneLine(validUtf8(value.AsUTF8String()));
  while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
  constexpr std::size_t maxText = 128;
  if (text.size() > maxText) text = validUtf8(text.substr(0, maxText));
  return text;
}

std::string uidIn(const vtkDICOMValue& value)
{
  std::string text = value.IsValid() ? value.AsString() : std::string();
  if (const auto end = text.find_last_not_of('\0'); end != std::string::npos)
    text.resize(end + 1);
  else
    text.clear();
  return text;
}

bool hasValue(const vtkDICOMValue& value, const char* wanted)
{
  for (std::size_t i = 0; value.IsValid() && i < value.GetNumberOfValues(); ++i)
    if (value.GetString(i) == wanted) return true;
  return false;
}

}  // namespace perilymph::imaging
