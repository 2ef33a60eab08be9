// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/EndingQuestion.h"

#include <algorithm>

#include "gui/shell/PageStack.h"
#include "gui/widgets/Notice.h"

namespace perilymph::gui {

Page* EndingQuestion::unfinishedPage() const
{
  const auto found = std::ranges::find_if(
      pages_.all(), [](const Page* page) { return page->unfinished().has_value(); });
  return found == pages_.all().end() ? nullptr : *found;
}

void EndingQuestion::askBefore(const QString& action, const std::function<void()>& act)
{
  Page* page = unfinishedPage();
  const auto unfinished = page == nullptr ? std::nullopt : page->unfinished();
  if (!unfinished) return act();
  notice_.ask(unfinished->sentence, action, unfinished->keepText, [this, page, action, act] {
    page->endUnfinished();
    askBefore(action, act);  // another page may have unfinished work, too
  });
}

}  // namespace perilymph::gui
