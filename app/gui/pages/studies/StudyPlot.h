// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The plot of a study's insertions, in which one can be chosen by mouse or keyboard.

#include <QFrame>
#include <cstdint>
#include <optional>
#include <vector>

#include "gui/pages/studies/StudyWork.h"
#include "perilymph/charts/ScatterChart.h"
#include "perilymph/study/StudySummary.h"

namespace perilymph::gui {

class PlainVtkWidget;

/// Two quantities of the selected insertions, one over the other, in the groups of a setting.
class StudyPlot : public QFrame {
  Q_OBJECT
public:
  explicit StudyPlot(QWidget* parent);
  ~StudyPlot() override;

  /// What is plotted. All three are keys; an empty group is one group.
  using Axes = study::SummaryAxes;
  void show(const StudyWork::Columns& columns, const Axes& axes);
  /// Shows some rows; the axes keep the ranges of all.
  void showRows(std::vector<std::uint32_t> rows);
  /// Draws the lines of a summary of the shown rows, until other rows or axes are shown.
  void showTrends(const study::StudySummary& summary, study::StudySelection selection);
  void select(std::optional<std::uint32_t> row);
  std::optional<std::uint32_t> selected() const { return selected_; }
  const std::vector<std::uint32_t>& rows() const { return rows_; }
  /// Draws what has changed, at once.
  void render();
  charts::ScatterChart& chart() { return chart_; }

Q_SIGNALS:
  void chosen(std::uint32_t row);
  /// Return or a double click on a point.
  void opened(std::uint32_t row);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

private:
  void showGroups(const study::StudySummary* summary, study::StudySelection selection);
  std::optional<std::uint32_t> rowAt(const QPointF& place) const;
  void step(bool isAlongX, int by);
  void showFocus(bool isFocused);
  void later();

  charts::ScatterChart chart_;
  PlainVtkWidget* view_;
  StudyWork::Columns columns_;
  Axes axes_;
  std::vector<std::uint32_t> rows_;
  std::optional<std::uint32_t> selected_;
  bool isWaiting_ = false;  ///< A drawing is due in this turn of the event loop.
};

}  // namespace perilymph::gui
