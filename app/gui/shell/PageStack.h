// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The pages of the window, one of which is visible.

#include <QStackedWidget>
#include <vector>

#include "gui/pages/Page.h"
#include "gui/shell/PageList.h"

namespace perilymph::gui {

class PageStack : public QStackedWidget {
  Q_OBJECT
public:
  /// Makes the pages of a list; that of the insertion is shown first.
  PageStack(const PageList& list, InsertionController& insertion, QWidget* parent);

  /// In the order of the list.
  const std::vector<Page*>& all() const { return all_; }
  Page& current() const;
  /// Throws std::out_of_range without a page of this id.
  Page& page(const QString& id) const;
  /// The page of a class; null if there is none.
  template <class Wanted>
  Wanted* find() const
  {
    return findChild<Wanted*>(QString(), Qt::FindDirectChildrenOnly);
  }

  /// The page that opens a file or folder that is dropped or named: the one that is shown if it accepts it,
  /// else one that always does; null if none does.
  Page* pageFor(const std::filesystem::path& file) const;

  /// Shows a page and notifies it and the one before it.
  void show(Page& page);

private:
  std::vector<Page*> all_;
};

}  // namespace perilymph::gui
