#pragma once

// A device of bare numbers that wants to be told when it is left.

namespace perilymph::test {

inline constexpr const char* guardedProfile = R"(
name = "Guarded"
maker = "none"
kind = "vector"
source = "a test"
confidence = "high"
[[match]]
vendor_id = 1
[capability]
most_force_N = 3.0
nominal_period_ms = 1.0
reporting = "periodic"
[mount]
[input]
report = 1
bytes = 8
bits = 16
first_bits = [16, 32, 48]
quantum_mm = [0.01, 0.01, 0.01]
counter_bit = 0
counter_bits = 16
[output]
report = 2
bytes = 6
bits = 16
first_bits = [0, 16, 32]
quantum_N = [0.001, 0.001, 0.001]
[[on_close]]
kind = "output"
bytes = [9, 77]
)";

}  // namespace perilymph::test
