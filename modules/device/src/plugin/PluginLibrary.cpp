// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/PluginLibrary.h"

#include <dlfcn.h>

#include <string>
#include <utility>
#include <vector>

#include "plugin/Refusals.h"

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

/// The version of a library that has the entry of another one than this program; 0 if it has none.
std::uint32_t otherVersion(void* library)
{
  constexpr std::uint32_t latest = 9;
  for (std::uint32_t version = knownVersion + 1; version <= latest; ++version)
    if (::dlsym(library, ("perilymph_device_v" + std::to_string(version)).c_str()) != nullptr)
      return version;
  return 0;
}

Error refused(Phrase why, std::vector<Sentence> values = {})
{
  return Error{Sentence(why, std::move(values))};
}

Error wrongVersion(std::uint32_t version)
{
  return refused(refusals::isOfAnotherVersion,
                 {std::to_string(version), std::to_string(knownVersion)});
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
    return refused(refusals::cannotBeLoaded, {std::string(why != nullptr ? why : "")});
  }
  const auto entry = reinterpret_cast<PerilymphDeviceEntryV1>(::dlsym(library.get(), entryName));
  if (entry == nullptr) {
    if (const auto other = otherVersion(library.get()); other != 0) return wrongVersion(other);
    return refused(refusals::isNoPlugin, {std::string(entryName)});
  }
  const PerilymphDeviceV1* functions = entry();
  if (functions == nullptr) return refused(refusals::givesNothing, {std::string(entryName)});
  if (functions->version != knownVersion) return wrongVersion(functions->version);
  if (functions->size < sizeof(PerilymphDeviceV1) || !isComplete(*functions))
    return refused(refusals::isIncomplete);

  void* device = functions->create();
  if (device == nullptr) return refused(refusals::findsNoDevice);
  Library loaded(std::move(library), *functions, device);
  loaded.traits_.size = sizeof loaded.traits_;
  if (functions->traits(device, &loaded.traits_) != 0) return refused(refusals::tellsNoTraits);
  return loaded;
}

}  // namespace perilymph::device::plugin
