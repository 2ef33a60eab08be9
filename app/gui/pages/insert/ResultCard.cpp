// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/ResultCard.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "gui/report/InsertionOutcome.h"
#include "gui/report/InsertionResults.h"
#include "gui/text/ClinicalText.h"
#include "gui/text/DataText.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Theme.h"
#include "perilymph/planning/ContactsCsv.h"

namespace perilymph::gui {

namespace {

/// @param tone  Property that the style sheet colors: "quiet", "error"; "value" as usual.
QLabel* cell(const QString& text, const char* tone, QWidget* parent)
{
  auto* label = new QLabel(text, parent);
  label->setFont(typeface(13));
  label->setTextFormat(Qt::PlainText);
  label->setProperty(tone, true);
  return label;
}

}  // namespace

ResultCard::ResultCard(QWidget* page)
    : Overlay(page), title_(new QLabel(this)), subject_(new QLabel(this)), contacts_(std::string())
{
  setObjectName(QStringLiteral("resultCard"));
  title_->setObjectName(QStringLiteral("resultTitle"));
  title_->setFont(typeface(13, QFont::DemiBold));
  subject_->setFont(typeface(11));
  subject_->setTextFormat(Qt::PlainText);
  subject_->setWordWrap(true);
  subject_->setProperty("quiet", true);
  auto* close = panelButton(QStringLiteral("×"), "closeResultButton", this);
  close->setProperty("small", true);
  close->setFixedWidth(sized(28));
  close->setToolTip(tr("Close; the recording is kept"));
  close->setAccessibleName(tr("Close"));
  connect(close, &QPushButton::clicked, this, [this] {
    isClosed_ = true;
    hide();
  });
  auto* head = new QHBoxLayout;
  head->addWidget(title_, 1);
  head->addWidget(close);

  report_ = panelButton(tr("Report…"), "resultReportButton", this);
  report_->setToolTip(tr("Save a report of this insertion as PDF"));
  auto* send = panelButton(tr("Send…"), "resultSendButton", this);
  send->setToolTip(
      tr("Report of this insertion into the study of the patient’s CT, as DICOM to an archive"));
  auto* compare = panelButton(tr("Compare"), "resultCompareButton", this);
  compare->setToolTip(tr("Compare with the insertion before"));
  auto* contacts = panelButton(tr("Contacts…"), "resultContactsButton", this);
  contacts->setToolTip(
      tr("Save the contacts for whoever programs the processor, as CSV with a dictionary of its "
         "columns"));
  connect(contacts, &QPushButton::clicked, this, &ResultCard::saveContacts);
  auto* again = panelButton(tr("Again"), "resultAgainButton", this);
  again->setToolTip(tr("Insert once more, with a new recording"));
  connect(report_, &QPushButton::clicked, this, &ResultCard::reportRequested);
  connect(send, &QPushButton::clicked, this, &ResultCard::sendRequested);
  connect(compare, &QPushButton::clicked, this, &ResultCard::compareRequested);
  connect(again, &QPushButton::clicked, this, &ResultCard::againRequested);
  auto* verbs = new QHBoxLayout;
  verbs->setSpacing(spacing);
  for (QPushButton* verb : {report_, send, compare, contacts, again}) verbs->addWidget(verb);
  verbs->addStretch();

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * spacing, spacing, spacing, 2 * spacing);
  column->setSpacing(spacing);
  column->addLayout(head);
  column->addWidget(subject_);
  column->addLayout(verbs);
  hide();
}

void ResultCard::addRow(int row, const QString& name, const QString& value, const QString& plan,
                        bool isOutside, const QString& clinics, const QString& clinicsDetail)
{
  auto* grid = static_cast<QGridLayout*>(rows_->layout());
  grid->addWidget(cell(name, "quiet", rows_), row, 0);
  grid->addWidget(cell(value, "value", rows_), row, 1, Qt::AlignRight);
  if (!plan.isEmpty())
    grid->addWidget(cell(plan, isOutside ? "error" : "quiet", rows_), row, 2, Qt::AlignRight);
  if (clinics.isEmpty()) return;
  auto* report = cell(clinics, "quiet", rows_);
  report->setToolTip(clinicsDetail);
  grid->addWidget(report, row, 3, Qt::AlignRight);
}

void ResultCard::saveContacts()
{
  if (!contacts_) return subject_->setText(dataText(contacts_.error().message));
  const auto file = chooseContactFile(this, contactsOf_);
  if (!file) return;
  if (const auto written = writeContactTable(*file, *contacts_); !written)
    subject_->setText(dataText(written.error().message));
}

void ResultCard::show(const ReportContent& content, const QString& title)
{
  contactsOf_ = {false, content.scenario.patient(), content.scenario.arrayName(),
                 content.facts.startedUtc};
  contacts_ =
      planning::insertionContactsCsv(contactsOf_.array, content.scenario.array(), content.contacts);
  title_->setText(title);
  const QString mark = verdictMark(content.scenario.arrayName());
  QString array = QString::fromStdString(content.scenario.array().name);
  if (!mark.isEmpty()) array = tr("%1, %2").arg(array, mark);
  const QString doubts = deepestNotes(content).join(QStringLiteral("; "));
  subject_->setText(doubts.isEmpty() ? array : tr("%1: %2").arg(array, doubts));
  subject_->setToolTip(verdictNote(content.scenario.arrayName()));
  delete rows_;
  rows_ = new QWidget(this);
  auto* grid = new QGridLayout(rows_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(2 * spacing);
  grid->setVerticalSpacing(spacing / 2);
  int row = 0;
  const auto results = insertionResults(content);
  const bool hasClinics = std::ranges::any_of(
      results, [](const InsertionResult& each) { return !each.clinics.isEmpty(); });
  if (content.plan || hasClinics) {
    const QString plan =
        content.plan ? tr("%1, %2").arg(content.plan->name, content.plan->hold) : QString();
    addRow(row, {}, {}, plan, false, hasClinics ? tr("clinics report") : QString(),
           verdictNote(content.scenario.arrayName()));
    ++row;
  }
  for (const InsertionResult& result : results) {
    if (!result.isHeadline) continue;
    const QString plan = result.isOutside ? tr("outside %1").arg(result.plan) : result.plan;
    addRow(row, result.name, result.value, plan, result.isOutside, result.clinics,
           result.clinicsDetail);
    for (const int column : {0, 1})
      grid->itemAtPosition(row, column)->widget()->setToolTip(result.detail);
    ++row;
  }
  if (const auto& passed = content.passedStop) {
    grid->addWidget(cell(passedStopName(*passed), "quiet", rows_), row, 0);
    auto* place = cell(passedStopText(*passed), "value", rows_);
    place->setToolTip(
        tr("The greatest force at which the hands of plans stop. This insertion "
           "went on above it, so its depth, angle and contacts are not those that "
           "a plan or a clinic reports."));
    grid->addWidget(place, row, 1, 1, 3);
    ++row;
  }
  if (content.insertion.translocation)
    grid->addWidget(cell(ruptureText(*content.insertion.translocation), "error", rows_), row, 0, 1,
                    3);
  static_cast<QVBoxLayout*>(layout())->insertWidget(2, rows_);
  rows_->show();
  setVisible(!isClosed_);
  place();
}

void ResultCard::clear()
{
  isClosed_ = false;
  hide();
}

void ResultCard::place()
{
  layout()->activate();
  adjustSize();
  const QWidget& page = *parentWidget();
  move(page.width() - width() - spacing, page.height() - height() - spacing);
  raise();
}

}  // namespace perilymph::gui
