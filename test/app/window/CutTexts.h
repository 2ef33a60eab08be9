// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Texts that a window shows in part only.

#include <QWidget>
#include <string>
#include <vector>

namespace perilymph::test {

/// The visible texts of a window that are cut, one line each with the widget's name and its size:
/// labels, buttons, lists of choices and read-outs that are narrower or lower than their text, or
/// lie partly outside of a widget around them. Not those that end in an ellipsis and have a tooltip,
/// and not those that can be scrolled to.
std::vector<std::string> cutTextsOf(const QWidget& window);

}  // namespace perilymph::test
