// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace perilymph::gui {

/// Keeps up to 64 MB of freed memory for the next frame. The system would otherwise take back what a frame drawn
/// by software frees, and map and clear it again for the next one.
/// Blocks above 32 MB, such as a CT, are returned at once.
void keepFreedMemory();

}  // namespace perilymph::gui
