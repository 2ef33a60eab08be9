// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The series of a CT, to choose from.

#include <QListWidget>
#include <string>
#include <vector>

#include "perilymph/imaging/CtSeries.h"

namespace perilymph::gui {

/// Each series with its sizes, its picture, and what is to be known of it as a tool tip.
class CtSeriesList : public QListWidget {
  Q_OBJECT
public:
  explicit CtSeriesList(QWidget* parent);

  void show(const imaging::CtSeriesList& list);
  /// Adds pictures to the series of the list.
  void showThumbnails(const std::vector<imaging::CtThumbnail>& pictures);

  /// The series' UID of a row.
  static std::string uidOf(const QListWidgetItem& item);
};

}  // namespace perilymph::gui
