// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The question before an action that ends an insertion in progress.

#include <QString>
#include <functional>

namespace perilymph::gui {

class InsertPage;
class Notice;

/// Asks in the window's notice, without a dialog: nothing covers or blocks an insertion.
class EndingQuestion {
public:
  EndingQuestion(InsertPage& insertion, Notice& notice) : insertion_(insertion), notice_(notice) {}

  /// An insertion is in progress, also if it is paused.
  bool isNeeded() const;
  /// Does something at once, or after the insertion was ended by the user's answer.
  /// @param action  Text of the button: "End it and close".
  void askBefore(const QString& action, const std::function<void()>& act);

private:
  InsertPage& insertion_;
  Notice& notice_;
};

}  // namespace perilymph::gui
