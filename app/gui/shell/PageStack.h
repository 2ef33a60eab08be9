// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The pages of the window, one of which is visible.

#include <QStackedWidget>
#include <array>

namespace perilymph::gui {

/// The pages, in the order of their buttons.
enum class Page { start, insert, compare, validate, sessions };

/// Contains a widget for each page.
class PageStack : public QStackedWidget {
  Q_OBJECT
public:
  /// @param pages  In the order of Page.
  PageStack(const std::array<QWidget*, 5>& pages, Page shown, QWidget* parent);

  void showPage(Page page) { setCurrentIndex(static_cast<int>(page)); }
  Page page() const { return static_cast<Page>(currentIndex()); }
};

}  // namespace perilymph::gui
