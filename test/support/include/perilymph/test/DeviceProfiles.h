#pragma once

// Texts of device profiles, so that a test writes only what it is about.

#include <string>

namespace perilymph::test {

/// What every profile says of itself, up to the table [capability], which the test goes on with.
inline std::string profileHead(const std::string& kind, const std::string& match = "vendor_id = 1")
{
  return "name = \"Test\"\nmaker = \"nobody\"\nkind = \"" + kind +
         "\"\nsource = \"test\"\nconfidence = \"high\"\n[[match]]\n" + match + "\n[capability]\n";
}

/// A stick that tells how far it is pushed to one side, and shows no force.
inline std::string stickProfile()
{
  return profileHead("joystick", "usage_page = 1\nusage = 4") + R"(nominal_period_ms = 10.0
[axes]
motion = "place"
x = "x"
travel_mm = 15.0
)";
}

}  // namespace perilymph::test
