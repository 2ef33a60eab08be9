// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/ScenarioFiles.h"

#include <algorithm>

#include "perilymph/foundation/Resources.h"

namespace perilymph::session {

namespace fs = std::filesystem;

Result<fs::path> findPatient(const std::string& patient, const fs::path& folder)
{
  std::error_code ignored;
  if (!folder.empty()) {
    for (const fs::path& place : {folder / patient, folder / (patient + ".toml")})
      if (fs::is_regular_file(place, ignored)) return place;
  }
  return findByName("patient", "resources/patients", patient);
}

std::string pathBeside(const std::string& nameOrFile, const fs::path& folder)
{
  const fs::path file = nameOrFile;
  std::error_code ignored;
  // a name is of a shipped file, whatever lies in the folder
  if (folder.empty() || file.extension() != ".toml" || file.is_absolute() ||
      !fs::is_regular_file(folder / file, ignored))
    return nameOrFile;
  return fs::absolute(folder / file).lexically_normal().string();
}

Overrides withFilesIn(const fs::path& folder, Overrides overrides)
{
  for (auto& [key, value] : overrides)
    if (std::ranges::find(fileKeys, key) != fileKeys.end()) value = pathBeside(value, folder);
  return overrides;
}

std::vector<fs::path> filesOf(const ScenarioContent& scenario, const std::string& friction,
                              const fs::path& folder)
{
  std::vector<fs::path> files;
  const auto add = [&files](const Result<fs::path>& file) {
    if (file) files.push_back(*file);
  };
  if (!scenario.patientName.empty()) add(findPatient(scenario.patientName, folder));
  add(findByName("array", "plugins/electrodes", scenario.arrayName));
  add(findByName("friction", "resources/friction", friction));
  if (!scenario.calibrationName.empty())
    add(findByName("calibration", "resources/calibration", scenario.calibrationName));
  return files;
}

}  // namespace perilymph::session
