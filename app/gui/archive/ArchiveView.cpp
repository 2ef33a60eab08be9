// SPDX-License-Identifier: BSD-3-Clause
#include "gui/archive/ArchiveView.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/archive/ArchiveQuery.h"
#include "gui/archive/FoundRows.h"
#include "gui/text/DataText.h"
#include "gui/text/TaskText.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Selector.h"
#include "gui/widgets/StatusLine.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"

namespace perilymph::gui {

namespace {

constexpr int pause_ms = 300;

}  // namespace

ArchiveView::ArchiveView(QWidget* parent, const QString& place)
    : QWidget(parent),
      work_(this),
      server_(new Selector("archiveServer", tr("Archive"), this)),
      query_(new ArchiveQuery(this)),
      studies_(new StudyRows(this)),
      series_(new SeriesRows(this)),
      find_(panelButton(tr("Find"), "archiveFindButton", this)),
      fetch_(panelButton(tr("Retrieve and measure"), "archiveFetchButton", this)),
      cancel_(panelButton(tr("Cancel"), "archiveCancelButton", this)),
      back_(panelButton(tr("Back"), "archiveBackButton", this)),
      edit_(panelButton(tr("Archives…"), "archiveServersButton", this)),
      progress_(new QProgressBar(this)),
      status_(new StatusLine("archiveStatus", this))
{
  setObjectName(QStringLiteral("archiveView"));
  back_->setToolTip(tr("Esc"));
  edit_->setToolTip(tr("Enter, change and test archives"));
  progress_->setTextVisible(false);
  progress_->setFixedHeight(6);
  progress_->setRange(0, 1000);
  // its text has room when it becomes the primary button, too
  fetch_->setMinimumWidth(fetch_->fontMetrics().horizontalAdvance(fetch_->text()) + 5 * spacing);
  pause_.setSingleShot(true);
  pause_.setInterval(pause_ms);

  auto* head = new QHBoxLayout;
  head->setSpacing(spacing);
  auto* title = new WrappedLabel(tr("From the archive"), this);
  title->setFont(typeface(15, QFont::DemiBold));
  head->addWidget(title, 1);
  head->addWidget(server_);
  head->addWidget(edit_);
  head->addWidget(back_);
  auto* verbs = new QHBoxLayout;
  verbs->setSpacing(spacing);
  verbs->addWidget(find_);
  verbs->addWidget(fetch_);
  verbs->addWidget(cancel_);
  verbs->addStretch();
  auto* content = new QWidget(this);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(2 * spacing, 2 * spacing, 2 * spacing, spacing);
  column->setSpacing(spacing);
  column->addLayout(head);
  column->addWidget(query_);
  column->addWidget(studies_, 3);
  column->addWidget(series_, 2);
  auto* foot = new QVBoxLayout;
  foot->setContentsMargins(2 * spacing, 0, 2 * spacing, spacing);
  foot->setSpacing(spacing);
  foot->addLayout(verbs);
  foot->addWidget(progress_);
  foot->addWidget(status_);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->addWidget(verticalScroll(content, this), 1);
  whole->addLayout(foot);  // stays in view

  connect(query_, &ArchiveQuery::submitted, this, &ArchiveView::find);
  connect(find_, &QPushButton::clicked, this, &ArchiveView::find);
  connect(fetch_, &QPushButton::clicked, this, &ArchiveView::fetch);
  connect(cancel_, &QPushButton::clicked, this, &ArchiveView::cancel);
  connect(back_, &QPushButton::clicked, this, &ArchiveView::leaveRequested);
  connect(edit_, &QPushButton::clicked, this, &ArchiveView::serversRequested);
  connect(studies_, &FoundTable::rowChosen, this, [this] {
    series_->show({});
    pause_.start();
  });
  connect(&pause_, &QTimer::timeout, this, &ArchiveView::findSeries);
  connect(series_, &FoundTable::rowChosen, this, &ArchiveView::showState);
  connect(series_, &FoundTable::rowOpened, this, &ArchiveView::fetch);
  connectWork();
  showState();
  if (place.isEmpty()) return;
  setObjectName(place + objectName());
  for (QWidget* each : findChildren<QWidget*>(QRegularExpression(QStringLiteral("^archive"))))
    each->setObjectName(place + each->objectName());
}

void ArchiveView::connectWork()
{
  connect(&work_, &ArchiveWork::progressed, this, [this](double fraction) {
    progress_->setValue(int(1000.0 * fraction));
    status_->showMessage(taskText(task_, fraction, 1e-3 * double(since_.elapsed())));
  });
  connect(&work_, &ArchiveWork::studiesFound, this,
          [this](const archive::Found<archive::FoundStudy>& found) {
            const int count = int(found.rows.size());
            studies_->show(found.rows);
            end(found.isCut
                    ? tr("The first %1 studies; the archive has more: narrow the query.").arg(count)
                : count == 0 ? tr("No study matches.")
                             : tr("%n studies", nullptr, count));
          });
  connect(&work_, &ArchiveWork::seriesFound, this,
          [this](const archive::Found<archive::FoundSeries>& found) {
            // the one that is most probably wanted comes first
            auto rows = found.rows;
            std::stable_partition(rows.begin(), rows.end(), [](const archive::FoundSeries& each) {
              return each.modality == "CT";
            });
            series_->show(std::move(rows));
            end(tr("Choose a series of thin slices with a bone kernel, and retrieve it."));
          });
  connect(&work_, &ArchiveWork::fetched, this, [this](const std::filesystem::path& folder) {
    end({});
    Q_EMIT fetched(folder);
  });
  connect(&work_, &ArchiveWork::failed, this, [this](const QString& sentence) {
    end(sentence.isEmpty() ? tr("Canceled.") : sentence, !sentence.isEmpty());
  });
}

void ArchiveView::enter()
{
  showServers();
  (servers_.empty() ? static_cast<QWidget*>(edit_) : server_)->setFocus();
  if (!servers_.empty()) query_->focusFirst();
}

void ArchiveView::leave()
{
  pause_.stop();
  cancel();
  query_->clear();
  studies_->show({});
  series_->show({});
  end({});
}

bool ArchiveView::cancel()
{
  pause_.stop();
  if (!work_.isBusy()) return false;
  work_.cancel();
  return true;
}

void ArchiveView::showServers()
{
  const QString before = server_->value();
  const auto read = archive::readServers();
  servers_ = read ? *read : std::vector<archive::Server>{};
  server_->clear();
  for (const archive::Server& each : servers_)
    server_->addChoice(QString::fromStdString(each.name), QString::fromStdString(each.name));
  if (const int index = server_->findData(before); index >= 0) server_->setCurrentIndex(index);
  server_->setVisible(!servers_.empty());
  if (!read)
    status_->showMessage(dataText(read.error().message), true);
  else if (servers_.empty())
    status_->showMessage(
        tr("No archive is entered yet. Press Archives… and ask its administrator "
           "for AE title, host and port."));
  else
    status_->showMessage({});
  showState();
}

const archive::Server* ArchiveView::server() const
{
  const int index = server_->currentIndex();
  return index >= 0 && index < int(servers_.size()) ? &servers_[std::size_t(index)] : nullptr;
}

void ArchiveView::find()
{
  const archive::Server* asked = server();
  if (asked == nullptr) return;
  const auto query = query_->query();
  if (!query) return end(dataText(query.error().message), true);
  pause_.stop();
  studies_->show({});
  series_->show({});
  pause_.stop();
  begin(tr("Asking the archive…"));
  work_.findStudies(*asked, *query);
}

void ArchiveView::findSeries()
{
  const archive::Server* asked = server();
  const archive::FoundStudy* study = studies_->chosen();
  if (asked == nullptr || study == nullptr) return;
  begin(tr("Asking for the series…"));
  work_.findSeries(*asked, study->uid);
}

void ArchiveView::fetch()
{
  const archive::Server* asked = server();
  const archive::FoundStudy* study = studies_->chosen();
  const archive::FoundSeries* series = series_->chosen();
  if (asked == nullptr || study == nullptr || series == nullptr || isBusy()) return;
  const auto place = folder_.placeOf(series->uid);
  if (!place) return end(dataText(place.error().message), true);
  std::error_code failed;
  if (std::filesystem::is_directory(*place, failed)) return fetched(*place);  // once is enough
  begin(tr("Retrieving the series…"));
  work_.fetch(*asked, {study->uid, series->uid}, *place);
}

void ArchiveView::begin(const QString& task)
{
  task_ = task;
  since_.start();
  progress_->setValue(0);
  status_->showMessage(task);
  showState();
  // the request begins after this
  progress_->show();
  cancel_->setEnabled(true);
  fetch_->setEnabled(false);
}

void ArchiveView::end(const QString& sentence, bool isError)
{
  status_->showMessage(sentence, isError);
  showState();
}

void ArchiveView::showState()
{
  const bool isBusy = work_.isBusy();
  progress_->setVisible(isBusy);
  cancel_->setEnabled(isBusy);
  find_->setEnabled(server() != nullptr);
  server_->setEnabled(!isBusy);
  fetch_->setEnabled(!isBusy && series_->chosen() != nullptr);
  const bool hasSeries = series_->chosen() != nullptr;
  setPrimary(*find_, !hasSeries);
  setPrimary(*fetch_, hasSeries);
}

}  // namespace perilymph::gui
