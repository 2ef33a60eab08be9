// SPDX-License-Identifier: BSD-3-Clause
#include "recording/RecordingEvents.h"

#include <array>
#include <utility>

#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/InsertionEnd.h"
#include "perilymph/session/Recording.h"

namespace perilymph::session {

namespace {

std::string commandWord(haptics::Command::Kind kind)
{
  using Kind = haptics::Command::Kind;
  switch (kind) {
    case Kind::none:
      return "none";
    case Kind::arm:
      return "arm";
    case Kind::withdraw:
      return "withdraw";
    case Kind::pullStylet:
      return "pullStylet";
    case Kind::stop:
      return "stop";
    case Kind::resume:
      return "resume";
  }
  return "command " + std::to_string(static_cast<std::uint32_t>(kind));
}

}  // namespace

std::string workflowWord(haptics::Workflow workflow)
{
  constexpr std::array<const char*, 6> label = {"idle",   "armed",    "inserting",
                                                "paused", "finished", "fault"};
  const auto number = static_cast<std::uint32_t>(workflow);
  return number < label.size() ? label[number] : "workflow " + std::to_string(number);
}

std::string statusText(std::uint32_t status)
{
  constexpr std::array<std::pair<haptics::Status, const char*>, 21> label = {
      {{haptics::staleSample, "staleSample"},
       {haptics::couplingSoftened, "couplingSoftened"},
       {haptics::nearWorkspaceEnd, "nearWorkspaceEnd"},
       {haptics::forceClamped, "forceClamped"},
       {haptics::forceSlewed, "forceSlewed"},
       {haptics::rampingIn, "rampingIn"},
       {haptics::notFinite, "notFinite"},
       {haptics::passivityActed, "passivityActed"},
       {haptics::notConverged, "notSettled"},
       {haptics::deviceLost, "deviceLost"},
       {haptics::sampleRejected, "sampleDoubted"},
       {haptics::handJumped, "handJumped"},
       {haptics::stopped, "stopped"},
       {haptics::resting, "resting"},
       {haptics::endedByResistance, "endedByResistance"},
       {haptics::endedBuckled, "endedBuckled"},
       {haptics::endedOutOfOpening, "endedOutOfOpening"},
       {haptics::endedFoldedTip, "endedFoldedTip"},
       {haptics::endedJammed, "endedJammed"},
       {haptics::partitionRuptured, "partitionRuptured"},
       {haptics::translocated, "translocated"}}};
  std::string text;
  for (const auto& [bit, word] : label)
    if (status & bit) text += (text.empty() ? "" : " ") + std::string(word);
  return text;
}

std::vector<Event> EventDetector::add(const haptics::TickRecord& record)
{
  std::vector<Event> events;
  const auto add = [&](std::string kind, auto value) {
    events.push_back({record.tick, record.output.time, std::move(kind), std::move(value)});
  };
  const std::uint64_t expected = lastTick_ ? *lastTick_ + 1 : record.tick;
  if (record.tick > expected) {
    const std::uint64_t missing = record.tick - expected;
    add("lost", static_cast<std::int64_t>(missing));
    missingTicks_ += missing;
  }
  lastTick_ = record.tick;
  for (std::uint32_t i = 0; i < record.commands.count && i < haptics::maxCommandsPerTick; ++i) {
    const haptics::Command& command = record.commands.items[i];
    add(commandWord(command.kind), command.value);
  }
  if (record.output.workflow != workflow_) {
    workflow_ = record.output.workflow;
    add("workflow", workflowWord(workflow_));
  }
  // Only a new status bit is an event; its end is visible in the ticks.
  const std::uint32_t appeared = record.output.status & ~status_;
  status_ = record.output.status;
  constexpr std::uint32_t ofPartition = haptics::partitionRuptured | haptics::translocated;
  const std::uint32_t status = appeared & ~haptics::anyEnd & ~ofPartition;
  if (status != 0) add("status", statusText(status));
  if ((appeared & haptics::partitionRuptured) != 0) {
    add("partition_ruptured_deg", inDegrees(radians(record.output.translocation.angle)));
    add("partition_force_N", record.output.translocation.force);
  }
  // the first part that goes through; where it comes and goes is visible in the ticks
  if ((appeared & haptics::translocated) != 0 && !isTranslocated_) {
    isTranslocated_ = true;
    add("translocated_at_mm", inMillimeters(meters(record.output.depth)));
  }
  // a finished insertion is a change of workflow
  if ((appeared & haptics::anyEnd) != 0)
    add("end", std::string(nameOf(haptics::endOf(record.output))));
  return events;
}

}  // namespace perilymph::session
