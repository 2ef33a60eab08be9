// SPDX-License-Identifier: BSD-3-Clause
#include "UnfinishedName.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstring>

namespace perilymph {

struct UnfinishedName::Slot {
  std::atomic<bool> isTaken{false};
  std::atomic<bool> isNamed{false};
  char name[4096] = {};  // PATH_MAX of Linux

  // A signal handler receives only a number, so its data must be static.
  static Slot all[16];
};

UnfinishedName::Slot UnfinishedName::Slot::all[16];

static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler reads the slots");

UnfinishedName::~UnfinishedName()
{
  if (slot_ == nullptr) return;
  slot_->isNamed = false;
  slot_->isTaken = false;
}

void UnfinishedName::keep(const std::filesystem::path& file)
{
  if (slot_ == nullptr) {
    const auto free = std::find_if(std::begin(Slot::all), std::end(Slot::all),
                                   [](Slot& slot) { return !slot.isTaken.exchange(true); });
    if (free == std::end(Slot::all)) return;
    slot_ = free;
  }
  slot_->isNamed = false;
  const std::string& name = file.native();
  if (name.size() >= sizeof slot_->name) return;
  std::memcpy(slot_->name, name.c_str(), name.size() + 1);
  slot_->isNamed = true;
}

void UnfinishedName::removeAll() noexcept
{
  for (Slot& slot : Slot::all)
    if (slot.isNamed) ::unlink(slot.name);
}

}  // namespace perilymph
