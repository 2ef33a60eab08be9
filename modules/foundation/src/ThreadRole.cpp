// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/RealTime.h"

namespace perilymph {
namespace {

thread_local ThreadRole roleOfThisThread = ThreadRole::none;

}  // namespace

void registerThreadRole(ThreadRole role) noexcept { roleOfThisThread = role; }

ThreadRole threadRole() noexcept { return roleOfThisThread; }

}  // namespace perilymph
