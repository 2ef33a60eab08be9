// SPDX-License-Identifier: BSD-3-Clause
#include "gui/program/FreedMemory.h"

#include <malloc.h>

namespace perilymph::gui {

void keepFreedMemory()
{
  constexpr int kept_bytes = 64 << 20;
  constexpr int block_bytes = 32 << 20;  // glibc's own upper bound of its threshold
  mallopt(M_TRIM_THRESHOLD, kept_bytes);
  mallopt(M_MMAP_THRESHOLD, block_bytes);
}

}  // namespace perilymph::gui
