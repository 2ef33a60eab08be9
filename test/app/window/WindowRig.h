// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// An open window and functions that press its buttons and keys.

#include <QAbstractButton>
#include <QImage>
#include <functional>
#include <memory>
#include <string>

#include "gui/scene/OperationView.h"
#include "gui/shell/MainWindow.h"
#include "gui/widgets/ReadOut.h"

namespace perilymph::test {

class WindowRig {
public:
  /// Opens the published scenario with some of its keys replaced.
  explicit WindowRig(const session::Overrides& overrides = {},
                     std::optional<std::filesystem::path> record = std::nullopt,
                     std::shared_ptr<gui::CochleaStore> cochleae = sharedCochleae(),
                     const gui::PageList& pages = gui::standardPages());
  /// The cochleae of all windows of the program: building them is most of what a window takes.
  static const std::shared_ptr<gui::CochleaStore>& sharedCochleae();

  gui::MainWindow& window() { return *window_; }
  const haptics::Snapshot& now() const { return window_->control().now(); }
  double travel_mm() const { return inMillimeters(Length::fromSi(now().output.travel)); }

  /// Clicks a button, a radio button or a check box by its object name.
  void click(const char* name);
  /// Opens a list by its object name, marks a value and chooses it with the keyboard.
  void choose(const char* selector, const char* value);
  /// Replaces the text of a field and presses Return.
  void type(const char* field, const char* text);
  QAbstractButton& button(const char* name);
  QString label(const char* name);
  QString readOut(const char* name);

  void pressKey(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
  void holdKey(Qt::Key key);
  void releaseKey(Qt::Key key);
  /// Turns the wheel over the picture; positive away from the user.
  void turnWheel(int notches);

  /// Time limit for a busy machine, longer under the address sanitizer; no result depends on it.
#ifdef __SANITIZE_ADDRESS__
  static constexpr int patience_ms = 300'000;
#else
  static constexpr int patience_ms = 60'000;
#endif
  /// Processes events until the condition holds; false after the time limit.
  static bool waitUntil(const std::function<bool()>& claim, int longest_ms = patience_ms);
  /// Runs the loop for some ticks.
  bool runForTicks(std::uint64_t ticks);

  /// The image of the scene without its texts.
  QImage picture();

private:
  std::unique_ptr<gui::MainWindow> window_;
};

}  // namespace perilymph::test
