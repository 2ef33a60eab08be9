// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A window that is open on the screen, with hands to press its buttons and keys.

#include <QAbstractButton>
#include <QImage>
#include <functional>
#include <memory>
#include <string>

#include "gui/parts/ReadOut.h"
#include "gui/scene/OperationView.h"
#include "gui/shell/MainWindow.h"

namespace perilymph::test {

class WindowRig {
public:
  /// Opens the published scenario with some of its keys replaced.
  explicit WindowRig(const session::Overrides& overrides = {},
                     std::optional<std::filesystem::path> record = std::nullopt);

  gui::MainWindow& window() { return *window_; }
  const haptics::Snapshot& now() const { return window_->control().now(); }
  double travel_mm() const { return inMillimeters(Length::fromSi(now().output.travel)); }

  /// Clicks a button, a choice or a check box by its object's name.
  void click(const char* name);
  /// Opens a list by its object's name and chooses a value in it, with the keyboard.
  void choose(const char* selector, const char* value);
  /// Types a text into a field in place of its own; Return sends it off.
  void type(const char* field, const char* text);
  QAbstractButton& button(const char* name);
  QString label(const char* name);
  QString readOut(const char* name);

  void pressKey(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
  void holdKey(Qt::Key key);
  void releaseKey(Qt::Key key);
  /// Turns the wheel over the picture; positive away from oneself.
  void turnWheel(int notches);

  static constexpr int patience_ms =
      60'000;  ///< Patience with a busy machine; nothing is timed by it.
  /// Lets the window live until something is true. False when it takes longer than anybody waits.
  static bool comes(const std::function<bool()>& claim, int longest_ms = patience_ms);
  /// Lets the loop run on for some of its ticks.
  bool liveForTicks(std::uint64_t ticks);

  /// What the picture in the middle shows, without the words on it.
  QImage picture();

private:
  std::unique_ptr<gui::MainWindow> window_;
};

}  // namespace perilymph::test
