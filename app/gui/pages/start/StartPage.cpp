// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/start/StartPage.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QScrollArea>
#include <QShortcut>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "gui/pages/start/PatientForm.h"
#include "gui/pages/start/PatientPicker.h"
#include "gui/pages/start/RecentWork.h"
#include "gui/run/InsertionControl.h"
#include "gui/setup/PatientHistory.h"
#include "gui/setup/PatientLibrary.h"
#include "gui/setup/PatientSetup.h"
#include "gui/setup/SetupTitle.h"
#include "gui/text/DataText.h"
#include "gui/widgets/FocusRing.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Theme.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::gui {

namespace {

constexpr QSize cardSize{344, 372};
constexpr int minCardWidth_px = 296;
constexpr int pictureHeight_px = 232;
constexpr int minPictureHeight_px = 120;
constexpr int cardMargin_px = 20, titleTop_px = 16, titleGap_px = 12, textBottom_px = 16;
constexpr int maxHeight_px = 10'000;
constexpr int aroundCards_px = 270;  // title, recent work, foot and margins
// Indices of the stages.
constexpr int cardsStage = 0, formStage = 1, pickerStage = 2;

/// A picture with a dark ground for the light scheme: the same hues with the opposite lightness, and
/// its ground, the color of its corner, as that of the card.
QImage onLight(const QImage& dark)
{
  QImage light = dark.convertToFormat(QImage::Format_RGB32);
  const double ground = light.pixelColor(0, 0).lightnessF(), card = shownTheme().panel.lightnessF();
  for (int y = 0; y < light.height(); ++y)
    for (int x = 0; x < light.width(); ++x) {
      const QColor color = light.pixelColor(x, y);
      const double lightness = card * (1.0 - color.lightnessF()) / (1.0 - ground);
      light.setPixelColor(
          x, y,
          QColor::fromHslF(std::max(0.0f, float(color.hslHueF())), float(color.hslSaturationF()),
                           float(std::min(lightness, card))));
    }
  return light;
}

}  // namespace

StartCard::StartCard(const char* name, const QString& title, const QString& sentence,
                     const std::string& picture, Ground ground, QWidget* parent)
    : QPushButton(parent), pictureHeight_px_(pictureHeight_px), title_(title), sentence_(sentence)
{
  setObjectName(QLatin1String(name));
  setAccessibleName(title);
  setAccessibleDescription(sentence);
  setCursor(Qt::PointingHandCursor);
  setFixedSize(cardSize);
  const QImage whole(QString::fromStdString(resource("resources/start/" + picture).string()));
  if (whole.isNull()) return;
  const double ratio = devicePixelRatioF();
  const QImage fitted = whole.scaled(QSize(cardSize.width(), pictureHeight_px) * ratio,
                                     Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
  const bool isInverted = ground == Ground::ofTheme && shownColorScheme() == ColorScheme::light;
  picture_ = QPixmap::fromImage(isInverted ? onLight(fitted) : fitted);
  picture_.setDevicePixelRatio(ratio);
}

QSize StartCard::sizeHint() const { return cardSize; }

int StartCard::titleHeight(int width_px) const
{
  const QRect available(0, 0, width_px - 2 * cardMargin_px, maxHeight_px);
  const QFontMetrics metrics(typeface(18, QFont::DemiBold));
  return metrics.boundingRect(available, Qt::TextWordWrap, title_).height() + titleGap_px;
}

int StartCard::textHeight(int width_px) const
{
  const QRect available(0, 0, width_px - 2 * cardMargin_px, maxHeight_px);
  const QRect sentence =
      QFontMetrics(typeface(13)).boundingRect(available, Qt::TextWordWrap, sentence_);
  return titleTop_px + titleHeight(width_px) + sentence.height() + textBottom_px;
}

void StartCard::setHeights(int picture_px, int text_px)
{
  pictureHeight_px_ = picture_px;
  setFixedHeight(picture_px + text_px);
  update();
}

void StartCard::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath edge;
  edge.addRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 6, 6);
  painter.fillPath(edge, isDown()       ? shownTheme().ground
                         : underMouse() ? shownTheme().raised
                                        : shownTheme().panel);
  painter.save();
  QPainterPath top;
  top.addRect(0, 0, width(), pictureHeight_px_);
  painter.setClipPath(edge.intersected(top));
  const QSizeF whole = QSizeF(cardSize.width(), pictureHeight_px)
                           .scaled(width(), pictureHeight_px_, Qt::KeepAspectRatioByExpanding);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawPixmap(
      QRectF({0.5 * (width() - whole.width()), 0.5 * (pictureHeight_px_ - whole.height())}, whole),
      picture_, QRectF({}, QSizeF(picture_.size())));
  painter.restore();
  painter.setPen(QPen(shownTheme().line, 1.0));
  painter.drawPath(edge);
  if (hasFocus()) paintFocusRing(painter, rect());  // the mouse only raises a card

  const QRect text =
      rect().adjusted(cardMargin_px, pictureHeight_px_ + titleTop_px, -cardMargin_px, 0);
  painter.setPen(shownTheme().text);
  painter.setFont(typeface(18, QFont::DemiBold));
  painter.drawText(text, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, title_);
  painter.setPen(shownTheme().quietText);
  painter.setFont(typeface(13));
  painter.drawText(text.adjusted(0, titleHeight(width()), 0, 0),
                   Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, sentence_);
}

StartPage::StartPage(const InsertionControl& control, const SetupHistory& setup, QWidget* parent)
    : Page("start", tr("Start page"), Icon::home, parent),
      control_(control),
      setup_(setup),
      stages_(new QStackedWidget(this))
{
  stages_->addWidget(verticalScroll(cards(), stages_));
  form_ = new PatientForm(control.cochleae(), stages_);
  stages_->addWidget(centered(form_));
  picker_ = new PatientPicker(stages_);
  stages_->addWidget(centered(picker_));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(stages_);

  connect(patient_, &QPushButton::clicked, this, &StartPage::showNewPatient);
  connect(mean_, &QPushButton::clicked, this,
          [this] { beginShipped("mean-contour", AfterLoading::rest); });
  connect(demonstration_, &QPushButton::clicked, this,
          [this] { beginShipped("contour-published", AfterLoading::insert); });
  connect(form_, &PatientForm::leaveRequested, this, [this] { showCards(); });
  connect(form_, &PatientForm::patientGiven, this, &StartPage::savePatient);
  connect(form_, &PatientForm::ctRequested, this,
          [this](const QString& code) { Q_EMIT ctRequested({code}); });
  connect(picker_, &PatientPicker::leaveRequested, this, [this] { showCards(); });
  connect(picker_, &PatientPicker::openRequested, this, &StartPage::openPatient);
  connect(picker_, &PatientPicker::editRequested, this, [this](const SavedPatient& patient) {
    form_->beginEditing(patient.patient, patient.file);
    stages_->setCurrentIndex(formStage);
    form_->setFocus();
  });
  connect(picker_, &PatientPicker::entryRequested, this, &StartPage::openEntry);
  connect(recent_, &RecentWork::patientRequested, this, &StartPage::openPatient);
  connect(recent_, &RecentWork::allPatientsRequested, this, &StartPage::showPatients);
  connect(recent_, &RecentWork::continueRequested, this,
          [this] { Q_EMIT pageRequested(QStringLiteral("insert")); });
  connect(recent_, &RecentWork::replayRequested, this, &StartPage::replayRequested);
  connect(recent_, &RecentWork::allRecordingsRequested, this,
          [this] { Q_EMIT pageRequested(QStringLiteral("sessions")); });
}

QWidget* StartPage::centered(QWidget* content)
{
  auto* page = new QWidget(stages_);
  auto* row = new QHBoxLayout(page);
  row->addStretch(1);
  row->addWidget(content, 1000);  // up to its maximum width
  row->addStretch(1);
  return verticalScroll(page, stages_);
}

void StartPage::addKey(QWidget& page, Qt::Key key, StartCard& card)
{
  // wherever the focus is, as long as the cards are shown
  connect(new QShortcut(key, &page), &QShortcut::activated, &card, &QAbstractButton::click);
}

void StartPage::showPatients()
{
  Q_EMIT pageRequested(id());
  picker_->refresh(control_.openRecording().value_or(std::filesystem::path()));
  stages_->setCurrentIndex(pickerStage);
  picker_->setFocus();
}

void StartPage::showNewPatient()
{
  Q_EMIT pageRequested(id());
  form_->beginNew();
  stages_->setCurrentIndex(formStage);
  form_->setFocus();
}

void StartPage::savePatient(const anatomy::Patient& patient)
{
  const auto file = savePatientInLibrary(patient, form_->edited());
  if (!file) return showError(dataText(file.error().message));
  openPatient({patient, *file});
}

void StartPage::openPatient(const SavedPatient& patient)
{
  markUsed(patient.file);
  beginPatient(patient.patient);
}

void StartPage::openEntry(const HistoryEntry& entry)
{
  switch (entry.kind) {
    case HistoryEntry::Kind::scan:
      return ctRequested(entry.scan);
    case HistoryEntry::Kind::plan:
      return pageRequested(QStringLiteral("plan"), entry.place);
    case HistoryEntry::Kind::insertion:
      return replayRequested(entry.place);
    case HistoryEntry::Kind::outcome:
      return outcomeRequested(entry.place, entry.outcome);
  }
}

void StartPage::beginPatient(const anatomy::Patient& patient)
{
  const auto setup = setupOfPatient(patient);
  if (!setup) return showError(dataText(setup.error().message));
  Q_EMIT insertionRequested({*setup});
}

void StartPage::beginShipped(const std::string& name, AfterLoading then)
{
  auto scenario = session::loadScenario(name);
  if (!scenario) return showError(dataText(scenario.error().message));
  Q_EMIT insertionRequested({{*std::move(scenario), {}}, SetupOrigin::Kind::preset, then});
}

QWidget* StartPage::cards()
{
  auto* page = new QWidget(stages_);
  auto* title = new QLabel(tr("Electrode array insertion"), page);
  title->setFont(typeface(28, QFont::Light));
  auto* question = new QLabel(tr("Choose an anatomy"), page);
  question->setFont(typeface(15));
  question->setProperty("quiet", true);
  error_ = new QLabel(page);
  error_->setFont(typeface(13));
  error_->setWordWrap(true);
  error_->setAlignment(Qt::AlignCenter);
  error_->setProperty("error", true);
  error_->hide();

  patient_ = new StartCard(
      "patientCard", tr("New patient"),
      tr("Measure the patient’s CT, or enter A, B and H. Each value is compared with the "
         "population."),
      "patient.png", StartCard::Ground::own, page);
  mean_ = new StartCard("meanCard", tr("Average cochlea"),
                        tr("Average of 15 human cochleae. Insert automatically or with mouse and "
                           "keyboard and follow the insertion force."),
                        "mean.png", StartCard::Ground::ofTheme, page);
  demonstration_ =
      new StartCard("demonstrationCard", tr("Watch a demo insertion"),
                    tr("A Contour array is inserted automatically into the published cochlea; the "
                       "published measurements are shown for comparison."),
                    "demonstration.png", StartCard::Ground::ofTheme, page);
  auto* row = new QHBoxLayout;
  row->setSpacing(3 * spacing);
  row->addStretch();
  for (StartCard* card : {patient_, mean_, demonstration_}) row->addWidget(card);
  row->addStretch();
  addKey(*page, Qt::Key_1, *patient_);
  addKey(*page, Qt::Key_2, *mean_);
  addKey(*page, Qt::Key_3, *demonstration_);
  recent_ = new RecentWork(page);
  auto* foot = new QLabel(tr("Keys 1, 2 and 3 do the same. For research and training; not a "
                             "medical device."),
                          page);
  foot->setFont(typeface(11));
  foot->setProperty("quiet", true);

  auto* column = new QVBoxLayout(page);
  column->setSpacing(spacing);
  column->addStretch(2);
  column->addWidget(title, 0, Qt::AlignHCenter);
  column->addWidget(question, 0, Qt::AlignHCenter);
  column->addSpacing(3 * spacing);
  column->addLayout(row);
  column->addSpacing(spacing);
  column->addWidget(recent_);
  column->addWidget(error_);
  column->addWidget(foot, 0, Qt::AlignHCenter);
  column->addStretch(2);
  return page;
}

void StartPage::resizeEvent(QResizeEvent* event)
{
  QWidget::resizeEvent(event);
  const int available = (width() - 10 * spacing) / 3;  // two gaps and margins
  const int wide =
      std::clamp(available, std::min(minCardWidth_px, sized(minCardWidth_px)), cardSize.width());
  int text = 0;
  for (StartCard* card : {patient_, mean_, demonstration_})
    text = std::max(text, card->textHeight(wide));
  const int high =
      std::clamp(height() - sized(aroundCards_px) - text, minPictureHeight_px, pictureHeight_px);
  for (StartCard* card : {patient_, mean_, demonstration_}) {
    card->setFixedWidth(wide);
    card->setHeights(high, text);
  }
}

void StartPage::showCards()
{
  recent_->refresh(currentWork(control_, setup_), control_.openRecording());
  stages_->setCurrentIndex(cardsStage);
  error_->hide();
  patient_->setFocus();
}

void StartPage::showError(const QString& sentence)
{
  error_->setText(sentence);
  error_->setVisible(!sentence.isEmpty());
  form_->showError(sentence);
}

bool StartPage::cancel()
{
  if (stages_->currentIndex() == cardsStage) return false;
  showCards();
  return true;
}

}  // namespace perilymph::gui
