#pragma once

// The structs that leave the haptic thread: fixed size, no pointers, no Eigen.

#include <array>
#include <cstdint>
#include <type_traits>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/mechanics/InsertionModel.h"

namespace perilymph::haptics {

/// Where an insertion is in its work. Owned by the haptic thread.
enum class Workflow : std::uint32_t { idle, armed, inserting, paused, finished, fault };

/// What went wrong or was held back in a tick: bits of TickOutput::status.
enum Status : std::uint32_t {
  allWell = 0,
  staleSample = 1u << 0,        ///< The device gave nothing fresh for too long: no force.
  forceClamped = 1u << 1,       ///< The force shown was cut to the limit.
  forceSlewed = 1u << 2,        ///< The force shown was held back to the slew limit.
  rampingIn = 1u << 3,          ///< The force shown is still being faded in.
  notFinite = 1u << 4,          ///< The mechanics overflowed: fault.
  passivityActed = 1u << 5,     ///< Energy came back from the device; it was damped.
  notConverged = 1u << 6,       ///< Newton's method left more than its tolerance.
  deviceLost = 1u << 7,         ///< The device said it is gone: fault.
  sampleRejected = 1u << 8,     ///< A sample no hand can have made; it was not used.
  handJumped = 1u << 9,         ///< The hand was not where it could have moved to: new anchor.
  couplingSoftened = 1u << 10,  ///< The device cannot render the coupling asked for: a softer one.
  nearWorkspaceEnd = 1u << 11,  ///< The force shown fades toward the end of the device's reach.
};

/// A request from the window or the command line to the loop.
struct Command {
  enum class Kind : std::uint32_t {
    none,
    arm,            ///< Idle -> Armed.
    reset,          ///< Anything -> Idle, the array back at its start.
    withdraw,       ///< Finished -> Inserting; the stop depth no longer holds.
    pullStylet,     ///< value: target withdrawal of the stylet [m].
    setForceScale,  ///< value: shown force over physical force.
    clearFault,     ///< Fault -> Idle.
    requestFault,   ///< Anything -> Fault: the emergency stop.
  };
  Kind kind = Kind::none;
  std::uint32_t reserved = 0;
  double value = 0.0;
};

inline constexpr int maxCommandsPerTick = 8;

/// The commands one tick takes.
struct CommandList {
  std::uint32_t count = 0;
  std::uint32_t reserved = 0;
  std::array<Command, maxCommandsPerTick> items{};
};

/// What one tick computed, but for the pictures.
struct TickOutput {
  device::Wrench wrench_D;  ///< To be shown to the hand: scaled and made safe.
  Workflow workflow = Workflow::idle;
  std::uint32_t status = allWell;
  std::uint32_t contacts = 0;
  std::uint32_t iterations = 0;
  double time = 0.0;                 ///< Since the insertion began to move [s], pauses included.
  double travel = 0.0;               ///< Depth minus depth at the start [m].
  double depth = 0.0;                ///< [m]
  double speed = 0.0;                ///< [m/s]
  double angularDepth = 0.0;         ///< [rad]
  double axialForce = 0.0;           ///< Physical, along E.z [N].
  std::array<double, 3> force_W{};   ///< Physical, of the array on the hand [N].
  std::array<double, 3> tip_W{};     ///< [m]
  std::array<double, 3> device_W{};  ///< Where the hand wants the base [m].
  std::array<double, 3> proxy_W{};   ///< Where the base is [m].
  double wallForceMax = 0.0;         ///< [N]
  double membraneForce = 0.0;        ///< [N]
  double styletWithdrawal = 0.0;     ///< [m]
  double residual = 0.0;             ///< [N]
};

/// Everything that entered a tick, and what came out: one row of a recording.
struct TickRecord {
  std::uint64_t tick = 0;
  device::DeviceSample sample;
  CommandList commands;
  TickOutput output;
};

/// What the eyes get: the newest tick with the shape of the array.
struct Snapshot {
  std::uint64_t tick = 0;
  TickOutput output;
  std::uint32_t nodes = 0;
  std::uint32_t reserved = 0;
  std::array<double, 3> baseAxis_W{};  ///< Unit: which way the array leaves the tweezers.
  std::array<std::array<float, 3>, mechanics::maxNodes> node_W;  ///< [m], base first, tip last.
  std::array<std::array<float, 3>, mechanics::maxNodes> wallForce_W;  ///< On each node [N].
  std::array<float, mechanics::maxNodes> normalForce;                 ///< On each node [N].
  double couplingStiffness = 0.0;  ///< Spring between hand and array [N/m]; 0 if rigid.
  // What the loop knows of itself; zero in virtual time.
  double measuredRate = 0.0;      ///< Ticks a second over the last second.
  std::uint64_t lateTicks = 0;    ///< Ticks that began more than one period late.
  std::uint64_t overruns = 0;     ///< Ticks that took longer than one period.
  double tickTimeP99 = 0.0;       ///< 99th percentile over the last second [s].
  std::uint64_t lostRecords = 0;  ///< Records the recorder was too slow for.
};

static_assert(std::is_trivially_copyable_v<TickRecord>);
static_assert(std::is_trivially_copyable_v<Snapshot>);

}  // namespace perilymph::haptics
