// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Table of recordings: texts and sort keys of its columns.

#include <QAbstractTableModel>
#include <vector>

#include "gui/pages/sessions/Thumbnails.h"
#include "gui/run/InsertionControl.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

class SessionTable : public QAbstractTableModel {
  Q_OBJECT
public:
  enum Column {
    picture,
    recorded,
    patient,
    ear,
    array,
    technique,
    outcome,
    name,
    duration,
    angle,
    peak,
    columns
  };
  /// Role of the sort key: a number or a text.
  static constexpr int sortRole = Qt::UserRole;
  /// Role of the searchable text of a row.
  static constexpr int searchRole = Qt::UserRole + 1;

  explicit SessionTable(QObject* parent);

  void setSessions(std::vector<session::SessionSummary> sessions);
  /// Adds recordings and updates existing ones.
  void addSessions(std::vector<session::SessionSummary> sessions);
  /// What the insertion does whose recording is being written.
  void setProgress(Progress progress);
  const session::SessionSummary& session(int row) const { return rows_[std::size_t(row)].session; }

  /// Title and texts that a column has room for; the name has what is left, patient and array are
  /// cut.
  QStringList widestTexts(int column) const;

  /// Marks the column that the rows are sorted by: "Recorded ↓".
  void showSorting(int column, Qt::SortOrder order);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

Q_SIGNALS:
  /// The user entered another name.
  void renameRequested(const std::filesystem::path& file, const QString& name);

private:
  struct Row {
    session::SessionSummary session;
    QString recorded;  ///< In the user's time zone; cached for sorting and searching.
    QString searched;  ///< Searchable text.
  };

  void dropUnbegun(std::vector<session::SessionSummary>& sessions) const;
  Row rowOf(session::SessionSummary session) const;
  QString text(const Row& row, int column) const;
  QVariant sortValue(const Row& row, int column) const;
  void showPicture(const std::filesystem::path& file);

  QString title(int column) const;

  std::vector<Row> rows_;
  Progress progress_ = Progress::underway;
  int sortedBy_ = recorded;
  Qt::SortOrder order_ = Qt::DescendingOrder;
  Thumbnails* thumbnails_;
};

/// "2026-11-20 16:31" in the user's time zone.
QString recordedText(const session::SessionSummary& session);

}  // namespace perilymph::gui
