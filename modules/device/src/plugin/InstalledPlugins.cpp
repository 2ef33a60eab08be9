// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "perilymph/device/PluginDevice.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::device {

namespace fs = std::filesystem;

std::vector<fs::path> pluginLibraries(const fs::path& folder)
{
  std::vector<fs::path> found;
  std::error_code failure;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                         failure);
  for (; !failure && entry != fs::recursive_directory_iterator(); entry.increment(failure)) {
    if (entry.depth() >= 1) entry.disable_recursion_pending();
    std::error_code ignored;
    // Also what is not a file: it is listed with the reason.
    if (entry->path().extension() == ".so" && !entry->is_directory(ignored))
      found.push_back(entry->path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<fs::path> pluginFolders()
{
  std::vector<fs::path> folders{sessionFolder().parent_path() / "plugins"};
  std::error_code failure;
  const fs::path program = fs::read_symlink("/proc/self/exe", failure);
  if (!failure)
    folders.push_back((program.parent_path() / PERILYMPH_PLUGINS_FROM_PROGRAMS).lexically_normal());
  return folders;
}

std::vector<FoundPlugin> surveyPlugins(const std::vector<fs::path>& folders)
{
  std::vector<FoundPlugin> survey;
  for (const fs::path& folder : folders)
    for (const fs::path& file : pluginLibraries(folder)) {
      FoundPlugin plugin{file, file.stem().string(), {}, {}};
      if (const auto device = loadPluginDevice(file, patienceForSurvey)) {
        plugin.traits = (*device)->traits();
        plugin.name = plugin.traits.name;
      } else {
        plugin.obstacle = device.error().message;
      }
      survey.push_back(std::move(plugin));
    }
  return survey;
}

const FoundPlugin* pluginNamed(const std::vector<FoundPlugin>& survey, const std::string& name)
{
  const auto matches = [&name](const FoundPlugin& plugin) {
    return name == plugin.file.string() || name == plugin.file.filename().string() ||
           name == plugin.file.stem().string() || name == plugin.name;
  };
  const auto found = std::find_if(survey.begin(), survey.end(), matches);
  return found == survey.end() ? nullptr : &*found;
}

}  // namespace perilymph::device
