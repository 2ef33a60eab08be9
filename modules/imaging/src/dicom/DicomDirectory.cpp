// SPDX-License-Identifier: BSD-3-Clause
#include "DicomDirectory.h"

#include <vtkDICOMDictionary.h>
#include <vtkDICOMItem.h>
#include <vtkDICOMSequence.h>

#include <cctype>
#include <map>
#include <string>
#include <system_error>

#include "DicomParse.h"

namespace perilymph::imaging {

namespace fs = std::filesystem;

namespace {

/// A name as media compare it: upper case, without version and ending.
std::string plainName(std::string name)
{
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  if (const auto version = name.rfind(';'); version != std::string::npos) name.resize(version);
  for (const char* const ending : {".DCM", ".IMA", "."})
    if (name.ends_with(ending)) name.resize(name.size() - std::string(ending).size());
  return name;
}

/// Finds names in folders in any spelling; each folder is listed once.
class Spellings {
public:
  /// The entry of a folder that a name stands for; none where there is none, or more than one.
  std::optional<fs::path> find(const fs::path& folder, const std::string& name)
  {
    std::error_code failed;
    if (fs::exists(folder / name, failed)) return folder / name;
    const auto [place, isNew] = folders_.try_emplace(folder);
    if (isNew)
      for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end;
           entry.increment(failed))
        place->second.emplace(plainName(entry->path().filename().string()), entry->path());
    const auto [first, last] = place->second.equal_range(plainName(name));
    if (first == last || std::next(first) != last) return std::nullopt;
    return first->second;
  }

private:
  std::map<fs::path, std::multimap<std::string, fs::path>> folders_;
};

/// Components of a file's name in a record; empty where it leads out of the medium.
std::vector<std::string> namedIn(const vtkDICOMValue& id)
{
  std::vector<std::string> parts;
  for (std::size_t k = 0; k < id.GetNumberOfValues(); ++k) {
    std::string part = id.GetString(k);
    while (!part.empty() && (part.back() == ' ' || part.back() == '\0')) part.pop_back();
    if (part.empty() || part == "." || part == ".." || part.find('/') != std::string::npos)
      return {};
    parts.push_back(part);
  }
  return parts;
}

}  // namespace

std::optional<DicomDirectory> readDicomDirectory(const fs::path& file)
{
  const auto query = vtkSmartPointer<vtkDICOMMetaData>::New();
  query->Set(DC::DirectoryRecordSequence, vtkDICOMValue(vtkDICOMSequence()));
  const auto parsed = parseDicom(file, query);
  if (!parsed || !parsed->values->Has(DC::DirectoryRecordSequence)) return std::nullopt;
  const vtkDICOMSequence records(parsed->values->Get(DC::DirectoryRecordSequence));
  DicomDirectory directory;
  Spellings spellings;
  for (std::size_t i = 0; i < records.GetNumberOfItems(); ++i) {
    const vtkDICOMValue& id = records.GetItem(i).Get(DC::ReferencedFileID);
    if (!id.IsValid() || id.GetNumberOfValues() == 0) continue;
    const std::vector<std::string> parts = namedIn(id);
    if (parts.empty()) continue;
    std::optional<fs::path> named = file.parent_path().empty() ? fs::path(".") : file.parent_path();
    for (const std::string& part : parts)
      if (named) named = spellings.find(*named, part);
    std::error_code failed;
    if (named && fs::is_regular_file(*named, failed))
      directory.files.push_back(*named);
    else
      ++directory.missing;
  }
  return directory;
}

}  // namespace perilymph::imaging
