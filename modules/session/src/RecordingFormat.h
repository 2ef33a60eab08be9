#pragma once

// What writer and reader of a recording agree on.

#include <cstdint>

namespace perilymph::session {

/// SQLite's application_id of our files: "Plym".
inline constexpr std::int64_t recordingApplicationId = 0x506c796d;

/// Keys of the table `meta`.
struct MetaKey {
  static constexpr const char* scenarioName = "scenario_name";
  static constexpr const char* scenario = "scenario";
  static constexpr const char* device = "device";
  static constexpr const char* timeStep = "dt_s";
  static constexpr const char* samplePeriod = "sample_period_s";
  static constexpr const char* mostForce = "most_force_N";
  static constexpr const char* offTime = "off_time_s";
  static constexpr const char* reach = "reach_m";
  static constexpr const char* feelsForce = "feels_force";
  static constexpr const char* mostStiffness = "most_stiffness_N_m";
  static constexpr const char* mostDamping = "most_damping_N_s_m";
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
};

}  // namespace perilymph::session
