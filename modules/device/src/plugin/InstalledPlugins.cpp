// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdint>

#include "hid/Intervals.h"
#include "perilymph/device/PluginDevice.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/realtime/Pacer.h"
#include "plugin/LoadingPlugin.h"

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

std::vector<FoundPlugin> surveyPlugins(const std::vector<fs::path>& folders, Duration patience)
{
  std::vector<FoundPlugin> survey;
  std::vector<Result<plugin::LoadingPlugin>> loading;
  for (const fs::path& folder : folders)
    for (const fs::path& file : pluginLibraries(folder)) {
      survey.push_back({file, file.stem().string(), {}, {}});
      loading.push_back(plugin::beginToLoad(file));
    }
  const std::int64_t end = realtime::monotonicNanoseconds() + nanoseconds(patience.si());
  for (std::size_t i = 0; i < survey.size(); ++i) {
    const auto rest = static_cast<double>(end - realtime::monotonicNanoseconds());
    const auto device = loading[i]
                            ? plugin::awaitDevice(*std::move(loading[i]),
                                                  Duration::fromSi(std::max(0.0, rest * 1e-9)))
                            : Result<std::unique_ptr<HapticDevice>>(loading[i].error());
    if (device) {
      survey[i].traits = (*device)->traits();
      survey[i].name = survey[i].traits.name;
    } else {
      survey[i].obstacle = device.error().message;
    }
  }
  return survey;
}

Result<const FoundPlugin*> pluginNamed(const std::vector<FoundPlugin>& survey,
                                       const std::string& name)
{
  std::vector<const FoundPlugin*> found;
  for (const FoundPlugin& plugin : survey) {
    if (name == plugin.file.string()) return &plugin;
    if (name == plugin.file.filename().string() || name == plugin.file.stem().string() ||
        name == plugin.name)
      found.push_back(&plugin);
  }
  if (found.size() < 2) return found.empty() ? nullptr : found.front();
  std::string files;
  for (const FoundPlugin* plugin : found)
    files += (files.empty() ? "" : ", ") + plugin->file.string();
  return Error{"%1 plug-ins are named %2: %3. Give the path of one of them.", found.size(), name,
               files};
}

}  // namespace perilymph::device
