// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The structs that leave the haptic thread: fixed size, no pointers, no Eigen.

#include <array>
#include <bitset>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/mechanics/InsertionModel.h"

namespace perilymph::haptics {

/// Workflow state of an insertion. Owned by the haptic thread.
enum class Workflow : std::uint32_t { idle, armed, inserting, paused, finished, fault };

/// Events and limits of a tick: bits of TickOutput::status.
enum Status : std::uint32_t {
  allWell = 0,
  staleSample = 1u << 0,        ///< No fresh sample from the device for too long: no force.
  forceClamped = 1u << 1,       ///< The rendered force was clamped.
  forceSlewed = 1u << 2,        ///< The rendered force was slew-limited.
  rampingIn = 1u << 3,          ///< The rendered force is fading in.
  notFinite = 1u << 4,          ///< The mechanics overflowed: fault.
  passivityActed = 1u << 5,     ///< Energy returned by the device was damped.
  notConverged = 1u << 6,       ///< The residual exceeds the tolerance.
  deviceLost = 1u << 7,         ///< The device reports that it is gone: fault.
  sampleRejected = 1u << 8,     ///< A physically impossible sample; it was ignored.
  handJumped = 1u << 9,         ///< The hand was farther away than it could have moved: new anchor.
  couplingSoftened = 1u << 10,  ///< The coupling was reduced to what the device can render.
  nearWorkspaceEnd = 1u << 11,  ///< The rendered force fades toward the end of the device's reach.
  stopped = 1u << 12,           ///< Stopped by the user: no motion and no force until `resume`.
  resting = 1u << 13,           ///< The insertion waits, its time does not run: not recorded.
  // How an insertion ended before its stop travel (InsertionEnd.h); set from then on.
  endedByResistance = 1u << 14,  ///< The axial force reached the surgeon's limit.
  endedBuckled = 1u << 15,       ///< The array folded in front of the opening: no force.
  endedOutOfOpening = 1u << 16,  ///< The tip is pushed past the opening: no force.
  endedFoldedTip = 1u << 17,     ///< The tip points back along the scala: no force.
  endedJammed = 1u << 18,        ///< Force above 2 N, or no advance of the tip: no force.
  // The cochlear partition, if it can rupture.
  partitionRuptured = 1u << 19,  ///< It has ruptured; set from then on.
  translocated = 1u << 20,       ///< A part of the array is above it, in the scala vestibuli.
};

/// A command from the window or the command line to the loop. Recordings contain the numbers.
struct Command {
  enum class Kind : std::uint32_t {
    none = 0,
    arm = 1,         ///< Idle -> Armed.
    withdraw = 3,    ///< Finished -> Inserting; the stop travel no longer applies.
    pullStylet = 4,  ///< value: target withdrawal of the stylet [m].
    stop =
        8,  ///< Inserting -> Paused, no force; not sent, but requested (HapticLoop::requestStop).
    resume =
        9,  ///< After `stop`: a hand that holds the device grasps again, and the force fades in.
  };
  Kind kind = Kind::none;
  std::uint32_t reserved = 0;
  double value = 0.0;
};

inline constexpr int maxCommandsPerTick = 8;

/// The commands of one tick.
struct CommandList {
  std::uint32_t count = 0;
  std::uint32_t reserved = 0;
  std::array<Command, maxCommandsPerTick> items{};
};

/// The first rupture of the cochlear partition, and what went through; all 0 before it.
struct Translocation {
  double angle = 0.0;        ///< Place of the rupture, from the round window [rad].
  double force = 0.0;        ///< Normal to the partition, within one contact [N].
  double depth = 0.0;        ///< Insertion depth at the rupture [m].
  double lengthAbove = 0.0;  ///< Length of the array above the partition now [m].
};

/// Output of one tick, without the shape of the array.
struct TickOutput {
  device::Wrench wrench_D;  ///< Wrench to render: scaled and limited.
  Workflow workflow = Workflow::idle;
  std::uint32_t status = allWell;
  std::uint32_t contacts = 0;
  std::uint32_t iterations = 0;
  double time = 0.0;                 ///< Since the first motion of the insertion [s], pauses
                                     ///< included, rests (Status::resting) excluded.
  double travel = 0.0;               ///< Depth minus depth at the start [m].
  double depth = 0.0;                ///< [m]
  double speed = 0.0;                ///< [m/s]
  double angularDepth = 0.0;         ///< [rad]
  double axialForce = 0.0;           ///< Physical, along E.z [N].
  std::array<double, 3> force_W{};   ///< Physical, of the array on the hand [N].
  std::array<double, 3> tip_W{};     ///< [m]
  std::array<double, 3> device_W{};  ///< Position of the base commanded by the hand [m].
  std::array<double, 3> proxy_W{};   ///< Actual position of the base [m].
  double wallForceMax = 0.0;         ///< [N]
  double membraneForce = 0.0;        ///< On the basilar membrane, in all [N].
  double partitionForce = 0.0;  ///< Largest force on the cochlear partition within one contact:
                                ///< the force that ruptures it [N].
  /// Work that wires and stylet took by yielding, since the start [J]; not a number where none can.
  double plasticWork = std::numeric_limits<double>::quiet_NaN();
  double styletWithdrawal = 0.0;  ///< [m]
  double residual = 0.0;          ///< [N]
  Translocation translocation;
};

/// Whether a tick raises the peak of an insertion: the largest axial force on the hand while the array
/// is inserted, held or withdrawn, the tick that ends it included; 0 N before. A tick that has not found
/// its balance has no force of the array. Every peak force of the program is found by it.
///
/// @param peakForce  The peak of the ticks before [N].
constexpr bool raisesPeak(const TickOutput& now, double peakForce) noexcept
{
  return now.workflow != Workflow::idle && now.workflow != Workflow::armed &&
         (now.status & notConverged) == 0 && now.axialForce > peakForce;
}

/// The peak of an insertion so far, see raisesPeak().
struct PeakForce {
  double force = 0.0;   ///< [N]
  double travel = 0.0;  ///< [m]

  /// Takes the next tick, in order.
  constexpr void follow(const TickOutput& now) noexcept
  {
    if (raisesPeak(now, force)) *this = {now.axialForce, now.travel};
  }
};

/// Input and output of one tick: one row of a recording.
struct TickRecord {
  std::uint64_t tick = 0;  ///< Counts the recorded ticks.
  device::DeviceSample sample;
  CommandList commands;
  TickOutput output;
};

/// The data for display: the newest tick with the shape of the array.
struct Snapshot {
  std::uint64_t tick = 0;
  TickOutput output;
  PeakForce peak;  ///< Found in every tick, those between two snapshots included.
  std::uint32_t nodes = 0;
  std::uint32_t ruptures = 0;  ///< Ranges in which the cochlear partition is open.
  /// Angles from the round window at which each of them begins and ends [rad].
  std::array<std::array<double, 2>, mechanics::maxRuptures> ruptured{};
  /// The nodes above the partition, in the scala vestibuli.
  std::bitset<mechanics::maxNodes> isAbove;
  std::array<double, 3> baseAxis_W{};  ///< Unit: direction in which the array leaves the tweezers.
  std::array<std::array<float, 3>, mechanics::maxNodes> node_W;  ///< [m], base first, tip last.
  std::array<std::array<float, 3>, mechanics::maxNodes> wallForce_W;  ///< On each node [N].
  std::array<float, mechanics::maxNodes> normalForce;                 ///< On each node [N].
  double couplingStiffness = 0.0;  ///< Spring between hand and array [N/m]; 0 if rigid.
  // Statistics of the loop; zero in virtual time.
  double measuredRate = 0.0;      ///< Ticks per second over the last second.
  std::uint64_t lateTicks = 0;    ///< Ticks that began more than one period late.
  std::uint64_t overruns = 0;     ///< Ticks that took longer than one period.
  double tickTimeP99 = 0.0;       ///< 99th percentile over the last second [s].
  std::uint64_t lostRecords = 0;  ///< Records dropped because the recorder was too slow.
};

static_assert(std::is_trivially_copyable_v<TickRecord>);
static_assert(std::is_trivially_copyable_v<Snapshot>);

}  // namespace perilymph::haptics
