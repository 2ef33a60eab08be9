// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/InputChoice.h"

#include <QVariant>

#include "gui/run/UserSettings.h"

namespace perilymph::gui {

namespace {

using Made = Result<std::unique_ptr<device::HapticDevice>>;

QString key() { return QStringLiteral("input/device"); }
constexpr const char* hidMark = "hid ";
constexpr const char* pluginMark = "plugin ";

/// The rest of the setting after its mark; empty if it has another one.
std::string stored(const std::string& mark)
{
  const std::string text = UserSettings().value(key()).toString().toStdString();
  return text.starts_with(mark) ? text.substr(mark.size()) : std::string();
}

void store(const std::string& text)
{
  UserSettings().setValue(key(), QString::fromStdString(text));
}

InsertionControl::DeviceFactory factoryOf(const device::FoundDevice& found)
{
  return [found]() -> Made { return device::makeHidDevice(found, device::systemRoots()); };
}

InsertionControl::DeviceFactory factoryOf(const std::filesystem::path& plugin)
{
  return InsertionControl::DeviceFactory::slow(
      plugin.stem().string(), [plugin](const std::stop_token& stop) -> Made {
        return device::loadPluginDevice(plugin, device::patienceForLoading, stop);
      });
}

}  // namespace

void rememberInput(const device::FoundDevice& found) { store(hidMark + device::choiceText(found)); }

void rememberInput(const std::filesystem::path& plugin) { store(pluginMark + plugin.string()); }

bool isRememberedInput(const device::FoundDevice& found, const device::DeviceSurvey& survey)
{
  const device::FoundDevice* const chosen = device::chosenDevice(survey, stored(hidMark));
  return chosen != nullptr && chosen->node.path == found.node.path;
}

bool isRememberedInput(const std::filesystem::path& plugin)
{
  return stored(pluginMark) == plugin.string();
}

std::optional<InsertionControl::DeviceFactory> rememberedInput()
{
  std::error_code failure;
  if (const std::filesystem::path plugin = stored(pluginMark);
      std::filesystem::is_regular_file(plugin, failure))
    return factoryOf(plugin);
  const std::string choice = stored(hidMark);
  if (choice.empty()) return std::nullopt;
  const device::DeviceSurvey survey = device::surveyDevices(device::systemRoots());
  const device::FoundDevice* const found = device::chosenDevice(survey, choice);
  if (found == nullptr) return std::nullopt;
  return factoryOf(*found);
}

InsertionControl::DeviceFactory inputNamed(const std::string& name)
{
  const auto search = [name](const std::stop_token& stop) -> Made {
    const device::SystemRoots roots = device::systemRoots();
    const auto found = device::findDevice(device::surveyDevices(roots), name);
    if (found) return device::makeHidDevice(*found, roots);
    const auto plugins = device::surveyPlugins();
    const auto plugin = device::pluginNamed(plugins, name);
    if (!plugin) return plugin.error();
    if (*plugin == nullptr) return found.error();
    return device::loadPluginDevice((*plugin)->file, device::patienceForLoading, stop);
  };
  // only plug-ins take long
  if (device::findDevice(device::surveyDevices(device::systemRoots()), name))
    return [search] { return search({}); };
  return InsertionControl::DeviceFactory::slow(name, search);
}

}  // namespace perilymph::gui
