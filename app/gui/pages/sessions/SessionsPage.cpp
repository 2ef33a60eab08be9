// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/sessions/SessionsPage.h"

#include <QHBoxLayout>
#include <QItemSelection>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QStackedWidget>
#include <QTableView>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <set>

#include "gui/pages/sessions/SessionList.h"
#include "gui/pages/sessions/SessionTable.h"
#include "gui/pages/sessions/SessionTasks.h"
#include "gui/report/InsertionReport.h"
#include "gui/text/DataText.h"
#include "gui/widgets/EmptyPage.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Placeholder.h"
#include "gui/widgets/StatusLine.h"
#include "gui/widgets/Theme.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::gui {

namespace {

QLabel* text(const QString& caption, int size_px, QWidget* parent, bool isQuiet = false)
{
  auto* label = new QLabel(caption, parent);
  label->setFont(typeface(size_px));
  label->setProperty("quiet", isQuiet);
  return label;
}

}  // namespace

SessionsPage::SessionsPage(const InsertionControl& control, QWidget* parent,
                           LibraryWork::Lister lister)
    : Page("sessions", tr("Recordings"), Icon::sessions, parent),
      control_(control),
      work_(this, std::move(lister)),
      tasks_(new SessionTasks(this)),
      table_(new SessionTable(this)),
      sorted_(new QSortFilterProxyModel(this))
{
  sorted_->setSourceModel(table_);
  sorted_->setSortRole(SessionTable::sortRole);
  sorted_->setFilterRole(SessionTable::searchRole);
  sorted_->setFilterKeyColumn(SessionTable::recorded);
  sorted_->setFilterCaseSensitivity(Qt::CaseInsensitive);

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(3 * spacing, 3 * spacing, 3 * spacing, 2 * spacing);
  column->setSpacing(2 * spacing);
  column->addWidget(addTop());
  column->addWidget(addList(), 1);
  column->addWidget(addVerbs());

  connect(&work_, &LibraryWork::progressed, this, [this](int done, int all, const auto& fresh) {
    showFresh(fresh);
    progress_->setVisible(true);
    progress_->setRange(0, all);
    progress_->setValue(done);
    showMessage(tr("Reading recording %1 of %2. Esc cancels.").arg(done).arg(all));
    end_->setVisible(true);
  });
  connect(&work_, &LibraryWork::listed, this, &SessionsPage::showList);
  connect(&work_, &LibraryWork::failed, this, [this](const QString& sentence) {
    progress_->setVisible(false);
    end_->setVisible(false);
    showMessage(sentence, true);
  });
  // After the editor has closed, because the rows are rebuilt.
  connect(table_, &SessionTable::renameRequested, this,
          [this](const std::filesystem::path& file, const QString& name) {
            QMetaObject::invokeMethod(
                this, [this, file, name] { rename(file, name); }, Qt::QueuedConnection);
          });
  showList({}, 0);
}

QWidget* SessionsPage::addTop()
{
  auto* top = new QWidget(this);
  search_ = new QLineEdit(top);
  search_->setObjectName(QStringLiteral("sessionSearch"));
  search_->setFont(typeface(13));
  search_->setFixedSize(sized(280), sized(32));
  markPlaceholder(*search_, tr("Search by patient, array, date or name"));
  search_->setAccessibleName(tr("Search recordings"));
  search_->setClearButtonEnabled(true);
  connect(search_, &QLineEdit::textChanged, sorted_, &QSortFilterProxyModel::setFilterFixedString);
  connect(search_, &QLineEdit::textChanged, this, &SessionsPage::showChoice);
  count_ = text({}, 13, top, true);
  count_->setObjectName(QStringLiteral("sessionCount"));
  progress_ = new QProgressBar(top);
  progress_->setTextVisible(false);
  progress_->setFixedSize(160, 6);
  progress_->setVisible(false);
  end_ = addVerb(tr("Cancel"), "cancelReadingButton", tr("List the recordings read so far (Esc)"));
  end_->setVisible(false);
  connect(end_, &QPushButton::clicked, this, &SessionsPage::cancel);
  auto* row = new QHBoxLayout(top);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2 * spacing);
  row->addWidget(text(tr("Recorded insertions"), 22, top));
  row->addWidget(count_, 0, Qt::AlignBottom);
  row->addStretch();
  row->addWidget(progress_);
  row->addWidget(end_);
  row->addWidget(search_);
  return top;
}

QWidget* SessionsPage::addList()
{
  list_ = new SessionList(*table_, *sorted_, this);
  connect(list_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &SessionsPage::showChoice);
  connect(list_, &QTableView::doubleClicked, this, &SessionsPage::replayChosen);

  empty_ = new EmptyPage({}, {}, this);
  stack_ = new QStackedWidget(this);
  stack_->addWidget(empty_);
  stack_->addWidget(list_);
  return stack_;
}

QWidget* SessionsPage::addVerbs()
{
  auto* verbs = new QWidget(this);
  replay_ = addVerb(tr("Replay"), "replayButton", tr("Replay the recording (Enter)"));
  replay_->setProperty("primary", true);
  compare_ =
      addVerb(tr("Compare"), "compareButton", tr("Plot two or more recordings on common axes"));
  ghost_ = addVerb(tr("Use as reference"), "ghostButton",
                   tr("Show its force as reference trace in the next insertions"));
  report_ = addVerb(tr("Report…"), "reportButton", tr("Save a report as PDF or DICOM"));
  send_ = addVerb(
      tr("Send…"), "sendReportButton",
      tr("Report of the insertion into the study of the patient’s CT, as DICOM to an archive"));
  rename_ = addVerb(tr("Rename"), "renameButton", tr("Rename the recording (F2)"));
  delete_ = addVerb(tr("Delete"), "deleteButton", tr("Move to the trash (Delete)"));
  undo_ = addVerb(tr("Undo"), "undoDeleteButton", tr("Restore from the trash (Ctrl+Z)"));
  status_ = new StatusLine("sessionStatus", verbs);

  auto* row = new QHBoxLayout(verbs);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(spacing);
  for (QPushButton* button : {replay_, compare_, ghost_, report_, send_, rename_, delete_, undo_})
    row->addWidget(button);
  row->addSpacing(spacing);
  row->addWidget(status_, 1);

  connect(replay_, &QPushButton::clicked, this, &SessionsPage::replayChosen);
  connect(report_, &QPushButton::clicked, this, &SessionsPage::reportChosen);
  connect(send_, &QPushButton::clicked, this, [this] {
    if (const auto file = oneChosen()) tasks_->prepareReportOf(*file);
  });
  connect(tasks_, &SessionTasks::reportPrepared, this,
          [this](const std::string& pdf, const ReportIdentity& identity) {
            sendReport(insertionReportName(), pdf, identity, ctPlaces_, this);
          });
  connect(ghost_, &QPushButton::clicked, this, [this] {
    if (const auto file = oneChosen()) tasks_->readReference(*file);
  });
  connect(tasks_, &SessionTasks::said, this, &SessionsPage::showMessage);
  connect(tasks_, &SessionTasks::referenceRead, this, &SessionsPage::referenceRead);
  connect(tasks_, &SessionTasks::reportWritten, this,
          [this](const std::filesystem::path& report, const QString& sentence) {
            status_->sayWritten(sentence, report.parent_path());
          });
  connect(compare_, &QPushButton::clicked, this, [this] {
    std::vector<std::filesystem::path> files;
    for (const session::SessionSummary& each : chosen()) files.push_back(each.file);
    if (!files.empty()) Q_EMIT compareRequested(files);
  });
  connect(rename_, &QPushButton::clicked, this, [this] {
    const QModelIndex current = list_->currentIndex();
    if (current.isValid()) list_->edit(current.siblingAtColumn(SessionTable::name));
  });
  connect(delete_, &QPushButton::clicked, this, &SessionsPage::throwAway);
  connect(undo_, &QPushButton::clicked, this, &SessionsPage::bringBack);
  return verbs;
}

QPushButton* SessionsPage::addVerb(const QString& caption, const char* name, const QString& tip)
{
  auto* button = new QPushButton(caption, this);
  button->setObjectName(QLatin1String(name));
  button->setFont(typeface(13, QFont::Medium));
  button->setFixedHeight(sized(32));
  button->setToolTip(tip);
  return button;
}

void SessionsPage::onShown()
{
  reread();
  setFocus();
}

void SessionsPage::reread()
{
  table_->setProgress(insertion_ = control_.progress());
  work_.list(sessionFolder(), control_.openRecording().value_or(std::filesystem::path()));
}

void SessionsPage::follow()
{
  const Progress now = control_.progress();
  if (!isVisible() || now == insertion_) return;
  if (now == Progress::concluded || insertion_ == Progress::concluded || now == Progress::ready)
    return reread();
  table_->setProgress(insertion_ = now);
  showChoice();
}

bool SessionsPage::cancel()
{
  if (!isBusy() && search_->text().isEmpty()) return false;
  isBusy() ? work_.cancel() : search_->clear();
  return true;
}

void SessionsPage::showMessage(const QString& sentence, bool isError)
{
  status_->showMessage(sentence, isError);
}

void SessionsPage::showFresh(std::vector<session::SessionSummary> sessions)
{
  table_->addSessions(std::move(sessions));
  showChoice();
}

void SessionsPage::showList(std::vector<session::SessionSummary> sessions, int all)
{
  const int read = int(sessions.size());
  // the selection is kept
  std::set<std::filesystem::path> before;
  for (const session::SessionSummary& each : chosen()) before.insert(each.file);
  progress_->setVisible(false);
  end_->setVisible(false);
  showMessage({});
  table_->setSessions(std::move(sessions));
  QItemSelection again;
  for (int row = 0; row < table_->rowCount() && !before.empty(); ++row) {
    if (before.count(table_->session(row).file) == 0) continue;
    const QModelIndex here = sorted_->mapFromSource(table_->index(row, 0));
    if (here.isValid()) again.select(here, here);
  }
  list_->selectionModel()->select(again, QItemSelectionModel::Select | QItemSelectionModel::Rows);
  if (list_->selectionModel()->selectedRows().isEmpty() && sorted_->rowCount() > 0)
    list_->setCurrentIndex(sorted_->index(0, SessionTable::recorded));
  showChoice();
  if (read < all)
    showMessage(tr("Canceled: %1 of %2 recordings listed. Open this page again to continue.")
                    .arg(read)
                    .arg(all));
}

std::vector<session::SessionSummary> SessionsPage::chosen() const
{
  std::vector<session::SessionSummary> found;
  if (list_ == nullptr) return found;
  QModelIndexList rows = list_->selectionModel()->selectedRows();
  std::sort(rows.begin(), rows.end());
  for (const QModelIndex& row : rows)
    found.push_back(table_->session(sorted_->mapToSource(row).row()));
  return found;
}

void SessionsPage::showChoice()
{
  const int all = table_->rowCount(), shown = sorted_->rowCount();
  count_->setText(all == 0       ? QString()
                  : shown == all ? tr("%n in the library", nullptr, all)
                                 : tr("%1 of %2").arg(shown).arg(all));
  if (all == 0)
    empty_->showMessage(tr("No recorded insertions"),
                        tr("Every insertion is recorded automatically. Recordings can be replayed, "
                           "compared and reported here."));
  else
    empty_->showMessage(
        tr("No results"),
        tr("No recording matches “%1” by patient, array, date or name.").arg(search_->text()));
  stack_->setCurrentIndex(shown == 0 ? 0 : 1);
  // a hidden list would hold the focus, and Tab would go nowhere
  const bool isListMissed = shown > 0 && hasFocus() && focusProxy() == nullptr;
  setFocusProxy(shown == 0 ? nullptr : list_);
  if (isListMissed) list_->setFocus();

  const auto rows = chosen();
  const bool isReadable =
      !rows.empty() && std::all_of(rows.begin(), rows.end(), session::isInsertion);
  const bool isOne = rows.size() == 1;
  for (QPushButton* button : {replay_, ghost_, report_, send_})
    button->setEnabled(isOne && isReadable);
  const bool canCompare = rows.size() >= 2 && isReadable;
  compare_->setEnabled(canCompare);
  setPrimary(*compare_, canCompare);
  setPrimary(*replay_, !canCompare);
  rename_->setEnabled(isOne && !rows[0].isBeingRecorded);
  delete_->setEnabled(!rows.empty() && !rows[0].isBeingRecorded);
  undo_->setVisible(!trashed_.empty());
  if (isOne && !rows[0].error.empty())
    showMessage(dataText(rows[0].error), true);
  else if (isOne && rows[0].isBeingRecorded)
    showMessage(insertion_ == Progress::resting
                    ? tr("This insertion has ended; its rest is recorded until nothing moves.")
                    : tr("This insertion is being recorded. Reset ends the recording."));
  else if (!rows.empty() && !isReadable)
    showMessage(tr("Only insertions can be compared; the selection has a recording that is none."),
                true);
  else if (!trashed_.empty())
    showMessage(tr("%n moved to the trash.", nullptr, int(trashed_.size())));
  else
    showMessage(isOne && all > 1 ? tr("Select several with Ctrl or Shift to compare.") : QString());
}

std::optional<std::filesystem::path> SessionsPage::oneChosen() const
{
  const auto rows = chosen();
  const bool isOne = rows.size() == 1 && session::isInsertion(rows[0]);
  return isOne ? std::optional(rows[0].file) : std::nullopt;
}

void SessionsPage::replayChosen()
{
  const auto file = oneChosen();
  if (!file) return showChoice();  // which says why
  showMessage(tr("Opening %1…").arg(QString::fromStdString(session::displayNameOf(*file))));
  Q_EMIT replayRequested(*file);
}

void SessionsPage::reportChosen()
{
  const auto file = oneChosen();
  if (!file) return;
  if (const auto place = askReportPlace(*file, this)) saveReport(*file, *place);
}

void SessionsPage::saveReport(const std::filesystem::path& file, const ReportPlace& place)
{
  tasks_->writeReportOf(file, place);
}

void SessionsPage::rename(const std::filesystem::path& file, const QString& name)
{
  const auto renamed = session::renameSession(file, name.toStdString());
  if (renamed) return reread();
  editName(file, name);
  showMessage(dataText(renamed.error().message), true);
}

void SessionsPage::editName(const std::filesystem::path& file, const QString& name)
{
  for (int row = 0; row < table_->rowCount(); ++row) {
    if (table_->session(row).file != file) continue;
    const QModelIndex here = sorted_->mapFromSource(table_->index(row, SessionTable::name));
    if (!here.isValid()) return;
    list_->setCurrentIndex(here);
    list_->edit(here);
    if (auto* editor = list_->viewport()->findChild<QLineEdit*>()) editor->setText(name);
  }
}

void SessionsPage::throwAway()
{
  trashed_.clear();
  for (const session::SessionSummary& each : chosen()) {
    if (each.isBeingRecorded) continue;
    const auto trashed = session::trashSession(each.file);
    if (!trashed) {
      reread();
      return showMessage(dataText(trashed.error().message), true);
    }
    trashed_.emplace_back(*trashed, each.file);
  }
  reread();
}

void SessionsPage::bringBack()
{
  for (const auto& [trashed, place] : trashed_) {
    const auto done = session::restoreSession(trashed, place);
    if (!done) return showMessage(dataText(done.error().message), true);
  }
  trashed_.clear();
  reread();
}

void SessionsPage::keyPressEvent(QKeyEvent* event)
{
  const int key = event->key();
  if (event->matches(QKeySequence::Find)) return search_->setFocus();
  if (event->matches(QKeySequence::Undo)) return bringBack();
  if (key == Qt::Key_Delete) return throwAway();
  if (key == Qt::Key_Return || key == Qt::Key_Enter) return replayChosen();
  QWidget::keyPressEvent(event);
}

}  // namespace perilymph::gui
