// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Monochrome icons of pages and commands, painted as vectors.

#include <QIcon>

namespace perilymph::gui {

enum class Icon {
  home,
  ct,
  plan,
  insert,
  outcome,
  compare,
  validate,
  sessions,
  studies,
  outcomes,
  settings
};

/// The icon in the window's color scheme: in the color of quiet text, and of text where its button is
/// checked.
QIcon iconOf(Icon icon, int size_px, double pixelRatio);

}  // namespace perilymph::gui
