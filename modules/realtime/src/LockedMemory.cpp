// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/realtime/LockedMemory.h"

#include <sys/mman.h>
#include <sys/resource.h>

#include <array>
#include <cstdio>
#include <string>

namespace perilymph::realtime {

namespace {

/// Stack that is kept for a tick, whose arrays are on the heap (a choice).
constexpr std::size_t stackOfATick = 256 * 1024;
constexpr std::size_t page = 4096;

std::string megabytes(std::size_t bytes)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", static_cast<double>(bytes) * 1e-6);
  return text;
}

}  // namespace

LockedMemory lockMemory(std::span<const std::span<const std::byte>> buffers) noexcept
{
  LockedMemory locked;
  rlimit limit{};
  if (::getrlimit(RLIMIT_MEMLOCK, &limit) == 0) locked.limit = limit.rlim_cur;
  for (const auto& buffer : buffers) locked.requested += buffer.size();
  // On fault: stacks and mappings that are never used take no RAM.
  locked.isWhole = ::mlockall(MCL_CURRENT | MCL_ONFAULT) == 0;
  if (locked.isWhole) return locked;
  for (const auto& buffer : buffers) {
    if (::mlock(buffer.data(), buffer.size()) != 0) break;
    locked.bytes += buffer.size();
  }
  return locked;
}

__attribute__((noinline)) bool lockStack() noexcept
{
  std::array<std::byte, stackOfATick> stack;
  volatile std::byte* const bytes = stack.data();
  for (std::size_t i = 0; i < stack.size(); i += page) bytes[i] = std::byte{0};
  return ::mlock(stack.data(), stack.size()) == 0;
}

Sentence noteOn(const LockedMemory& locked)
{
  if (locked.isComplete()) return {};
  return Sentence{
      "Of the %1 MB of memory in which the haptic loop works %2 MB are locked in RAM; the system "
      "allows %3 MB. "
      "If ticks are late while memory is short, add the line '@audio - memlock unlimited' to "
      "/etc/security/limits.d/audio.conf, join the group audio and log in again.",
      megabytes(locked.requested), megabytes(locked.bytes), megabytes(locked.limit)};
}

}  // namespace perilymph::realtime
