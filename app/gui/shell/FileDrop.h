// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Files dropped on the window.

#include <QObject>

namespace perilymph::gui {

class PageStack;

/// Passes one file to the page that opens it; anything else is rejected while it is dragged.
class FileDrop : public QObject {
  Q_OBJECT
public:
  FileDrop(const PageStack& pages, QWidget* window);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  const PageStack& pages_;
};

}  // namespace perilymph::gui
