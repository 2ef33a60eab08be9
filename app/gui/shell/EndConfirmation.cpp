// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/EndConfirmation.h"

#include <algorithm>

#include "gui/shell/PageStack.h"
#include "gui/widgets/Notice.h"

namespace perilymph::gui {

Page* EndConfirmation::unfinishedPage() const
{
  const auto found = std::ranges::find_if(
      pages_.all(), [](const Page* page) { return page->unfinished().has_value(); });
  return found == pages_.all().end() ? nullptr : *found;
}

void EndConfirmation::askBefore(const QString& action, const std::function<void()>& act, Page* only)
{
  Page* page = only != nullptr ? only : unfinishedPage();
  const auto unfinished = page == nullptr ? std::nullopt : page->unfinished();
  if (!unfinished) return act();
  asked_ = unfinished->sentence;
  page_ = page;
  notice_.ask(asked_, action, unfinished->keepText, [this, page, action, act, only] {
    page->endUnfinished();
    askBefore(action, act, only);  // another page may have unfinished work, too
  });
}

void EndConfirmation::clearIfDone()
{
  if (page_ == nullptr || page_->unfinished()) return;
  notice_.dropQuestion(asked_);
  page_ = nullptr;
}

}  // namespace perilymph::gui
