// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The matrix of the random motion: every row is named for what makes it hard.

#include <vector>

#include "Trial.h"

namespace perilymph::test {

const std::vector<Setting>& settings();

}  // namespace perilymph::test
