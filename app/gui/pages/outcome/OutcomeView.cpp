// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/outcome/OutcomeView.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/pages/ct/PlaneView.h"
#include "gui/pages/outcome/FoundContacts.h"
#include "gui/pages/outcome/PlanBeside.h"
#include "gui/pages/plan/AngleRing.h"
#include "gui/setup/OutcomeWords.h"
#include "gui/setup/PatientHistory.h"
#include "gui/setup/PlannedFriction.h"
#include "gui/text/ChartLabels.h"
#include "gui/widgets/DrawingView.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/PlotView.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"

namespace perilymph::gui {

namespace {

constexpr int unrolledHeight_px = 132, tableHeight_px = 176, besideWidth_px = 470,
              besideRing_px = 230, besideForces_px = 220;
constexpr int contactsPlace = 0, besidePlace = 1;

}  // namespace

OutcomeView::OutcomeView(CtStudy& study, QWidget* parent)
    : QWidget(parent),
      study_(study),
      stages_(new QStackedWidget(this)),
      contactsStage_(panelButton(tr("Contacts in the CT"), "outcomeContactsStage", this)),
      besideStage_(panelButton(tr("Plan beside outcome"), "outcomeBesideStage", this)),
      head_(new WrappedLabel({}, this)),
      flags_(new WrappedLabel({}, this)),
      besideNote_(new WrappedLabel({}, this)),
      besideDoubt_(new WrappedLabel({}, this)),
      unrolled_(new PlotView(
          [this](double width, double height) {
            return unrolled(shownColorScheme(), width, height);
          },
          this)),
      table_(new FoundContacts(this)),
      beside_(new PlanBeside(this)),
      ring_(new AngleRing(this)),
      forces_(new DrawingView(this))
{
  setObjectName(QStringLiteral("outcomeView"));
  head_->setObjectName(QStringLiteral("outcomeHead"));
  head_->setFont(typeface(13, QFont::DemiBold));
  flags_->setObjectName(QStringLiteral("outcomeFlags"));
  flags_->setFont(typeface(12));
  flags_->setTextFormat(Qt::PlainText);
  flags_->setProperty("error", true);
  auto* group = new QButtonGroup(this);
  auto* choices = new QHBoxLayout;
  choices->setSpacing(spacing);
  for (QPushButton* each : {contactsStage_, besideStage_}) {
    each->setCheckable(true);
    each->setProperty("page", true);
    group->addButton(each);
    choices->addWidget(each);
  }
  contactsStage_->setChecked(true);
  choices->addStretch();
  connect(contactsStage_, &QPushButton::clicked, this, [this] { showPlanBeside(false); });
  connect(besideStage_, &QPushButton::clicked, this, [this] { showPlanBeside(true); });
  stages_->addWidget(addContacts());
  stages_->addWidget(addBeside());
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(spacing, spacing, spacing, spacing);
  column->setSpacing(spacing);
  column->addWidget(head_);
  column->addWidget(flags_);
  column->addLayout(choices);
  column->addWidget(stages_, 1);
  show(nullptr, {}, {}, {});
}

OutcomeView::~OutcomeView() = default;

QWidget* OutcomeView::addContacts()
{
  auto* page = new QWidget(this);
  for (std::size_t k = 0; k < planes_.size(); ++k) {
    planes_[k] = new PlaneView(study_, k, page);
    planes_[k]->setObjectName(QStringLiteral("outcomePlane%1").arg(k));
    connect(planes_[k], &PlaneView::contactMoved, this, &OutcomeView::contactMoved);
  }
  auto* sections = new QVBoxLayout;
  sections->setSpacing(1);
  sections->addWidget(planes_[1], 1);
  sections->addWidget(planes_[2], 1);
  auto* pictures = new QHBoxLayout;
  pictures->setSpacing(1);
  pictures->addWidget(planes_[0], 3);
  pictures->addLayout(sections, 2);
  unrolled_->setObjectName(QStringLiteral("outcomeUnrolled"));
  unrolled_->setAccessibleName(tr("Unrolled scala tympani with the contacts and the plan’s bands"));
  unrolled_->setToolTip(tr(
      "Contacts by number, with the intervals of their angles; hollow: placed by spacing; diamond: "
      "more likely above the basilar membrane. Bars at the modiolus: the plan’s bands; across the "
      "scala: that of the most apical contact."));
  unrolled_->setFixedHeight(sized(unrolledHeight_px));
  table_->setFixedHeight(sized(tableHeight_px));
  connect(table_, &FoundContacts::contactChosen, &study_, &CtStudy::chooseContact);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  column->addLayout(pictures, 1);
  column->addWidget(unrolled_);
  column->addWidget(table_);
  return page;
}

QWidget* OutcomeView::addBeside()
{
  auto* page = new QWidget(this);
  beside_->setMinimumWidth(sized(besideWidth_px));
  besideNote_->setObjectName(QStringLiteral("outcomePlanNote"));
  besideNote_->setFont(typeface(12));
  besideNote_->setProperty("quiet", true);
  besideDoubt_->setObjectName(QStringLiteral("outcomePlanDoubt"));
  besideDoubt_->setFont(typeface(12));
  besideDoubt_->setProperty("error", true);
  forces_->setObjectName(QStringLiteral("outcomeForces"));
  forces_->setAccessibleName(tr(
      "Force over depth: insertion by hand, the plan’s band, the length inserted in the patient"));
  ring_->setFixedHeight(sized(besideRing_px));
  forces_->setMinimumHeight(sized(besideForces_px));
  auto* left = new QVBoxLayout;
  left->setSpacing(spacing);
  left->addWidget(besideNote_);
  left->addWidget(besideDoubt_);
  left->addWidget(beside_, 1);
  auto* right = new QVBoxLayout;
  right->setSpacing(spacing);
  right->addWidget(ring_);
  right->addWidget(forces_, 1);
  auto* row = new QHBoxLayout(page);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(spacing);
  row->addLayout(left, 1);
  row->addLayout(right, 1);
  return verticalScroll(page, this);  // low screens
}

void OutcomeView::showPlanBeside(bool isShown)
{
  (isShown ? besideStage_ : contactsStage_)->setChecked(true);
  stages_->setCurrentIndex(isShown ? besidePlace : contactsPlace);
}

void OutcomeView::show(const std::shared_ptr<const outcome::FoundArray>& found,
                       const PlannedEar& planned, const QString& planDoubt,
                       const QStringList& doubts)
{
  found_ = found;
  planned_ = planned;
  besideStage_->setEnabled(found != nullptr);
  const QStringList sentences = found ? doubts + flagTexts(*found) : QStringList();
  flags_->setText(sentences.join(QLatin1Char('\n')));
  flags_->setVisible(!sentences.isEmpty());
  unrolled_->refresh();
  if (!found) {
    head_->setText(tr("The CT after surgery"));
    table_->show({});
    study_.setContacts({});
    showPlanBeside(false);
    return;
  }
  head_->setText(tr("%1: %2, contacts inside %3, inserted %4; %5.")
                     .arg(arrayTitle(found->array), depthText(*found), insideText(*found),
                          insertedText(*found), earSourceText(*found)));
  table_->show(found->contacts);
  std::vector<CtStudy::Contact> contacts;
  for (const outcome::FoundContact& each : found->contacts)
    contacts.push_back({each.number, each.position_P, each.isByHand, each.isSeenSingly});
  study_.setContacts(std::move(contacts));
  const planning::ArrayPlan* plan = planned.arrayPlan();
  beside_->show(plan, planned.ends, *found);
  besideNote_->setText(
      plan ? tr("Plan of %1, %2 simulations; bands: %3")
                 .arg(localTimeText(planned.planMadeUtc))
                 .arg(plan->draws)
                 .arg(bandsHold(planned.plan->plan))
           : tr("There is no plan of this array for this patient. The page Plan makes one."));
  besideDoubt_->setText(plan ? planDoubt : QString());
  besideDoubt_->setVisible(!besideDoubt_->text().isEmpty());
  std::vector<FoundAngle> angles;
  for (const outcome::FoundContact& each : found->contacts) {
    const auto interval = each.angle_deg.interval95();
    if (each.isInside) angles.push_back({each.angle_deg.value, interval[0], interval[1]});
  }
  ring_->show(plan ? plan->contacts : std::vector<planning::ContactBand>(), found->side,
              std::move(angles));
  const auto figure = forceBeside(planned, *found);
  forces_->setVisible(figure.has_value());
  if (figure) forces_->show(figures::draw(*figure));
}

void OutcomeView::setStale(bool isStale)
{
  for (QWidget* each : {static_cast<QWidget*>(head_), static_cast<QWidget*>(table_),
                        static_cast<QWidget*>(beside_)})
    each->setEnabled(!isStale);
}

figures::Drawing OutcomeView::unrolled(figures::ColorScheme scheme, double width,
                                       double height) const
{
  if (!planned_.scala) return {};
  std::vector<charts::FoundPlace> places;
  std::vector<charts::PlannedPlace> bands;
  if (found_)
    for (const outcome::FoundContact& each : found_->contacts) {
      const auto interval = each.angle_deg.interval95();
      if (each.isInside)
        places.push_back({each.number, each.angle_deg.value, interval[0], interval[1],
                          each.modiolus_mm, each.isSeenSingly || each.isByHand,
                          each.inScalaTympani < 0.5});
    }
  if (const planning::ArrayPlan* plan = planned_.arrayPlan())
    for (const planning::ContactBand& each : plan->contacts)
      if (each.draws > 0)
        bands.push_back({each.angle_deg.low, each.angle_deg.median, each.angle_deg.high});
  return charts::UnrolledScala(*planned_.scala, chartStyle(scheme))
      .drawFound(places, bands, width, height);
}

figures::Drawing OutcomeView::unrolledOnPaper(double width, double height) const
{
  return unrolled(figures::ColorScheme::light, width, height);
}

QImage OutcomeView::picture() const { return planes_[0]->grab().toImage(); }

}  // namespace perilymph::gui
