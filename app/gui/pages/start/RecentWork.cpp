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
#include <chrono>
#include <system_error>
#include <utility>

#include "gui/widgets/Theme.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t maxListed = 3;
constexpr int linkWidth_px = 380;

struct Recorded {
  fs::path file;
  qint64
      time_ms;  ///< Since 1970: when it began, which its name states; else when it was changed last.
};

qint64 timeOf_ms(const fs::path& file, fs::file_time_type changed)
{
  const auto utc =
      QDateTime::fromString(QString::fromStdString(session::startedUtcOf(file)), Qt::ISODate);
  if (utc.isValid()) return utc.toMSecsSinceEpoch();
  const auto before = fs::file_time_type::clock::now() - changed;
  return QDateTime::currentMSecsSinceEpoch() -
         std::chrono::duration_cast<std::chrono::milliseconds>(before).count();
}

/// The newest recordings, without being read.
std::vector<Recorded> newestRecordings(const std::optional<fs::path>& beingRecorded)
{
  std::vector<Recorded> found;
  std::error_code failure;
  fs::directory_iterator entries(sessionFolder(), failure);
  if (failure) return found;  // nothing was recorded yet
  for (const fs::directory_entry& entry : entries) {
    if (entry.path().extension() != ".insertion" || entry.path() == beingRecorded) continue;
    const auto time = entry.last_write_time(failure);
    if (!failure) found.push_back({entry.path(), timeOf_ms(entry.path(), time)});
  }
  const std::size_t kept = std::min(found.size(), maxListed);
  std::partial_sort(
      found.begin(), found.begin() + std::ptrdiff_t(kept), found.end(),
      [](const Recorded& one, const Recorded& other) { return one.time_ms > other.time_ms; });
  found.resize(kept);
  return found;
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

RecentWork::RecentWork(QWidget* parent) : QWidget(parent)
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
  clear(*recordings_);
  auto patients = savedPatients();
  std::erase_if(patients, [](const SavedPatient& each) { return each.record.isArchived; });
  QWidget* left = patients_->parentWidget();
  QWidget* right = recordings_->parentWidget();
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

  const auto recordings = newestRecordings(beingRecorded);
  if (!current.isEmpty() || !recordings.empty())
    recordings_->addWidget(columnHeading(tr("LAST INSERTIONS"), right));
  if (!current.isEmpty())
    connect(addLink(*recordings_, tr("Continue: %1").arg(current), QStringLiteral("continueButton"),
                    right),
            &QPushButton::clicked, this, &RecentWork::continueRequested);
  const std::size_t listed = std::min(recordings.size(), maxListed - (current.isEmpty() ? 0 : 1));
  for (std::size_t i = 0; i < listed; ++i) {
    auto* link =
        addLink(*recordings_,
                tr("Replay %1 · %2")
                    .arg(QString::fromStdString(session::displayNameOf(recordings[i].file)),
                         QDateTime::fromMSecsSinceEpoch(recordings[i].time_ms)
                             .toString(QStringLiteral("yyyy-MM-dd HH:mm"))),
                QStringLiteral("recentRecording%1").arg(i), right);
    connect(link, &QPushButton::clicked, this,
            [this, file = recordings[i].file] { Q_EMIT replayRequested(file); });
  }
  if (!recordings.empty())
    connect(addLink(*recordings_, tr("All recorded insertions"),
                    QStringLiteral("allRecordingsButton"), right),
            &QPushButton::clicked, this, &RecentWork::allRecordingsRequested);
  left->setVisible(!patients.empty());
  right->setVisible(!current.isEmpty() || !recordings.empty());
}

}  // namespace perilymph::gui
