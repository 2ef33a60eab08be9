// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/sessions/SessionTable.h"

#include <QColor>
#include <QDateTime>
#include <QIcon>
#include <algorithm>
#include <iterator>
#include <map>

#include "gui/report/InsertionOutcome.h"
#include "gui/setup/SetupTitle.h"
#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/Theme.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/session/ScenarioChoices.h"

namespace perilymph::gui {

using session::SessionSummary;

namespace {

QString nameOf(const SessionSummary& session)
{
  return QString::fromStdString(session::displayNameOf(session.file));
}

QString techniqueOf(const SessionSummary& session)
{
  const auto is = [&session](session::Technique technique) {
    return session.technique == session::nameOf(technique);
  };
  if (is(session::Technique::standard)) return SessionTable::tr("Standard");
  if (is(session::Technique::advanceOffStylet)) return SessionTable::tr("Advance off-stylet");
  return QString::fromStdString(session.technique);
}

/// The same picture for selected rows: Qt would tint it.
QIcon plainIcon(const QPixmap& pixmap)
{
  QIcon icon(pixmap);
  icon.addPixmap(pixmap, QIcon::Selected);
  return icon;
}

/// It neither reached its stop nor was ended by the hand.
bool hasFailed(const SessionSummary& session)
{
  const haptics::InsertionEnd end = session.highlights.end;
  return end != haptics::InsertionEnd::none && end != haptics::InsertionEnd::finished &&
         end != haptics::InsertionEnd::stoppedByResistance;
}

}  // namespace

QString recordedText(const SessionSummary& session)
{
  const auto utc = QDateTime::fromString(QString::fromStdString(session.startedUtc), Qt::ISODate);
  return utc.isValid() ? utc.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm")) : QString();
}

SessionTable::SessionTable(QObject* parent)
    : QAbstractTableModel(parent), thumbnails_(new Thumbnails(this))
{
  connect(thumbnails_, &Thumbnails::painted, this, &SessionTable::showPicture);
}

/// The file of an insertion that has not begun may be removed.
void SessionTable::dropUnbegun(std::vector<SessionSummary>& sessions) const
{
  if (progress_ == Progress::ready)
    std::erase_if(sessions, [](const SessionSummary& each) { return each.isBeingRecorded; });
}

void SessionTable::setSessions(std::vector<SessionSummary> sessions)
{
  dropUnbegun(sessions);
  beginResetModel();
  rows_.clear();
  rows_.reserve(sessions.size());
  for (SessionSummary& each : sessions) rows_.push_back(rowOf(std::move(each)));
  endResetModel();
}

void SessionTable::showSorting(int column, Qt::SortOrder order)
{
  sortedBy_ = column;
  order_ = order;
  Q_EMIT headerDataChanged(Qt::Horizontal, 0, columns - 1);
}

void SessionTable::addSessions(std::vector<SessionSummary> sessions)
{
  dropUnbegun(sessions);
  std::map<std::filesystem::path, std::size_t> places;
  for (std::size_t i = 0; i < rows_.size(); ++i) places.emplace(rows_[i].session.file, i);
  std::vector<Row> added;
  for (SessionSummary& each : sessions) {
    const auto known = places.find(each.file);
    if (known == places.end()) {
      added.push_back(rowOf(std::move(each)));
      continue;
    }
    rows_[known->second] = rowOf(std::move(each));
    const int row = int(known->second);
    Q_EMIT dataChanged(index(row, 0), index(row, columns - 1));
  }
  if (added.empty()) return;
  const int first = int(rows_.size());
  beginInsertRows({}, first, first + int(added.size()) - 1);
  rows_.insert(rows_.end(), std::make_move_iterator(added.begin()),
               std::make_move_iterator(added.end()));
  endInsertRows();
}

void SessionTable::setProgress(Progress progress)
{
  if (progress == progress_) return;
  progress_ = progress;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (!rows_[i].session.isBeingRecorded) continue;
    rows_[i] = rowOf(std::move(rows_[i].session));
    Q_EMIT dataChanged(index(int(i), 0), index(int(i), columns - 1));
  }
}

SessionTable::Row SessionTable::rowOf(SessionSummary session) const
{
  Row row;
  row.session = std::move(session);
  row.recorded = row.session.isBeingRecorded ? recordingText(progress_) : recordedText(row.session);
  QStringList label;
  for (int column = recorded; column <= name; ++column) label << text(row, column);
  label << QString::fromStdString(row.session.file.stem().string())
        << QString::fromStdString(row.session.scenario)
        << QString::fromStdString(row.session.device);
  row.searched = label.join(QLatin1Char(' '));
  return row;
}

void SessionTable::showPicture(const std::filesystem::path& file)
{
  const auto found = std::find_if(rows_.begin(), rows_.end(),
                                  [&file](const Row& row) { return row.session.file == file; });
  if (found == rows_.end()) return;
  const QModelIndex cell = index(int(found - rows_.begin()), picture);
  Q_EMIT dataChanged(cell, cell, {Qt::DecorationRole});
}

int SessionTable::rowCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : int(rows_.size());
}

int SessionTable::columnCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : columns;
}

QString SessionTable::text(const Row& row, int column) const
{
  const SessionSummary& session = row.session;
  const session::Highlights& found = session.highlights;
  switch (column) {
    case recorded:
      return row.recorded;
    case name:
      return nameOf(session);
    case patient:
      if (session.patient.empty()) return session.error.empty() ? QString() : tr("unreadable");
      return QString::fromStdString(session.patient);
    case ear:
      if (session.patient.empty()) return {};
      if (session.side == anatomy::nameOf(anatomy::Side::left)) return tr("left");
      return session.side == anatomy::nameOf(anatomy::Side::right) ? tr("right") : QString();
    case technique:
      return techniqueOf(session);
    case outcome:
      if (session::isInsertion(session)) return outcomeWord(found.end);
      return session.isBeingRecorded || session.startedUtc.empty() ? QString() : tr("empty");
    case array:
      return QString::fromStdString(session.array);
    case duration:
      return session::isInsertion(session) ? tr("%1 s").arg(numberText(found.duration, 1))
                                           : QString();
    case angle:
      return session::isInsertion(session)
                 ? tr("%1°").arg(numberText(inDegrees(radians(found.deepestAngle)), 0))
                 : QString();
    case peak:
      return session::isInsertion(session)
                 ? tr("%1 mN at %2 mm")
                       .arg(forceNumber(inMillinewtons(newtons(found.peakForce))),
                            numberText(inMillimeters(meters(found.peakDepth)), 1))
                 : QString();
    default:
      return {};
  }
}

QStringList SessionTable::widestTexts(int column) const
{
  const QString heading = tr("%1 %2").arg(title(column), QStringLiteral("↓"));
  switch (column) {
    case recorded:
      return {heading, QStringLiteral("2026-08-28 20:48"), recordingText(Progress::underway),
              recordingText(Progress::resting)};
    case ear:
      return {heading, tr("left"), tr("right")};
    case technique:
      return {heading, tr("Standard"), tr("Advance off-stylet")};
    case outcome:
      return {heading, outcomeWord(haptics::InsertionEnd::finished),
              outcomeWord(haptics::InsertionEnd::none), tr("empty")};
    case duration:
      return {heading, tr("%1 s").arg(numberText(8888.8, 1))};
    case angle:
      return {heading, tr("%1°").arg(888)};
    case peak:
      return {heading, tr("%1 mN at %2 mm").arg(forceNumber(888.0), numberText(88.8, 1))};
    default:
      return {};
  }
}

QVariant SessionTable::sortValue(const Row& row, int column) const
{
  const SessionSummary& session = row.session;
  switch (column) {
    case duration:
      return session.highlights.duration;
    case angle:
      return session.highlights.deepestAngle;
    case peak:
      return session.highlights.peakForce;
    case picture:
    case recorded:
      // a recording in progress is the newest
      return session.isBeingRecorded ? QStringLiteral("~")
                                     : QString::fromStdString(session.startedUtc);
    default:
      return text(row, column).toLower();
  }
}

QVariant SessionTable::data(const QModelIndex& index, int role) const
{
  if (!index.isValid()) return {};
  const Row& row = rows_[std::size_t(index.row())];
  const SessionSummary& shown = row.session;
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return text(row, index.column());
    case Qt::DecorationRole:
      return index.column() == picture ? QVariant(plainIcon(thumbnails_->find(shown))) : QVariant();
    case Qt::ToolTipRole:
      return shown.error.empty() ? QString::fromStdString(shown.file.string())
                                 : dataText(shown.error);
    case Qt::TextAlignmentRole:
      return index.column() >= duration ? int(Qt::AlignRight | Qt::AlignVCenter)
                                        : int(Qt::AlignLeft | Qt::AlignVCenter);
    case Qt::ForegroundRole:
      if (!shown.error.empty()) return shownTheme().warning;
      if (index.column() == outcome && hasFailed(shown)) return shownTheme().warning;
      return index.column() == name ? shownTheme().quietText : shownTheme().text;
    case sortRole:
      return sortValue(row, index.column());
    case searchRole:
      return row.searched;
    default:
      return {};
  }
}

QVariant SessionTable::headerData(int section, Qt::Orientation orientation, int role) const
{
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return section >= duration ? int(Qt::AlignRight | Qt::AlignVCenter)
                               : int(Qt::AlignLeft | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  if (section != sortedBy_) return title(section);
  return tr("%1 %2").arg(title(section),
                         order_ == Qt::AscendingOrder ? QStringLiteral("↑") : QStringLiteral("↓"));
}

QString SessionTable::title(int column) const
{
  switch (column) {
    case recorded:
      return tr("Recorded");
    case name:
      return tr("Name");
    case patient:
      return tr("Patient");
    case ear:
      return tr("Ear");
    case technique:
      return tr("Technique");
    case outcome:
      return tr("Outcome");
    case array:
      return tr("Array");
    case duration:
      return tr("Insertion time");
    case angle:
      return tr("Tip angle");
    case peak:
      return tr("Peak force at depth");
    default:
      return {};
  }
}

Qt::ItemFlags SessionTable::flags(const QModelIndex& index) const
{
  Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  if (index.isValid() && index.column() == name && !session(index.row()).isBeingRecorded)
    flags |= Qt::ItemIsEditable;
  return flags;
}

bool SessionTable::setData(const QModelIndex& index, const QVariant& value, int role)
{
  if (role != Qt::EditRole || index.column() != name) return false;
  const QString asked = value.toString().trimmed();
  if (asked == nameOf(session(index.row()))) return false;
  Q_EMIT renameRequested(session(index.row()).file, asked);
  return true;
}

}  // namespace perilymph::gui
