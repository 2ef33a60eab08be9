// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The CTs that were opened last, by code and date: a folder's name may be a patient's.

#include <QMenu>

#include "gui/setup/CtRequest.h"

namespace perilymph::gui {

/// A menu of recentScans(), read whenever it opens.
class RecentScans : public QMenu {
  Q_OBJECT
public:
  explicit RecentScans(QWidget* parent);

Q_SIGNALS:
  void chosen(const perilymph::gui::CtRequest& request);

private:
  void read();
};

}  // namespace perilymph::gui
