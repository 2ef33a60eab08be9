// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The day at the booth: how many visitors, their best and median peak force, the gentlest insertions.

#include <QWidget>
#include <optional>
#include <vector>

#include "gui/kiosk/ForceLevel.h"
#include "gui/kiosk/Leaderboard.h"

class QVBoxLayout;

namespace perilymph::gui {

class DayView : public QWidget {
  Q_OBJECT
public:
  /// What is shown.
  struct Content {
    DayStatistics statistics;
    std::vector<KioskEntry> best;  ///< Sorted by peak.
    std::optional<int> chosen;     ///< Rank of the visitor's insertion, from 1.
  };

  explicit DayView(QWidget* parent);

  /// Range of the levels in front of the forces.
  void setRange(std::optional<analysis::PrintedRange> measured);
  /// Size of the type [px, before textScale()].
  void setLetterSize(int size_px);
  /// Shows as many insertions as there is room for; the visitor's own is among them.
  void show(Content content);
  /// The same in the present language.
  void retranslate() { fill(); }

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  void fill();
  void addNumber(const QString& caption, const QString& number);
  void addRow(int rank, const KioskEntry& entry, bool isChosen);
  QString forceText(double peak_mN) const;
  int rowHeight() const;

  std::optional<analysis::PrintedRange> measured_;
  Content content_;
  int letter_px_ = 20;
  QWidget* rows_ = nullptr;
  QVBoxLayout* column_;
};

}  // namespace perilymph::gui
