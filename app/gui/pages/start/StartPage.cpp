// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/start/StartPage.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "gui/pages/start/PatientForm.h"
#include "gui/pages/start/PatientSetup.h"
#include "gui/parts/Theme.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::gui {

namespace {

constexpr QSize cardSize{344, 372};
constexpr int minCardWidth_px = 296;
constexpr int pictureHeight_px = 232;
constexpr double pictureZoom = 1.9;  // the cochlea fills the central half of its picture

}  // namespace

StartCard::StartCard(const char* name, const QString& title, const QString& sentence,
                     const std::string& picture, QWidget* parent)
    : QPushButton(parent), title_(title), sentence_(sentence)
{
  setObjectName(QLatin1String(name));
  setAccessibleName(title);
  setAccessibleDescription(sentence);
  setCursor(Qt::PointingHandCursor);
  setFixedSize(cardSize);
  const QImage whole(QString::fromStdString(resource(picture).string()));
  if (whole.isNull()) return;
  const double ratio = devicePixelRatioF();
  const int width = int(whole.width() / pictureZoom);
  const int height = width * pictureHeight_px / cardSize.width();
  const QRect middle((whole.width() - width) / 2, (whole.height() - height) / 2, width, height);
  picture_ = QPixmap::fromImage(
      whole.copy(middle).scaled(QSize(cardSize.width(), pictureHeight_px) * ratio,
                                Qt::KeepAspectRatio, Qt::SmoothTransformation));
  picture_.setDevicePixelRatio(ratio);
}

QSize StartCard::sizeHint() const { return cardSize; }

void StartCard::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const bool isChosen = underMouse() || hasFocus();
  QPainterPath edge;
  edge.addRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 6, 6);
  painter.fillPath(edge, isDown() ? groundColor : panelColor);
  painter.save();
  painter.setClipPath(edge);
  painter.drawPixmap((width() - cardSize.width()) / 2, 0, picture_);
  painter.restore();
  painter.setPen(QPen(isChosen ? accentColor : lineColor, isChosen ? 2.0 : 1.0));
  painter.drawPath(edge);

  const QRect text = rect().adjusted(20, pictureHeight_px + 16, -20, -12);
  painter.setPen(textColor);
  painter.setFont(typeface(18, QFont::DemiBold));
  painter.drawText(text, Qt::AlignLeft | Qt::AlignTop, title_);
  painter.setPen(quietTextColor);
  painter.setFont(typeface(13));
  painter.drawText(text.adjusted(0, 34, 0, 0), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap,
                   sentence_);
}

StartPage::StartPage(QWidget* parent) : QWidget(parent), stages_(new QStackedWidget(this))
{
  setObjectName(QStringLiteral("startPage"));
  stages_->addWidget(cards());
  form_ = new PatientForm(stages_);
  auto* centered = new QWidget(stages_);
  auto* row = new QHBoxLayout(centered);
  row->addStretch();
  row->addWidget(form_, 0, Qt::AlignVCenter);
  row->addStretch();
  stages_->addWidget(centered);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(stages_);

  connect(patient_, &QPushButton::clicked, this, [this] {
    stages_->setCurrentIndex(1);
    form_->showError({});
    form_->setFocus();
  });
  connect(mean_, &QPushButton::clicked, this, [this] { beginShipped("mean-contour", false); });
  connect(demonstration_, &QPushButton::clicked, this,
          [this] { beginShipped("contour-published", true); });
  connect(form_, &PatientForm::leaveAsked, this, &StartPage::showCards);
  connect(form_, &PatientForm::patientGiven, this, &StartPage::beginPatient);
}

void StartPage::beginPatient(const anatomy::Patient& patient)
{
  const auto setup = setupOfPatient(patient);
  if (!setup) return showError(QString::fromStdString(setup.error().message));
  Q_EMIT setupChosen(*setup, SetupOrigin::Kind::own, false);
}

void StartPage::beginShipped(const std::string& name, bool isWatched)
{
  auto scenario = session::loadScenario(name);
  if (!scenario) return showError(QString::fromStdString(scenario.error().message));
  Q_EMIT setupChosen({*std::move(scenario), {}}, SetupOrigin::Kind::preset, isWatched);
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
      tr("Build the patient’s scala tympani from CT measurements: A, B and H, or cochlear duct "
         "length and round-window section. Each value is compared with the population."),
      "resources/pictures/anatomies/patient-small.png", page);
  mean_ = new StartCard("meanCard", tr("Average cochlea"),
                        tr("Average of 15 human cochleae. Insert automatically or with mouse and "
                           "keyboard and follow the insertion force."),
                        "resources/pictures/anatomies/mean.png", page);
  demonstration_ =
      new StartCard("demonstrationCard", tr("Watch a demo insertion"),
                    tr("A Contour array is inserted automatically into the published cochlea; the "
                       "published measurements are shown for comparison."),
                    "resources/pictures/anatomies/published.png", page);
  auto* row = new QHBoxLayout;
  row->setSpacing(3 * spacing);
  row->addStretch();
  for (StartCard* card : {patient_, mean_, demonstration_}) row->addWidget(card);
  row->addStretch();
  auto* foot = new QLabel(tr("Keys 1, 2 and 3 do the same. For research and training; not a "
                             "medical device."),
                          page);
  foot->setFont(typeface(11));
  foot->setProperty("quiet", true);

  auto* column = new QVBoxLayout(page);
  column->setSpacing(spacing);
  column->addStretch(3);
  column->addWidget(title, 0, Qt::AlignHCenter);
  column->addWidget(question, 0, Qt::AlignHCenter);
  column->addSpacing(3 * spacing);
  column->addLayout(row);
  column->addSpacing(spacing);
  column->addWidget(error_);
  column->addWidget(foot, 0, Qt::AlignHCenter);
  column->addStretch(4);
  return page;
}

void StartPage::resizeEvent(QResizeEvent* event)
{
  QWidget::resizeEvent(event);
  const int available = (width() - 10 * spacing) / 3;  // two gaps and margins
  const int wide = std::clamp(available, minCardWidth_px, cardSize.width());
  for (StartCard* card : {patient_, mean_, demonstration_}) card->setFixedWidth(wide);
}

void StartPage::showCards()
{
  stages_->setCurrentIndex(0);
  error_->hide();
  patient_->setFocus();
}

void StartPage::showError(const QString& sentence)
{
  error_->setText(sentence);
  error_->setVisible(!sentence.isEmpty());
  form_->showError(sentence);
}

void StartPage::keyPressEvent(QKeyEvent* event)
{
  const bool isAsking = stages_->currentIndex() == 1;
  if (isAsking && event->key() == Qt::Key_Escape) return showCards();
  if (!isAsking && event->key() == Qt::Key_1) return patient_->click();
  if (!isAsking && event->key() == Qt::Key_2) return mean_->click();
  if (!isAsking && event->key() == Qt::Key_3) return demonstration_->click();
  QWidget::keyPressEvent(event);
}

}  // namespace perilymph::gui
