#include "HandleScript.h"

namespace perilymph::hidstack {

namespace {

const Passage greeting{.name = "greeting"};
/// Long enough for the force to be faded in before anything touches.
const Passage grasp{.name = "grasp", .duration = 0.8, .isButtonPressed = true};

Passage pushing(const std::string& name, double duration)
{
  return {name, duration, Grip::free, true, pushAtRest, Wire::reporting};
}

/// Takes hold, slides to the wall and comes to rest there.
void addContact(std::vector<Passage>& passages, const std::string& restName)
{
  passages.push_back(greeting);
  passages.push_back({.name = "loose", .duration = 0.2});
  passages.push_back(grasp);
  passages.push_back(pushing("slide", 1.5));
  passages.push_back(pushing(restName, 0.3));
}

}  // namespace

Result<HandleScript> scriptNamed(const std::string& name)
{
  HandleScript script;
  if (name == "stream" || name == "lost" || name == "repeated") {
    script.passages = {{.name = "stream", .duration = name == "stream" ? 5.5 : 1.2}};
    if (name == "lost") script.flaw = Flaw::lostReport;
    if (name == "repeated") script.flaw = Flaw::repeatedReport;
    return script;
  }

  addContact(script.passages, "rest");
  if (name == "contact") return script;
  if (name == "flipped" || name == "doubled") {
    script.flaw = name == "flipped" ? Flaw::flippedForce : Flaw::doubledForce;
    return script;
  }
  if (name == "stall") {
    Passage silence = pushing("silence", 0.1);
    silence.wire = Wire::silent;
    script.passages.push_back(silence);
    script.passages.push_back(pushing("again", 0.3));
    return script;
  }
  if (name == "unplug") {
    script.passages.push_back({.name = "unplugged", .duration = 0.3, .wire = Wire::unplugged});
    addContact(script.passages, "rest_again");
    return script;
  }
  return Error{"There is no script '" + name +
               "'; take stream, contact, stall, unplug, flipped, doubled, lost or repeated."};
}

}  // namespace perilymph::hidstack
