// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/PageStack.h"

#include <algorithm>
#include <stdexcept>

namespace perilymph::gui {

PageStack::PageStack(const PageList& list, InsertionController& insertion, QWidget* parent)
    : QStackedWidget(parent)
{
  for (const PageMaker& make : list) {
    all_.push_back(make(insertion, this));
    addWidget(all_.back());
  }
  const auto first = std::ranges::find_if(all_, &Page::showsInsertion);
  if (first != all_.end()) setCurrentWidget(*first);
}

Page& PageStack::current() const { return *static_cast<Page*>(currentWidget()); }

Page& PageStack::page(const QString& id) const
{
  const auto found = std::ranges::find(all_, id, &Page::id);
  if (found == all_.end()) throw std::out_of_range("No page " + id.toStdString());
  return **found;
}

Page* PageStack::pageFor(const std::filesystem::path& file) const
{
  if (file.empty()) return nullptr;
  if (current().accepts(file) != Page::Acceptance::none) return &current();
  const auto found = std::ranges::find_if(
      all_, [&](const Page* page) { return page->accepts(file) == Page::Acceptance::always; });
  return found == all_.end() ? nullptr : *found;
}

void PageStack::show(Page& page)
{
  current().onHidden();
  setCurrentWidget(&page);
  page.onShown();
}

}  // namespace perilymph::gui
