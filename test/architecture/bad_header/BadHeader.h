// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Does not include what it uses.

inline int count(const std::vector<int>& numbers) { return static_cast<int>(numbers.size()); }
