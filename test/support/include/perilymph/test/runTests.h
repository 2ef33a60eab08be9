// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace perilymph::test {

/// Runs the cases that were chosen on the command line (InitGoogleTest has read it). Returns the
/// program's exit status: 0 if all passed or some were skipped, 77 if all were skipped, which ctest
/// shows as a skipped test, and 1 if a case failed or none was chosen.
int runTests();

}  // namespace perilymph::test
