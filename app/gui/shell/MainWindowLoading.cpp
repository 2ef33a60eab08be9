// Which page is shown, and what the insertion page is about: its scenario and its cochlea.

#include <QStackedWidget>

#include "gui/pages/insert/BottomBar.h"
#include "gui/pages/insert/ForceCharts.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/pages/insert/ReplayPlayer.h"
#include "gui/pages/insert/SidePanel.h"
#include "gui/pages/start/StartPage.h"
#include "gui/scene/OperationView.h"
#include "gui/setup/SetupHistory.h"
#include "gui/shell/MainWindow.h"
#include "gui/shell/TopBar.h"
#include "perilymph/anatomy/Population.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::gui {

namespace {

QString patientText(const session::Scenario& scenario)
{
  const bool isLeft = scenario.patient.side == anatomy::Side::left;
  const bool isPatient = scenario.anatomy == "published" || scenario.patient.basalTurn;
  return (isPatient ? MainWindow::tr("Patient %1 · %2 ear") : MainWindow::tr("%1 anatomy · %2 ear"))
      .arg(QString::fromStdString(isPatient ? scenario.patient.label : scenario.anatomy),
           isLeft ? MainWindow::tr("left") : MainWindow::tr("right"));
}

/// The numbers of a patient that were not left as they are by default: measured, as the form says.
std::map<SetupField, ValueSource> measuredInCt(const anatomy::Patient& patient)
{
  const anatomy::Patient usual;
  std::map<SetupField, ValueSource> sources;
  const auto note = [&sources](SetupField field, bool isGiven) {
    if (isGiven) sources[field] = ValueSource::ct;
  };
  if (const auto& turn = patient.basalTurn) {
    note(SetupField::lengthA, turn->a != anatomy::spreadOfA().mean);
    note(SetupField::widthB, turn->b != anatomy::spreadOfB().mean);
    note(SetupField::heightH, turn->h.has_value());
    return sources;
  }
  note(SetupField::scalaLength, patient.scalaTympaniLength != usual.scalaTympaniLength);
  note(SetupField::windowWidth, patient.roundWindowWidth != usual.roundWindowWidth);
  note(SetupField::windowHeight, patient.roundWindowHeight != usual.roundWindowHeight);
  return sources;
}

}  // namespace

void MainWindow::showPage(Page page)
{
  top_->setPage(page);
  if (page == page_) return;
  if (page_ == Page::insert && safety_.leaveSight()) pause();
  page_ = page;
  pages_->setCurrentIndex(static_cast<int>(page));
  // on the first screen it is nobody's turn yet
  const bool isReplay = page == Page::insert && replay_->isOpen();
  top_->setPatient(page == Page::start ? QString()
                                       : patientText(isReplay ? replay_->playback().scenario()
                                                              : control_.scenario()));
  top_->setModified(page != Page::start && !isReplay && setup_->isModified(),
                    tr("Not the preset’s values: %1.").arg(setup_->changedText()));
  if (page == Page::start) {
    startPage_->showCards();
  } else {
    setFocus();
  }
  if (page == Page::sessions) showSessions();
}

Result<Done> MainWindow::open()
{
  const Result<Done> prepared = control_.prepare(InputSource::scripted);
  if (!prepared) return prepared;

  charts_->setExperiment(charts::publishedExperiment());
  showCochlea();
  showPrepared();
  sinceFrame_.start();
  sinceSlow_.start();
  timer_.start();
  return Done{};
}

void MainWindow::begin(const anatomy::Patient& patient)
{
  const auto fail = [this](const Error& error) {
    startPage_->showError(QString::fromStdString(error.message));
  };
  if (const auto possible = anatomy::checkPatient(patient); !possible)
    return fail(possible.error());
  const auto file = patientFolder() / fileNameOf(patient.label);
  std::error_code ignored;  // what cannot be made is said when the file is written
  std::filesystem::create_directories(file.parent_path(), ignored);
  if (const auto saved = anatomy::savePatient(patient, file); !saved) return fail(saved.error());
  const auto preset = session::loadScenario(
      patient.basalTurn ? "mean-contour" : "contour-published", {{"patient", file.string()}});
  if (!preset) return fail(preset.error());
  auto own = asOwn(*preset);
  if (!own) return fail(own.error());
  load({*std::move(own), measuredInCt(patient)}, SetupOrigin::Kind::own, AfterLoading::rest);
}

void MainWindow::beginShipped(const std::string& name, AfterLoading then)
{
  auto scenario = session::loadScenario(name);
  if (!scenario) return startPage_->showError(QString::fromStdString(scenario.error().message));
  load(*std::move(scenario), then);
}

void MainWindow::load(session::Scenario scenario, AfterLoading then)
{
  load({std::move(scenario), {}}, SetupOrigin::Kind::preset, then);
}

void MainWindow::load(const Setup& setup, SetupOrigin::Kind kind, AfterLoading then)
{
  pause();
  closeReplay();
  showPage(Page::insert);
  build(setup.scenario, [this, setup, kind, then](const InsertionControl::Parts& parts) {
    views_->forgetScene();
    control_.use(setup.scenario, parts);
    setup_->begin(setup, kind);
    showScenario();
    prepare(InputSource::scripted);
    showCochlea();
    if (then == AfterLoading::insert) start();
  });
}

void MainWindow::prepare(InputSource hand)
{
  error_.clear();
  pressed_.clear();
  const Result<Done> prepared = control_.prepare(hand);
  if (!prepared && hand == InputSource::device) {
    // A device that cannot be opened leaves the script as the hand.
    prepare(InputSource::scripted);
    return showError(QString::fromStdString(prepared.error().message));
  }
  if (!prepared) return showError(QString::fromStdString(prepared.error().message));
  showPrepared();
}

void MainWindow::showScenario()
{
  const session::Scenario& scenario = control_.scenario();
  setWindowTitle(tr("Perilymph · %1").arg(QString::fromStdString(scenario.name)));
  if (page_ != Page::start) top_->setPatient(patientText(scenario));
  top_->setModified(page_ != Page::start && setup_->isModified(),
                    tr("Not the preset’s values: %1.").arg(setup_->changedText()));
}

void MainWindow::showCochlea()
{
  views_->setScene(control_.anatomy(), control_.scenario());
  side_->announceParts();
  view_->showArray(control_.now());
}

void MainWindow::showPrepared()
{
  side_->setHand(control_.hand(), QString::fromStdString(control_.handName()));
  side_->setHeld(false);
  charts_->begin(control_.anatomy().entry());
  view_->showArray(control_.now());
  drawn_ = control_.now();
  showSlowly();
  Q_EMIT recordingChanged();
}

}  // namespace perilymph::gui
