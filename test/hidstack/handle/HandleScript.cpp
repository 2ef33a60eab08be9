// SPDX-License-Identifier: BSD-3-Clause
#include "HandleScript.h"

#include "StopWays.h"

namespace perilymph::hidstack {

namespace {

/// Grasps, slides to the wall and comes to rest there.
void addContact(std::vector<Passage>& passages, const std::string& restName)
{
  passages.push_back({.name = "greeting"});
  // Until the host has set up the device.
  passages.push_back({.name = "loose", .duration = 0.15});
  // Long enough for the force to fade in before contact.
  passages.push_back({.name = "grasp", .duration = 0.6, .isButtonPressed = true});
  Passage sliding{.name = "slide", .duration = 1.0, .isButtonPressed = true};
  sliding.grip = Grip::free;
  sliding.push = pushAtRest;
  passages.push_back(sliding);
  sliding.name = restName;
  sliding.duration = 0.2;
  passages.push_back(sliding);
}

/// A whole session: at rest, disconnected, at rest again, silent, back, paused, and back.
std::vector<Passage> session()
{
  std::vector<Passage> passages;
  addContact(passages, "rest");
  passages.push_back({.name = "unplugged", .duration = 0.2, .wire = Wire::unplugged});
  addContact(passages, "rest_again");
  Passage last = passages.back();
  last.name = "silence";
  last.duration = 1e-3 * silentReports;
  last.wire = Wire::silent;
  passages.push_back(last);
  last.name = "again";
  last.duration = 0.2;
  last.wire = Wire::reporting;
  passages.push_back(last);
  last.name = "pause";
  last.duration = 0.05;
  last.wire = Wire::paused;
  passages.push_back(last);
  last.name = "after_pause";
  last.duration = 0.2;
  last.wire = Wire::reporting;
  passages.push_back(last);
  return passages;
}

/// Connected again and again, for a loop that starts at other phases of the device's period.
std::vector<Passage> phases()
{
  std::vector<Passage> passages;
  for (int i = 0; i < startPhases; ++i) {
    passages.push_back({.name = "greeting"});
    passages.push_back({.name = "loose", .duration = 0.15});
    passages.push_back({.name = "grasp", .duration = 0.2, .isButtonPressed = true});
    passages.push_back({.name = "unplugged", .duration = 0.2, .wire = Wire::unplugged});
  }
  return passages;
}

/// A strong push for every way to stop, each with the handle plugged in again. After the stop the
/// handle slides to its end stop.
std::vector<Passage> stops()
{
  std::vector<Passage> passages;
  for (const std::string way : stopWays) {
    passages.push_back({.name = "greeting"});
    passages.push_back({.name = "loose", .duration = 0.15});
    passages.push_back({.name = "grasp", .duration = 0.6, .isButtonPressed = true});
    Passage push{.name = way, .duration = 1.5, .isButtonPressed = true};
    if (way == "focus_away") push.duration += focusTime;
    push.grip = Grip::free;
    push.push = strongPush;
    passages.push_back(push);
    passages.push_back({.name = "unplugged", .duration = 0.2, .wire = Wire::unplugged});
  }
  return passages;
}

}  // namespace

Result<HandleScript> scriptNamed(const std::string& name)
{
  if (name == "stream") return HandleScript{{{.name = name, .duration = 5.3}}, Flaw::none};
  if (name == "lost") return HandleScript{{{.name = name, .duration = 0.8}}, Flaw::lostReport};
  if (name == "repeated")
    return HandleScript{{{.name = name, .duration = 0.8}}, Flaw::repeatedReport};
  if (name == "session") return HandleScript{session(), Flaw::none};
  if (name == "phases") return HandleScript{phases(), Flaw::none};
  if (name == "stops") return HandleScript{stops(), Flaw::none};
  if (name == "answer")
    return HandleScript{{{.name = name, .duration = 0.8, .wire = Wire::answering}}, Flaw::none};

  HandleScript contact;
  if (name == "killed") {
    addContact(contact.passages, "rest");
    contact.passages[3].duration = 0.3;  // pushing suffices, it need not come to rest
    contact.passages[4].duration = 0.6;
    return contact;
  }
  addContact(contact.passages, "rest");
  if (name == "flipped") {
    contact.flaw = Flaw::flippedForce;
    contact.passages[3].duration = 0.4;  // to the end stop
  } else if (name == "doubled")
    contact.flaw = Flaw::doubledForce;
  else
    return Error{
        "There is no script '" + name +
        "'; take stream, lost, repeated, session, phases, killed, answer, stops, flipped or "
        "doubled."};
  return contact;
}

}  // namespace perilymph::hidstack
