// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What draws: a graphics card or the processor.

#include <string>

namespace perilymph::gui {

/// Whether an OpenGL renderer draws on the processor.
///
/// @param renderer  Its name: "llvmpipe (LLVM 15.0.6, 256 bits)". An unknown one is not a graphics
///                  card.
bool isSoftwareRenderer(const std::string& renderer);

/// The name of the OpenGL renderer of this display; empty without OpenGL. It is asked for once: call
/// after QApplication.
const std::string& openGlRenderer();

}  // namespace perilymph::gui
