// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/start/RecentWork.h"

#include <QDateTime>
#include <QFontMetrics>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <functional>
#include <stop_token>
#include <utility>

#include "gui/widgets/Theme.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::gui {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t maxListed = 3;
constexpr int linkWidth_px = 380;

QString dateOf(const session::SessionSummary& session)
{
  const auto utc = QDateTime::fromString(QString::fromStdString(session.startedUtc), Qt::ISODate);
  return utc.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm"));
}

QLabel* columnHeading(const QString& text, QWidget* parent)
{
  auto* label = new QLabel(text, parent);
  label->setFont(typeface(11, QFont::DemiBold));
  label->setProperty("quiet", true);
  return label;
}

QPushButton* addLink(QVBoxLayout& column, const QString& text, const QString& name, QWidget* parent)
{
  auto* link = new QPushButton(parent);
  link->setObjectName(name);
  link->setProperty("link", true);
  link->setFont(typeface(13));
  link->setText(
      QFontMetrics(link->font()).elidedText(text, Qt::ElideRight, sized(linkWidth_px) - 24));
  link->setAccessibleName(text);
  if (link->text() != text) link->setToolTip(text.toHtmlEscaped());
  link->setFixedHeight(sized(26));
  link->setCursor(Qt::PointingHandCursor);
  link->setFocusPolicy(Qt::TabFocus);
  column.addWidget(link, 0, Qt::AlignLeft);
  link->show();
  return link;
}

void clear(QVBoxLayout& column)
{
  while (QLayoutItem* item = column.takeAt(0)) {
    if (item->widget() != nullptr) {
      item->widget()->setParent(nullptr);
      item->widget()->deleteLater();  // one of them may be the sender
    }
    delete item;
  }
}

}  // namespace

RecentWork::RecentWork(QWidget* parent) : QWidget(parent), background_(this)
{
  setObjectName(QStringLiteral("recentWork"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6 * spacing);
  row->addStretch();
  for (QVBoxLayout** column : {&patients_, &recordings_}) {
    auto* side = new QWidget(this);
    side->setFixedWidth(sized(linkWidth_px));
    *column = new QVBoxLayout(side);
    (*column)->setContentsMargins(0, 0, 0, 0);
    (*column)->setSpacing(0);
    row->addWidget(side, 0, Qt::AlignTop);
  }
  row->addStretch();
}

void RecentWork::refresh(const QString& current, const std::optional<fs::path>& beingRecorded)
{
  clear(*patients_);
  auto patients = savedPatients();
  std::erase_if(patients, [](const SavedPatient& each) { return each.record.isArchived; });
  QWidget* left = patients_->parentWidget();
  if (!patients.empty()) patients_->addWidget(columnHeading(tr("RECENT PATIENTS"), left));
  for (std::size_t i = 0; i < std::min(patients.size(), maxListed); ++i) {
    const QString tags = tagsText(patients[i].record);
    const QString whole = tr("%1 · %2").arg(nameOfPatient(patients[i].patient),
                                            numbersOfPatient(patients[i].patient));
    auto* link = addLink(*patients_, tags.isEmpty() ? whole : tr("%1 · %2").arg(whole, tags),
                         QStringLiteral("recentPatient%1").arg(i), left);
    connect(link, &QPushButton::clicked, this,
            [this, patient = patients[i]] { Q_EMIT patientRequested(patient); });
  }
  if (!patients.empty())
    connect(addLink(*patients_, tr("All patients: search and edit"),
                    QStringLiteral("allPatientsButton"), left),
            &QPushButton::clicked, this, &RecentWork::allPatientsRequested);

  left->setVisible(!patients.empty());
  current_ = current;
  showInsertions();
  background_.run(
      "The list of the last insertions",
      [file = beingRecorded.value_or(fs::path())](const std::stop_token& stop) {
        return session::listSessions(sessionFolder(), file, {}, {}, stop);
      },
      [this](Result<std::vector<session::SessionSummary>> sessions) {
        if (!sessions) return;  // the page Recordings says why
        std::erase_if(*sessions, std::not_fn(session::isInsertion));
        insertions_ = *std::move(sessions);
        showInsertions();
      });
}

void RecentWork::showInsertions()
{
  clear(*recordings_);
  QWidget* right = recordings_->parentWidget();
  right->setVisible(!current_.isEmpty() || !insertions_.empty());
  if (!right->isVisibleTo(this)) return;
  recordings_->addWidget(columnHeading(tr("LAST INSERTIONS"), right));
  if (!current_.isEmpty())
    connect(addLink(*recordings_, tr("Continue: %1").arg(current_),
                    QStringLiteral("continueButton"), right),
            &QPushButton::clicked, this, &RecentWork::continueRequested);
  const std::size_t listed = std::min(insertions_.size(), maxListed - (current_.isEmpty() ? 0 : 1));
  for (std::size_t i = 0; i < listed; ++i) {
    const session::SessionSummary& each = insertions_[i];
    auto* link =
        addLink(*recordings_,
                tr("Replay %1 · %2")
                    .arg(QString::fromStdString(session::displayNameOf(each.file)), dateOf(each)),
                QStringLiteral("recentRecording%1").arg(i), right);
    connect(link, &QPushButton::clicked, this,
            [this, file = each.file] { Q_EMIT replayRequested(file); });
  }
  if (insertions_.empty()) return;
  connect(addLink(*recordings_, tr("All recorded insertions"),
                  QStringLiteral("allRecordingsButton"), right),
          &QPushButton::clicked, this, &RecentWork::allRecordingsRequested);
}

}  // namespace perilymph::gui
