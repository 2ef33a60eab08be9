// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/WorkflowEvent.h"

#include <gtest/gtest.h>

#include <array>

namespace perilymph::haptics {
namespace {

using enum Workflow;

constexpr std::array<WorkflowEvent, 6> allEvents{WorkflowEvent::arm,      WorkflowEvent::grasp,
                                                 WorkflowEvent::release,  WorkflowEvent::arrive,
                                                 WorkflowEvent::withdraw, WorkflowEvent::error};

struct Row {
  Workflow from;
  // arm, grasp, release, arrive, withdraw, error
  std::array<Workflow, 6> to;
};

// The state diagram as a table.
constexpr std::array<Row, 6> table{{
    {idle, {armed, idle, idle, idle, idle, fault}},
    {armed, {armed, inserting, armed, armed, armed, fault}},
    {inserting, {inserting, inserting, paused, finished, inserting, fault}},
    {paused, {paused, inserting, paused, paused, paused, fault}},
    {finished, {finished, finished, finished, finished, inserting, fault}},
    {fault, {fault, fault, fault, fault, fault, fault}},
}};

TEST(Workflow, FollowsItsStateDiagram)
{
  for (const Row& row : table)
    for (std::size_t i = 0; i < allEvents.size(); ++i)
      EXPECT_EQ(next(row.from, allEvents[i]), row.to[i])
          << "state " << static_cast<int>(row.from) << ", event " << i;
}

TEST(Workflow, KeepsItsStateWithoutAnEvent)
{
  for (const Row& row : table)
    EXPECT_EQ(next(row.from, static_cast<WorkflowEvent>(allEvents.size())), row.from);
}

}  // namespace
}  // namespace perilymph::haptics
