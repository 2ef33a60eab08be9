// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace perilymph::realtime {

/// Processor time that the calling thread has used [ns]; other threads do not add to it.
std::int64_t threadNanoseconds() noexcept;

}  // namespace perilymph::realtime
