#pragma once

// The best insertions of the day as a list that can be read from two meters.

#include <QWidget>
#include <optional>
#include <vector>

#include "gui/kiosk/KioskBoard.h"

class QLabel;
class QVBoxLayout;

namespace perilymph::gui {

class BoardView : public QWidget {
  Q_OBJECT
public:
  explicit BoardView(QWidget* parent);

  /// @param words   For each entry's peak.
  /// @param chosen  The place that stands out, 1 for the first.
  void show(const std::vector<KioskEntry>& entries, const QStringList& caption,
            std::optional<int> chosen);
  /// Whose forces the words compare with.
  void setSource(const QString& source);

private:
  void addRow(int rank, const KioskEntry& entry, const QString& caption, bool isChosen);

  QWidget* rows_ = nullptr;
  QVBoxLayout* column_;
  QLabel* source_;
};

}  // namespace perilymph::gui
