// SPDX-License-Identifier: BSD-3-Clause
#include "gui/archive/ArchiveQuery.h"

#include <QDate>
#include <QGridLayout>
#include <QLineEdit>

#include "gui/widgets/CheckBoxes.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Placeholder.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"

namespace perilymph::gui {

namespace {

constexpr int fieldHeight_px = 26;
constexpr int longestTyped = 64;  // of LO, PS3.5
constexpr int fieldsOfRow = 3;

}  // namespace

std::optional<std::string> dicomDate(const QString& typed)
{
  for (const char* format : {"yyyy-MM-dd", "d.M.yyyy", "yyyyMMdd"})
    if (const QDate date = QDate::fromString(typed.trimmed(), QLatin1String(format));
        date.isValid() && date.year() > 1800)
      return date.toString(QStringLiteral("yyyyMMdd")).toStdString();
  return std::nullopt;
}

QString dateText(const std::string& dicom)
{
  const QString text = QString::fromStdString(dicom);
  const QDate date = QDate::fromString(text, QStringLiteral("yyyyMMdd"));
  if (text.isEmpty()) return QStringLiteral("–");
  return date.isValid() ? date.toString(QStringLiteral("yyyy-MM-dd")) : text;
}

ArchiveQuery::ArchiveQuery(QWidget* parent) : QWidget(parent)
{
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(spacing);
  grid->setVerticalSpacing(2);
  const QString date = tr("YYYY-MM-DD");
  number_ = add("archivePatientId", tr("Patient number"), tr("4711, 47*"));
  name_ = add("archivePatientName", tr("Patient name"), tr("Doe^Jane, Doe*"));
  birth_ = add("archiveBirthDate", tr("Birth date"), date);
  from_ = add("archiveFrom", tr("Study date from"), date);
  until_ = add("archiveUntil", tr("Study date until"), date);
  isCt_ = new CheckBox(tr("CT only"), this);
  isCt_->setObjectName(QStringLiteral("archiveIsCt"));
  isCt_->setFont(typeface(13));
  isCt_->setChecked(true);
  isCt_->setToolTip(tr("Some archives ignore this. Cone-beam scans are CT in DICOM, too."));
  grid->addWidget(isCt_, 3, 2);
  for (int column = 0; column < fieldsOfRow; ++column) grid->setColumnStretch(column, 1);
}

QLineEdit* ArchiveQuery::add(const char* name, const QString& caption, const QString& hint)
{
  auto* grid = static_cast<QGridLayout*>(layout());
  const int place = grid->count() / 2;
  auto* heading = panelHeading(caption, this);
  auto* field = new QLineEdit(this);
  field->setObjectName(QLatin1String(name));
  field->setAccessibleName(caption);
  field->setFont(typeface(13));
  field->setFixedHeight(sized(fieldHeight_px));
  field->setMaxLength(longestTyped);
  markPlaceholder(*field, hint);
  heading->setBuddy(field);
  grid->addWidget(heading, 2 * (place / fieldsOfRow), place % fieldsOfRow);
  grid->addWidget(field, 2 * (place / fieldsOfRow) + 1, place % fieldsOfRow);
  connect(field, &QLineEdit::returnPressed, this, &ArchiveQuery::submitted);
  return field;
}

Result<archive::StudyQuery> ArchiveQuery::query() const
{
  archive::StudyQuery query;
  query.patientId = number_->text().trimmed().toStdString();
  query.patientName = name_->text().trimmed().toStdString();
  for (const auto& [field, into] :
       {std::pair{birth_, &query.birthDate}, {from_, &query.from}, {until_, &query.until}}) {
    const QString typed = field->text().trimmed();
    if (typed.isEmpty()) continue;
    const auto date = dicomDate(typed);
    if (!date)
      return Error{"'%1' is no date. Type it as 1970-01-31 or 31.1.1970.", typed.toStdString()};
    *into = *date;
  }
  const bool hasCondition = !query.patientId.empty() || !query.patientName.empty() ||
                            !query.birthDate.empty() || !query.from.empty() || !query.until.empty();
  if (!hasCondition)
    return Error{
        "Type a patient number, a name, a birth date or a study date: without one the whole "
        "archive "
        "would be listed."};
  if (isCt_->isChecked()) query.modality = "CT";
  return query;
}

void ArchiveQuery::clear()
{
  for (QLineEdit* field : {number_, name_, birth_, from_, until_}) field->clear();
}

void ArchiveQuery::focusFirst() { number_->setFocus(); }

}  // namespace perilymph::gui
