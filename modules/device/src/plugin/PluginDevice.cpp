// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/device/PluginDevice.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "perilymph/device/PluginApi.h"

namespace perilymph::device {

namespace {

namespace fs = std::filesystem;

constexpr const char* entryName = "perilymph_device_v1";
constexpr std::uint32_t knownVersion = 1;

struct CloseLibrary {
  void operator()(void* library) const noexcept { ::dlclose(library); }
};
using Library = std::unique_ptr<void, CloseLibrary>;

/// Text of at most `capacity` characters, possibly without a terminating zero.
std::string text(const char* characters, std::size_t capacity)
{
  return std::string(characters, ::strnlen(characters, capacity));
}

Error refused(const fs::path& library, const std::string& why)
{
  return Error{"The plug-in " + library.string() + " is not taken: " + why};
}

bool isComplete(const PerilymphDeviceV1& functions)
{
  return functions.create != nullptr && functions.destroy != nullptr &&
         functions.traits != nullptr && functions.open != nullptr && functions.close != nullptr &&
         functions.read != nullptr && functions.write != nullptr;
}

/// Adapter of a plug-in's device to HapticDevice.
class PluginDevice final : public HapticDevice {
public:
  PluginDevice(Library library, const PerilymphDeviceV1& functions, void* device,
               DeviceTraits traits)
      : library_(std::move(library)),
        functions_(functions),
        device_(device),
        traits_(std::move(traits))
  {
  }
  PluginDevice(const PluginDevice&) = delete;
  PluginDevice& operator=(const PluginDevice&) = delete;
  ~PluginDevice() override
  {
    close();
    functions_.destroy(device_);
  }

  DeviceTraits traits() const override { return traits_; }

  Result<Done> open() override
  {
    if (isOpen_) return Done{};
    std::array<char, 512> sentence{};
    const auto capacity = static_cast<std::uint32_t>(sentence.size() - 1);
    if (functions_.open(device_, sentence.data(), capacity) == 0) {
      isOpen_ = true;
      hasFailed_ = false;
      return Done{};
    }
    const std::string said = text(sentence.data(), capacity);
    return Error{said.empty() ? "The " + traits_.name +
                                    " cannot be opened, and its plug-in does not say why."
                              : said};
  }

  void close() noexcept override
  {
    if (!isOpen_) return;
    write({});
    functions_.close(device_);
    isOpen_ = false;
  }

  DeviceSample read() noexcept override
  {
    if (!isOpen_) return {};
    PerilymphDeviceSampleV1 said{};
    said.size = sizeof said;
    said.rotation_D[0] = 1.0;
    if (functions_.read(device_, &said) != 0) return {};
    DeviceSample sample;
    sample.sequence = said.sequence;
    std::copy_n(said.position_D_m, 3, sample.position_D.begin());
    std::copy_n(said.rotation_D, 4, sample.rotation_D.begin());
    sample.buttons = said.buttons;
    sample.isValid = said.is_valid != 0 && !hasFailed_ ? 1u : 0u;
    return sample;
  }

  void write(const Wrench& wrench_D) noexcept override
  {
    if (!isOpen_) return;
    PerilymphDeviceWrenchV1 told{};
    told.size = sizeof told;
    std::copy_n(wrench_D.force_D.begin(), 3, told.force_D_N);
    std::copy_n(wrench_D.torque_D.begin(), 3, told.torque_D_N_m);
    // A device that refuses its force is regarded as not responding, as the next samples report.
    hasFailed_ = functions_.write(device_, &told) != 0;
  }

private:
  Library library_;
  const PerilymphDeviceV1& functions_;
  void* device_;
  DeviceTraits traits_;
  bool isOpen_ = false;
  bool hasFailed_ = false;
};

/// Validates the traits of a plug-in; invalid ones could permit any force.
Result<DeviceTraits> checked(const PerilymphDeviceTraitsV1& said)
{
  DeviceTraits traits;
  traits.name = text(said.name, sizeof said.name);
  if (traits.name.empty()) return Error{"its device has no name."};
  const auto within = [](double value, double minimum, double maximum) {
    return value >= minimum && value <= maximum;  // false for NaN
  };
  if (!within(said.nominal_period_s, 1e-4, 0.1))
    return Error{"its period between samples is " + std::to_string(said.nominal_period_s) +
                 " s; it must be between 0.0001 and 0.1."};
  if (said.renders_force != 0 && !within(said.max_force_N, 0.01, 50.0))
    return Error{"its greatest force is " + std::to_string(said.max_force_N) +
                 " N; it must be between 0.01 and 50."};
  for (const double value :
       {said.workspace_radius_m, said.max_stiffness_N_m, said.max_damping_N_s_m,
        said.position_quantum_m, said.force_quantum_N, said.transport_delay_s, said.watchdog_s})
    if (!within(value, 0.0, 1e6)) return Error{"one of its traits is negative or no number."};
  for (const std::int32_t axes : {said.sensed_translations, said.sensed_rotations,
                                  said.actuated_translations, said.actuated_rotations})
    if (axes < 0 || axes > 3)
      return Error{"it counts " + std::to_string(axes) + " axes; there are 0 to 3 of a sort."};
  if (said.buttons < 0 || said.buttons > 32)
    return Error{"it counts " + std::to_string(said.buttons) + " buttons; 0 to 32 are known."};

  traits.rendersForce = said.renders_force != 0;
  traits.maxForce = traits.rendersForce ? said.max_force_N : 0.0;
  traits.nominalPeriod = said.nominal_period_s;
  traits.workspaceRadius = said.workspace_radius_m;
  traits.maxStiffness = said.max_stiffness_N_m;
  traits.maxDamping = said.max_damping_N_s_m;
  traits.positionQuantum = said.position_quantum_m;
  traits.forceQuantum = said.force_quantum_N;
  traits.transportDelay = said.transport_delay_s;
  traits.watchdog = said.watchdog_s;
  traits.sensedTranslations = said.sensed_translations;
  traits.sensedRotations = said.sensed_rotations;
  traits.actuatedTranslations = said.actuated_translations;
  traits.actuatedRotations = said.actuated_rotations;
  traits.buttons = said.buttons;
  return traits;
}

}  // namespace

Result<std::unique_ptr<HapticDevice>> loadPluginDevice(const fs::path& file)
{
  // An absolute path: a bare name would be searched in the system's library folders.
  std::error_code failure;
  const fs::path path = fs::absolute(file, failure);
  if (failure || !fs::is_regular_file(path, failure))
    return refused(file, "there is no such file. Check the path.");
  Library library(::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL));
  if (!library) {
    const char* why = ::dlerror();
    return refused(file, std::string("it cannot be loaded: ") + (why != nullptr ? why : "") +
                             ". Build it for this machine.");
  }
  const auto entry = reinterpret_cast<PerilymphDeviceEntryV1>(::dlsym(library.get(), entryName));
  if (entry == nullptr)
    return refused(file, std::string("it exports no ") + entryName +
                             ". It is no device plug-in, or one for a later program.");
  const PerilymphDeviceV1* functions = entry();
  if (functions == nullptr) return refused(file, std::string(entryName) + "() gives nothing.");
  if (functions->version != knownVersion)
    return refused(file, "it speaks version " + std::to_string(functions->version) +
                             " of the boundary; this program speaks " +
                             std::to_string(knownVersion) + ". Build it against this program.");
  if (functions->size < sizeof(PerilymphDeviceV1) || !isComplete(*functions))
    return refused(file, "one of its functions is missing. Fill in all of PerilymphDeviceV1.");

  void* device = functions->create();
  if (device == nullptr)
    return refused(file, "it finds no device. Plug the device in and try again.");
  PerilymphDeviceTraitsV1 said{};
  said.size = sizeof said;
  const bool answers = functions->traits(device, &said) == 0;
  Result<DeviceTraits> traits = answers ? checked(said) : Error{"it does not tell its traits."};
  if (!traits) {
    functions->destroy(device);
    return refused(file, traits.error().message);
  }
  return std::unique_ptr<HapticDevice>(
      std::make_unique<PluginDevice>(std::move(library), *functions, device, *std::move(traits)));
}

std::vector<fs::path> pluginLibraries(const fs::path& folder)
{
  std::vector<fs::path> found;
  std::error_code failure;
  fs::recursive_directory_iterator entry(folder, failure);
  for (; !failure && entry != fs::recursive_directory_iterator(); entry.increment(failure)) {
    if (entry.depth() >= 1) entry.disable_recursion_pending();
    std::error_code ignored;
    if (entry->path().extension() == ".so" && entry->is_regular_file(ignored))
      found.push_back(entry->path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace perilymph::device
