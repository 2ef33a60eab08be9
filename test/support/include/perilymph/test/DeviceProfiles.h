// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Texts of device profiles, so that a test writes only the relevant part.

#include <string>

namespace perilymph::test {

/// The common part of every profile, up to the table [capability], which the test continues.
inline std::string profileHead(const std::string& kind, const std::string& match = "vendor_id = 1")
{
  return "name = \"Test\"\nmaker = \"nobody\"\nkind = \"" + kind +
         "\"\nsource = \"test\"\nconfidence = \"high\"\n[[match]]\n" + match + "\n[capability]\n";
}

/// A joystick that reports one axis and renders no force.
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
