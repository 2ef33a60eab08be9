// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What an insertion came to, shown over the charts of the last seconds once it has ended.

#include <QFrame>

#include "gui/report/ReportContent.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace perilymph::gui {

/// Forces, depth and contacts beside the band of a plan, and what to do next. Hidden until an
/// insertion has ended; the user may close it.
class ResultCard : public QFrame {
  Q_OBJECT
public:
  /// Placed over `page`, whose size it follows.
  explicit ResultCard(QWidget* page);

  /// @param title  How the insertion ended: "Full depth".
  void show(const ReportContent& content, const QString& title);

Q_SIGNALS:
  void reportAsked();
  void compareAsked();
  void againAsked();

protected:
  bool eventFilter(QObject* target, QEvent* event) override;

private:
  void place();
  void addRow(int row, const QString& name, const QString& value, const QString& plan,
              bool isOutside);

  QLabel* title_;
  QLabel* subject_;
  QWidget* rows_ = nullptr;
  QPushButton* report_;
};

}  // namespace perilymph::gui
