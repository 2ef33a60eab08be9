// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes the device profile with any text.

#include <fstream>
#include <iterator>

#include "Descriptors.h"
#include "FuzzTarget.h"
#include "codec/DeviceCodec.h"
#include "codec/DeviceProfile.h"

namespace perilymph::fuzz {

std::vector<Bytes> seeds()
{
  std::vector<Bytes> texts;
  for (const device::DeviceProfile& profile : device::shippedProfiles().profiles) {
    std::ifstream file(profile.file, std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  promise(!texts.empty(), "profiles are shipped");
  return texts;
}

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  static const auto stick = *device::ReportDescriptor::parse(device::test::pidDescriptor());
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto profile = device::parseProfile(text, "input");
  if (!profile) {
    fuzz::promise(!profile.error().message.empty(), "a refusal has a sentence");
    return 0;
  }
  // An accepted profile can be used.
  const auto codec = device::makeCodec(*profile, stick);
  const device::DeviceTraits traits = device::traitsOf(*profile, stick);
  fuzz::promise(traits.nominalPeriod >= 1e-4 && traits.nominalPeriod <= 0.1, "a period in range");
  fuzz::promise(!traits.rendersForce || traits.maxForce > 0.0, "a force in range");
  if (!codec) fuzz::promise(!codec.error().message.empty(), "a refusal has a sentence");
  device::matchingProfile({&*profile, 1}, {1, 2, 3}, stick);
  return 0;
}
