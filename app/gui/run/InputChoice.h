// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The device that the user chose last, kept in the settings.

#include <QString>
#include <filesystem>
#include <optional>
#include <string>

#include "gui/run/InsertionControl.h"
#include "perilymph/device/DeviceRegistry.h"
#include "perilymph/device/PluginDevice.h"

namespace perilymph::gui {

/// Keeps a chosen device: a HID device by its place, so that of two equal ones the same is meant
/// next time, a plug-in by its file.
void rememberInput(const device::FoundDevice& found);
void rememberInput(const std::filesystem::path& plugin);

/// Whether the settings name this device.
bool isRememberedInput(const device::FoundDevice& found, const device::DeviceSurvey& survey);
bool isRememberedInput(const std::filesystem::path& plugin);

/// Makes the device chosen last; empty if none was, or if it is not there. A plug-in is there if its
/// file is. Reads the devices of the system, without opening any.
std::optional<InsertionControl::DeviceFactory> rememberedInput();

/// Makes the HID device or plug-in of this name, as `perilymph-cli devices --test` finds it. The
/// search may take seconds, and takes place when the device is made.
InsertionControl::DeviceFactory inputNamed(const std::string& name);

}  // namespace perilymph::gui
