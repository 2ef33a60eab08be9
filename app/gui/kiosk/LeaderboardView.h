// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The list of the day's best insertions, readable from two meters.

#include <QWidget>
#include <optional>
#include <vector>

#include "gui/kiosk/Leaderboard.h"

class QLabel;
class QVBoxLayout;

namespace perilymph::gui {

class LeaderboardView : public QWidget {
  Q_OBJECT
public:
  explicit LeaderboardView(QWidget* parent);

  /// @param words   Text for each entry's peak.
  /// @param chosen  Rank of the highlighted entry, from 1.
  void show(const std::vector<KioskEntry>& entries, const QStringList& caption,
            std::optional<int> chosen);
  /// Sets the source of the reference forces.
  void setSource(const QString& source);

private:
  void addRow(int rank, const KioskEntry& entry, const QString& caption, bool isChosen);

  QWidget* rows_ = nullptr;
  QVBoxLayout* column_;
  QLabel* source_;
};

}  // namespace perilymph::gui
