// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The file format shared by writer and reader of a recording.

#include <cstdint>

#include "perilymph/database/FileKind.h"
#include "perilymph/foundation/Seal.h"

namespace perilymph::session {

/// The schema of a recording.
///
///   version 1   meta, tick, event
///   version 2   adds `content_sha256` to meta, renewed with every transaction
///   version 3   block in place of tick
const database::FileKind& recordingKind();

/// First format with a hash of the content.
inline constexpr std::int64_t firstVersionWithHash = 2;

/// First format whose ticks are packed in blocks.
inline constexpr std::int64_t firstVersionWithBlocks = 3;

/// All rows of the table `meta`, by their keys.
using MetaRows = SealedFacts;

/// Keys of the table `meta`.
struct MetaKey {
  static constexpr const char* scenarioName = "scenario_name";
  static constexpr const char* scenario = "scenario";
  static constexpr const char* device = "device";
  static constexpr const char* timeStep = "dt_s";
  static constexpr const char* samplePeriod = "sample_period_s";
  static constexpr const char* maxForce = "max_force_N";
  static constexpr const char* offTime = "off_time_s";
  static constexpr const char* reach = "reach_m";
  static constexpr const char* feelsForce = "feels_force";
  static constexpr const char* maxStiffness = "max_stiffness_N_m";
  static constexpr const char* maxDamping = "max_damping_N_s_m";
  static constexpr const char* restAfter = "rest_after_s";
  static constexpr const char* restMotion = "rest_motion_m";
  static constexpr const char* restHandMotion = "rest_hand_motion_m";
  static constexpr const char* deviceDelay = "device_delay_s";
  static constexpr const char* deviceReport = "device_report";
  static constexpr const char* seed = "seed";
  static constexpr const char* modelFingerprint = "model_fingerprint";
  static constexpr const char* version = "version";
  static constexpr const char* buildId = "build_id";
  static constexpr const char* startedUtc = "started_utc";
  static constexpr const char* lostRecords = "lost_records";
  static constexpr const char* ticks = "ticks";
  static constexpr const char* closed = "closed";
  static constexpr const char* contentHash = sealKey;
};

}  // namespace perilymph::session
