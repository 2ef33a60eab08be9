// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The roles of threads.

namespace perilymph {

/// The role of a thread; modules/README.md states what each may do. Every thread that the program
/// starts declares its role first; the main thread of a program without a window has none.
enum class ThreadRole {
  none,
  window,            ///< The main thread of the window: Qt, VTK, commands.
  haptic,            ///< The ticks of an insertion in real time.
  recorder,          ///< Writes ticks into a recording.
  worker,            ///< Works for the window: models, recordings, reports.
  calculation,       ///< One of several that run whole insertions in virtual time.
  deviceWriter,      ///< Writes forces to a HID device.
  deviceSupervisor,  ///< Opens a HID device and reconnects it.
  tapeWriter,        ///< Writes the reports of a HID device to a tape.
  pluginWatch,       ///< Ends the process of a device plug-in that hangs.
  sound,             ///< Plays the force as a tone.
  broadcast,         ///< Sends an insertion to other programs.
};

/// Sets the role of the calling thread for its lifetime, and its name as shown by debuggers and
/// `top -H`. The main thread keeps the name of the program.
void declareThread(ThreadRole role) noexcept;

/// The role that the calling thread declared; none before that.
ThreadRole threadRole() noexcept;

/// Whether the calling thread has the role.
inline bool isOnThread(ThreadRole role) noexcept { return threadRole() == role; }

/// Whether the calling thread may act in a role: it has the role, or it runs an insertion in virtual
/// time and acts in all of them (a calculation, a test, the command line).
inline bool mayActAs(ThreadRole role) noexcept
{
  return isOnThread(role) || isOnThread(ThreadRole::none) || isOnThread(ThreadRole::calculation);
}

/// Name of a thread for the operating system, at most 15 characters.
const char* threadName(ThreadRole role) noexcept;

}  // namespace perilymph

#include <cassert>

/// In debug builds, asserts that the calling thread may act in this role.
#define PERILYMPH_EXPECTS_ROLE(role) assert(::perilymph::mayActAs(::perilymph::ThreadRole::role))
