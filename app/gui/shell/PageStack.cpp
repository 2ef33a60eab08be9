// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/PageStack.h"

namespace perilymph::gui {

PageStack::PageStack(const std::array<QWidget*, 5>& pages, Page shown, QWidget* parent)
    : QStackedWidget(parent)
{
  for (QWidget* page : pages) addWidget(page);
  showPage(shown);
}

}  // namespace perilymph::gui
