// SPDX-License-Identifier: BSD-3-Clause
#include "SeriesGroups.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "../statements/Warnings.h"

namespace perilymph::imaging {
namespace {

/// Digests of patient, study and frame of reference.
using Belonging = std::array<std::string, 3>;

Belonging belongingOf(const DicomHeader& header)
{
  return {header.identity.patient, header.identity.study, header.identity.frameOfReference};
}

/// What is absent in some files and the same in all others says nothing against those.
void fillIn(std::vector<Belonging>& all)
{
  for (std::size_t part = 0; part < 3; ++part) {
    std::set<std::string> stated;
    for (const Belonging& one : all)
      if (!one[part].empty()) stated.insert(one[part]);
    if (stated.size() == 1)
      for (Belonging& one : all) one[part] = *stated.begin();
  }
}

std::string uidWith(const std::string& uid, std::size_t number)
{
  return uid + "#" + std::to_string(number);
}

/// The groups of the files that state one UID.
void split(const std::string& uid, std::vector<DicomHeader> headers, std::vector<SeriesGroup>& all)
{
  std::vector<Belonging> belongings;
  for (const DicomHeader& header : headers) belongings.push_back(belongingOf(header));
  fillIn(belongings);
  std::map<Belonging, std::vector<DicomHeader>> parts;
  std::set<std::pair<std::string, std::string>> studies;
  for (std::size_t i = 0; i < headers.size(); ++i) {
    parts[belongings[i]].push_back(std::move(headers[i]));
    studies.emplace(belongings[i][0], belongings[i][1]);
  }
  const std::size_t images = headers.size();
  std::vector<std::vector<DicomHeader>> sorted;
  for (auto& [belonging, part] : parts) sorted.push_back(std::move(part));
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const bool isAlone = sorted.size() == 1 || (studies.size() == 1 && i == 0);
    SeriesGroup group{isAlone ? uid : uidWith(uid, i + 1), {}, std::move(sorted[i])};
    if (sorted.size() > 1)
      group.warning = Sentence(
          warnings::listedApart,
          {std::to_string(images - group.headers.size()), std::to_string(images),
           Sentence(studies.size() > 1 ? warnings::patientOrStudy : warnings::frameOfReference)});
    all.push_back(std::move(group));
  }
}

}  // namespace

std::vector<SeriesGroup> groupsOf(std::vector<DicomHeader> headers)
{
  std::map<std::string, std::vector<DicomHeader>> byUid;
  std::map<std::filesystem::path, std::string> unnamed;
  for (DicomHeader& header : headers) {
    std::string uid = header.seriesUid;
    if (uid.empty()) {
      std::string& name = unnamed[header.file.parent_path()];
      if (name.empty()) name = "without-uid-" + std::to_string(unnamed.size());
      uid = name;
    }
    byUid[uid].push_back(std::move(header));
  }
  std::vector<SeriesGroup> all;
  for (auto& [uid, files] : byUid) split(uid, std::move(files), all);
  return all;
}

}  // namespace perilymph::imaging
