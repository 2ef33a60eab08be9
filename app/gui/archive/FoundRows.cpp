// SPDX-License-Identifier: BSD-3-Clause
#include "gui/archive/FoundRows.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <utility>

#include "gui/archive/ArchiveQuery.h"
#include "gui/widgets/TableRows.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int row_px = 28, minHeight_px = 120, widest_px = 260;

QString textOf(const std::string& text)
{
  return text.empty() ? QStringLiteral("–") : QString::fromStdString(text);
}

/// "Doe, Jane" for "Doe^Jane".
QString nameText(const std::string& dicom)
{
  QString name = QString::fromStdString(dicom).section(QLatin1Char('='), 0, 0);
  const QString family = name.section(QLatin1Char('^'), 0, 0);
  const QString given =
      name.section(QLatin1Char('^'), 1).replace(QLatin1Char('^'), QLatin1Char(' ')).trimmed();
  if (given.isEmpty()) return textOf(family.toStdString());
  return family + QStringLiteral(", ") + given;
}

template <class Row>
const Row* at(const std::vector<Row>& rows, int index)
{
  return index >= 0 && index < int(rows.size()) ? &rows[std::size_t(index)] : nullptr;
}

}  // namespace

FoundTable::FoundTable(const char* name, const QString& accessibleName, const QStringList& headings,
                       QWidget* parent)
    : QTableWidget(0, int(headings.size()), parent)
{
  setObjectName(QLatin1String(name));
  setAccessibleName(accessibleName);
  setFont(typeface(13));
  showInRows(*this, sized(row_px));
  setSelectionMode(QAbstractItemView::SingleSelection);
  setWordWrap(false);
  setMinimumHeight(sized(minHeight_px));
  setHorizontalHeaderLabels(headings);
  horizontalHeader()->setFont(typeface(11));
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  horizontalHeader()->setStretchLastSection(true);
  connect(this, &QTableWidget::itemSelectionChanged, this, [this] {
    const auto rows = selectionModel()->selectedRows();
    Q_EMIT rowChosen(rows.isEmpty() ? -1 : rows.front().row());
  });
  connect(this, &QTableWidget::cellDoubleClicked, this, &FoundTable::rowOpened);
}

void FoundTable::fill(const std::vector<QStringList>& rows)
{
  clearSelection();
  setRowCount(int(rows.size()));
  for (int row = 0; row < int(rows.size()); ++row)
    for (int column = 0; column < columnCount(); ++column) {
      auto* item = new QTableWidgetItem(rows[std::size_t(row)].at(column));
      item->setToolTip(item->text().toHtmlEscaped());
      setItem(row, column, item);
    }
  resizeColumnsToContents();
  for (int column = 0; column + 1 < columnCount(); ++column)
    setColumnWidth(column, std::min(columnWidth(column) + spacing, sized(widest_px)));
  if (!rows.empty()) selectRow(0);
}

void FoundTable::keyPressEvent(QKeyEvent* event)
{
  const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (isReturn && currentRow() >= 0) return rowOpened(currentRow());
  QTableWidget::keyPressEvent(event);
}

StudyRows::StudyRows(QWidget* parent)
    : FoundTable("archiveStudies", tr("Studies"),
                 {tr("Date"), tr("Patient"), tr("Number"), tr("Born"), tr("Kind"), tr("Study")},
                 parent)
{
}

void StudyRows::show(std::vector<archive::FoundStudy> studies)
{
  studies_ = std::move(studies);
  std::vector<QStringList> rows;
  for (const archive::FoundStudy& each : studies_)
    rows.push_back({dateText(each.date), nameText(each.patientName), textOf(each.patientId),
                    dateText(each.birthDate), textOf(each.modalities), textOf(each.description)});
  fill(rows);
}

const archive::FoundStudy* StudyRows::chosen() const { return at(studies_, currentRow()); }

SeriesRows::SeriesRows(QWidget* parent)
    : FoundTable("archiveSeries", tr("Series"),
                 {tr("Series no."), tr("Kind"), tr("Images"), tr("Series")}, parent)
{
}

void SeriesRows::show(std::vector<archive::FoundSeries> series)
{
  series_ = std::move(series);
  std::vector<QStringList> rows;
  for (const archive::FoundSeries& each : series_)
    rows.push_back({textOf(each.number), textOf(each.modality),
                    each.images ? QString::number(*each.images) : QStringLiteral("–"),
                    textOf(each.description)});
  fill(rows);
}

const archive::FoundSeries* SeriesRows::chosen() const { return at(series_, currentRow()); }

}  // namespace perilymph::gui
