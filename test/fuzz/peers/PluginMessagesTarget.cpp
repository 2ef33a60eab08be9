// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes what the program takes from the process that hosts a plug-in: the first message, with the
// device's traits, and the shared memory. The plug-in may have overwritten both.

#include <cmath>
#include <cstring>
#include <memory>

#include "FuzzTarget.h"
#include "plugin/PluginChannel.h"
#include "plugin/StatedTraits.h"

namespace perilymph::fuzz {

namespace {

namespace plugin = device::plugin;

void checkTraits(const device::DeviceTraits& traits)
{
  promise(!traits.name.empty() && traits.name.size() <= 64, "a device has a name");
  promise(traits.nominalPeriod >= 1e-4 && traits.nominalPeriod <= 0.1, "a period in its range");
  promise(traits.rendersForce ? traits.maxForce >= 0.01 && traits.maxForce <= 50.0
                              : traits.maxForce == 0.0,
          "a force in its range");
  for (const double value :
       {traits.workspaceRadius, traits.maxStiffness, traits.maxDamping, traits.positionQuantum,
        traits.forceQuantum, traits.transportDelay, traits.watchdog})
    promise(std::isfinite(value) && value >= 0.0, "a trait is a number");
  for (const int axes : {traits.sensedTranslations, traits.sensedRotations,
                         traits.actuatedTranslations, traits.actuatedRotations})
    promise(axes >= 0 && axes <= 3, "a number of axes");
  promise(traits.maxTorque == 0.0 || (traits.maxTorque >= 1e-4 && traits.maxTorque <= 10.0),
          "a torque in its range");
  int pushed = 0, turned = 0;
  for (int i = 0; i < 3; ++i) {
    pushed += traits.pushesAlong(i) ? 1 : 0;
    turned += traits.turnsAbout(i) ? 1 : 0;
  }
  promise(pushed == (traits.rendersForce ? traits.actuatedTranslations : 0), "as many as counted");
  promise(turned == (traits.maxTorque > 0.0 ? traits.actuatedRotations : 0), "as many as counted");
}

/// Memory that was overwritten gives values at most, and only new ones.
void checkChannel(std::span<const std::uint8_t> bytes)
{
  static const auto channel = std::make_unique<plugin::Channel>();
  if (!bytes.empty())
    std::memcpy(static_cast<void*>(&channel->samples), bytes.data(),
                std::min(bytes.size(), sizeof channel->samples));
  plugin::HostedSample sample;
  std::uint64_t seen = 0;
  if (!channel->samples.take(sample, seen)) return;
  promise((seen & 1) == 0, "no value that is being written");
  promise(!channel->samples.take(sample, seen), "a value is taken once");
}

}  // namespace

std::vector<Bytes> seeds()
{
  plugin::Reply reply;
  reply.isDone = 1;
  PerilymphDeviceTraitsV1& traits = reply.traits;
  traits.size = sizeof traits;
  traits.renders_force = 1;
  std::strcpy(traits.name, "A device");
  traits.max_force_N = 3.3;
  traits.nominal_period_s = 1e-3;
  traits.buttons = 1;
  traits.sensed_translations = traits.actuated_translations = 3;
  Bytes loaded(sizeof reply);
  std::memcpy(loaded.data(), &reply, sizeof reply);
  // A sample behind it: an even counter, then the words.
  Bytes withSample = loaded;
  withSample.resize(sizeof reply + 256);
  withSample[sizeof reply] = 2;
  reply.isDone = 0;
  reply.sentence.fill('x');  // not terminated
  Bytes refused(sizeof reply);
  std::memcpy(refused.data(), &reply, sizeof reply);
  return {loaded, withSample, refused};
}

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  fuzz::plugin::Reply reply;
  const std::size_t inReply = std::min(size, sizeof reply);
  if (inReply > 0) std::memcpy(static_cast<void*>(&reply), data, inReply);
  fuzz::promise(fuzz::plugin::sentenceOf(reply).size() <= reply.sentence.size(), "a sentence ends");
  const auto traits = fuzz::plugin::checkedTraits(reply.traits);
  if (traits)
    fuzz::checkTraits(*traits);
  else
    fuzz::promise(!traits.error().message.empty(), "a refusal has a sentence");
  fuzz::checkChannel({data + inReply, size - inReply});
  return 0;
}
