// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The question before an action that ends unfinished work of a page, such as an insertion.

#include <QString>
#include <functional>

namespace perilymph::gui {

class Notice;
class Page;
class PageStack;

/// Asks in the window's notice, without a dialog: nothing covers or blocks an insertion.
class EndConfirmation {
public:
  EndConfirmation(const PageStack& pages, Notice& notice) : pages_(pages), notice_(notice) {}

  /// A page has unfinished work, such as an insertion, also if it is paused.
  bool isNeeded() const { return unfinishedPage() != nullptr; }
  /// Does something at once, or after the work was ended by the user's answer.
  /// @param action  Text of the button: "End it and close".
  /// @param page    Whose work it ends; null: that of all pages.
  void askBefore(const QString& action, const std::function<void()>& act, Page* page = nullptr);
  /// Takes the question back once its work is finished.
  void clearIfDone();

private:
  Page* unfinishedPage() const;

  const PageStack& pages_;
  Notice& notice_;
  QString asked_;               ///< The last question.
  const Page* page_ = nullptr;  ///< Whose work it is about; null once it has been taken back.
};

}  // namespace perilymph::gui
