// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Keys that type a character act on the window only where nothing is typed.

class QKeyEvent;
class QWidget;

namespace perilymph::gui {

/// A key that types a character: a letter, a digit, a symbol or Space, without Ctrl or Alt.
bool isTyped(const QKeyEvent& event);

/// Whether a widget takes typed characters: an input field or a list.
bool takesText(const QWidget* widget);

/// Whether the settings switch this key off, as a letter, digit or symbol. Space always acts.
bool areLettersOff(const QKeyEvent& event);

}  // namespace perilymph::gui
