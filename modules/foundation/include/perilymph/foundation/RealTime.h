#pragma once

// Marks of the haptic tick, and the roles of threads.

#if defined(__clang__) && __clang_major__ >= 20
/// Marks a function of the tick: it neither allocates, locks, waits, logs nor throws.
#define PERILYMPH_REALTIME [[clang::nonblocking]]
#else
/// Marks a function of the tick: it neither allocates, locks, waits, logs nor throws.
#define PERILYMPH_REALTIME
#endif

namespace perilymph {

/// What a thread is for. Each thread says so once, when it starts.
enum class ThreadRole { none, haptic, recorder, worker, ui };

/// Tells which role the calling thread has from now on.
void registerThreadRole(ThreadRole role) noexcept;

/// The role the calling thread registered; none before that.
ThreadRole threadRole() noexcept;

}  // namespace perilymph

#include <cassert>

/// In debug builds, stops a thread that has registered another role. A thread without a role (a
/// test, a command-line run in virtual time) may play any.
#define PERILYMPH_EXPECTS_ROLE(role)                                   \
  assert(::perilymph::threadRole() == ::perilymph::ThreadRole::none || \
         ::perilymph::threadRole() == ::perilymph::ThreadRole::role)
