// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace perilymph::test {

/// The page resources/guide/reference.md, from what the program itself says.
std::string referencePage();

}  // namespace perilymph::test
