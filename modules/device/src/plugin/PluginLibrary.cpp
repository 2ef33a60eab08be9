// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/PluginLibrary.h"

#include <dlfcn.h>

#include <string>

namespace perilymph::device::plugin {

namespace {

constexpr const char* entryName = "perilymph_device_v1";
constexpr std::uint32_t knownVersion = 1;

bool isComplete(const PerilymphDeviceV1& functions)
{
  return functions.create != nullptr && functions.destroy != nullptr &&
         functions.traits != nullptr && functions.open != nullptr && functions.close != nullptr &&
         functions.read != nullptr && functions.write != nullptr;
}

}  // namespace

void CloseLibrary::operator()(void* library) const noexcept { ::dlclose(library); }

Library::~Library()
{
  if (device_) functions_->destroy(device_.get());
}

Result<Library> Library::load(const std::filesystem::path& file)
{
  std::unique_ptr<void, CloseLibrary> library(::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL));
  if (!library) {
    const char* why = ::dlerror();
    return Error{"it cannot be loaded: %1. Build it for this machine.",
                 (why != nullptr ? why : "")};
  }
  const auto entry = reinterpret_cast<PerilymphDeviceEntryV1>(::dlsym(library.get(), entryName));
  if (entry == nullptr)
    return Error{"it exports no %1. It is no device plug-in, or one for a later program.",
                 entryName};
  const PerilymphDeviceV1* functions = entry();
  if (functions == nullptr) return Error{"%1() gives nothing.", std::string(entryName)};
  if (functions->version != knownVersion)
    return Error{
        "it speaks version %1 of the boundary; this program speaks %2. Build it against this "
        "program.",
        functions->version, knownVersion};
  if (functions->size < sizeof(PerilymphDeviceV1) || !isComplete(*functions))
    return Error{"one of its functions is missing. Fill in all of PerilymphDeviceV1."};

  void* device = functions->create();
  if (device == nullptr) return Error{"it finds no device. Plug the device in and try again."};
  Library loaded(std::move(library), *functions, device);
  loaded.traits_.size = sizeof loaded.traits_;
  if (functions->traits(device, &loaded.traits_) != 0) return Error{"it does not tell its traits."};
  return loaded;
}

}  // namespace perilymph::device::plugin
