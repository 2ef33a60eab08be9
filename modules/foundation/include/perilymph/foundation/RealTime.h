// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Real-time annotation of functions, and the roles of threads.

#if defined(__clang__) && __clang_major__ >= 20
/// Marks a function of the tick: it neither allocates, locks, waits, logs nor throws.
#define PERILYMPH_REALTIME [[clang::nonblocking]]
#else
/// Marks a function of the tick: it neither allocates, locks, waits, logs nor throws.
#define PERILYMPH_REALTIME
#endif

namespace perilymph {

/// The role of a thread. Each thread registers its role once, when it starts.
enum class ThreadRole { none, haptic, recorder, worker, ui };

/// Sets the role of the calling thread.
void registerThreadRole(ThreadRole role) noexcept;

/// The role the calling thread registered; none before that.
ThreadRole threadRole() noexcept;

}  // namespace perilymph

#include <cassert>

/// In debug builds, asserts that the calling thread has this role. A thread without a role (a test,
/// a command-line run in virtual time) may take any.
#define PERILYMPH_EXPECTS_ROLE(role)                                   \
  assert(::perilymph::threadRole() == ::perilymph::ThreadRole::none || \
         ::perilymph::threadRole() == ::perilymph::ThreadRole::role)
