// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/CtPage.h"

#include <QFileDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QStackedLayout>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/archive/ArchiveView.h"
#include "gui/archive/SendDialog.h"
#include "gui/pages/ct/CtPanel.h"
#include "gui/pages/ct/CtParts.h"
#include "gui/pages/ct/CtSeriesList.h"
#include "gui/pages/ct/CtSource.h"
#include "gui/pages/ct/CtText.h"
#include "gui/pages/ct/InsertedArray.h"
#include "gui/pages/ct/MarkupBar.h"
#include "gui/pages/ct/MeasuredSetup.h"
#include "gui/pages/ct/PlaneView.h"
#include "gui/pages/ct/RecentScans.h"
#include "gui/pages/ct/SurfaceView.h"
#include "gui/run/ScenarioApproach.h"
#include "gui/setup/CtKeyImages.h"
#include "gui/setup/KeyImage.h"
#include "gui/setup/MeasureVersions.h"
#include "gui/setup/PatientLibrary.h"
#include "gui/setup/ScanFolders.h"
#include "gui/setup/VersionQuestion.h"
#include "gui/text/DataText.h"
#include "gui/text/TaskText.h"
#include "gui/widgets/EmptyPage.h"
#include "gui/widgets/Theme.h"
#include "perilymph/anatomy/Surface.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/imaging/Landmarks.h"
#include "perilymph/imaging/MarkupFiles.h"
#include "perilymph/imaging/MeasuredPatient.h"
#include "perilymph/imaging/MeasuredPicture.h"
#include "perilymph/imaging/MeasuredSurface.h"
#include "perilymph/imaging/PlanFiles.h"
#include "perilymph/session/PatientRecord.h"

namespace perilymph::gui {

namespace {

// The planes keep more than half of it beside a panel of two columns.
constexpr int wideFrom_px = 1200;

constexpr int emptyStage = 0, pictureStage = 1;

QString notThere(const CtRequest& request)
{
  if (request.code.isEmpty())
    return CtPage::tr("The CT is no longer where it was read. Open its folder here.");
  return CtPage::tr(
             "The CT in which %1 was measured is no longer where it was read, or was never read "
             "on this computer. Open its folder here.")
      .arg(request.code);
}

}  // namespace

CtPage::CtPage(const InsertionControl& control, QWidget* parent)
    : Page("ct", tr("CT"), Icon::ct, parent),
      control_(control),
      bone_(study_, this),
      work_(this),
      thumbnails_(this),
      panel_(new CtPanel(study_, this)),
      stages_(new QStackedLayout),
      pictures_(new QWidget(this)),
      markupBar_(new MarkupBar(study_, pictures_)),
      archive_(new ArchiveView(this)),
      surface_(new SurfaceView(study_, bone_, pictures_))
{
  auto* grid = new QGridLayout;
  grid->setSpacing(1);
  auto* column = new QVBoxLayout(pictures_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(markupBar_);
  column->addLayout(grid, 1);
  for (std::size_t k = 0; k < views_.size(); ++k) {
    views_[k] = new PlaneView(study_, k, pictures_);
    connect(views_[k], &PlaneView::maximizeRequested, this, [this, k] { maximize(views_[k]); });
    connect(views_[k], &PlaneView::markPlaced, this, [this] {
      for (PlaneView* view : views_) view->setPlaced({});
      panel_->showMark({});
    });
    connect(views_[k], &PlaneView::chosen, this, [this, k] { active_ = views_[k]; });
    connect(views_[k], &PlaneView::refused, this,
            [this](const QString& sentence) { panel_->showIdle(sentence, true); });
  }
  grid->addWidget(views_[0], 0, 0);
  grid->addWidget(views_[1], 0, 1);
  grid->addWidget(surface_, 1, 0);
  grid->addWidget(views_[2], 1, 1);
  connect(surface_, &SurfaceView::maximizeRequested, this, [this] { maximize(surface_); });

  auto* page = new EmptyPage(tr("A patient’s CT"),
                             tr("Open a folder with a temporal-bone CT, or drop it here. The "
                                "cochlea is found and measured; then insert into it."),
                             this);
  page->offer(tr("Open folder…"));
  page->offerAlso(tr("From the archive…"));
  auto* recent = new RecentScans(page);
  page->offerMenu(tr("Recent CTs"), recent);
  connect(recent, &RecentScans::chosen, this, &CtPage::begin);
  connect(page, &EmptyPage::actionRequested, &panel_->source(), &CtSource::askFolder);
  connect(page, &EmptyPage::otherRequested, this, [this] { showArchive(true); });
  for (QWidget* stage : {static_cast<QWidget*>(page), pictures_, static_cast<QWidget*>(archive_)})
    stages_->addWidget(stage);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(panel_);
  row->addLayout(stages_, 1);
  connect(&study_, &CtStudy::changed, this, [this] {
    if (stages_->currentWidget() != archive_) showArchive(false);
  });
  connect(&study_, &CtStudy::approachGiven, this, &CtPage::giveApproach);
  connectWork();
  connectPanel();
  connectArchive();
  connectMarkups();
}

CtPage::~CtPage() { keepMarkups(); }

Page::Acceptance CtPage::accepts(const std::filesystem::path& file) const
{
  std::error_code failed;
  const bool isExamination = file.extension() == ".zip" || file.extension() == ".ZIP" ||
                             file.filename() == "DICOMDIR" ||
                             std::filesystem::is_regular_file(file / "DICOMDIR", failed);
  return isExamination ? Acceptance::always : Acceptance::whileShown;
}

void CtPage::resizeEvent(QResizeEvent* event)
{
  Page::resizeEvent(event);
  panel_->setWide(width() >= sized(wideFrom_px));
}

void CtPage::connectWork()
{
  connect(&work_, &CtWork::progressed, this, [this](double fraction) { showProgress(fraction); });
  connect(&work_, &CtWork::listed, this, [this](const imaging::CtSeriesList& list) {
    leaveScan();  // the list is of another folder
    list_ = list;
    panel_->source().series().show(list);
    thumbnails_.readThumbnails(list);
  });
  connect(&work_, &CtWork::seriesMissed, this,
          [this] { panel_->showIdle(notThere(std::exchange(wanted_, {})), true); });
  connect(&work_, &CtWork::ctRead, this,
          [this](const std::shared_ptr<imaging::LoadedCt>& loaded) { showCt(std::move(*loaded)); });
  connect(&thumbnails_, &CtWork::thumbnailsRead, &panel_->source().series(),
          &CtSeriesList::showThumbnails);
  connect(&work_, &CtWork::measured, this, [this](const ct::CochleaMeasures& measures) {
    study_.setMeasures(measures, atRequest_);
    if (std::exchange(isReopening_, false)) return measure(true);
    const auto then = std::exchange(then_, {});
    showNotes();
    if (then && !study_.isStale() && ct::landmarkContradictions(measures).empty()) then();
  });
  connect(&work_, &CtWork::failed, this, [this](const QString& sentence) {
    then_ = {};
    wanted_ = {};
    const bool isKept = std::exchange(isOpening_, false) && study_.hasCt();
    // nothing failed if the user canceled
    if (std::exchange(isReopening_, false) && !sentence.isEmpty()) return measure(true);
    if (sentence.isEmpty()) return showNotes();
    panel_->showIdle(
        isKept ? tr("%1 The CT shown is the one that was open before.").arg(sentence) : sentence,
        true);
  });
}

void CtPage::showNotes()
{
  panel_->showIdle(notes_, study_.hasCt() && study_.volume()->provenance().isInDoubt);
}

void CtPage::leaveScan()
{
  keepMarkups();
  study_.clear();
  notes_.clear();
  if (codeOf_.empty() || panel_->code().isEmpty()) return;
  leftCode_ = panel_->code();
  panel_->setCode({});
}

void CtPage::showCt(imaging::LoadedCt&& loaded)
{
  const CtRequest wanted = std::exchange(wanted_, {});
  // of NIfTI and NRRD the key is known now only
  if (!wanted.series.empty() && loaded.series.key != wanted.series)
    return panel_->showIdle(notThere(wanted), true);
  isOpening_ = false;
  const CtRequest request =
      sought_.series == loaded.series.key ? std::exchange(sought_, {}) : CtRequest();
  QStringList notes;
  for (const Sentence& warning : loaded.series.warnings) notes << dataText(warning);
  notes_ = notes.join(QLatin1Char('\n'));
  keepMarkups();
  study_.setCt(std::move(loaded));
  showKeptMarkups();
  rememberScan(study_.series().key, list_.path);
  const std::string& key = study_.series().key;
  if (!request.code.isEmpty())
    panel_->setCode(request.code);
  else if (codeOf_ == key && panel_->code().isEmpty())
    panel_->setCode(leftCode_);
  codeOf_ = key;
  leftCode_.clear();
  showNotes();
  views_[0]->setFocus();
  ct::Marks marks;
  for (const session::PatientLandmark& each : request.landmarks)
    if (const auto mark = ct::markNamed(each.name); mark && each.isByHand)
      marks[*mark] = Eigen::Vector3d(each.lps_mm[0], each.lps_mm[1], each.lps_mm[2]);
  side_ = request.side;
  isReopening_ = !marks.isEmpty();
  if (isReopening_) study_.setMarks(marks);
  measure(false);
}

void CtPage::begin(const CtRequest& request)
{
  Q_EMIT pageRequested(id());
  const bool isOfNext = request.series.empty();
  const bool isShown = !isOfNext && study_.hasCt() && study_.series().key == request.series;
  if (isOfNext || isShown) {
    if (request.code.isEmpty()) return;
    panel_->setCode(request.code);
    codeOf_ = request.series;
    return;
  }
  sought_ = request;
  const std::filesystem::path place = placeOfScan(request.series);
  std::error_code ignored;
  if (place.empty() || !std::filesystem::exists(place, ignored))
    return panel_->showIdle(notThere(request), true);
  openSeries(place, request.series);
  wanted_ = request;
}

void CtPage::connectPanel()
{
  const CtSource& source = panel_->source();
  connect(&source, &CtSource::opened, this, &CtPage::open);
  connect(&source, &CtSource::archiveRequested, this, [this] { showArchive(true); });
  connect(&source, &CtSource::recentRequested, this, &CtPage::begin);
  connect(&source, &CtSource::seriesChosen, this, [this](const std::string& uid) {
    if (study_.hasCt() && study_.series().uid == uid) return;
    then_ = {};
    leaveScan();
    beginTask(tr("Reading the CT…"));
    work_.read(list_, uid);
  });
  connect(panel_, &CtPanel::measureRequested, this,
          [this](bool isAtCrosshair) { measure(isAtCrosshair); });
  connect(panel_, &CtPanel::cancelRequested, &work_, &CtWork::cancel);
  connect(panel_, &CtPanel::markRequested, this, [this](ct::Mark mark) {
    study_.setTool({});
    const auto& point = study_.marks()[mark];
    if (point) study_.moveCrosshair(*point);
    for (PlaneView* view : views_) view->setPlaced(mark);
    panel_->showMark(mark);
  });
  connect(panel_, &CtPanel::structureRequested, this,
          [this](const std::optional<ct::MarkupKind>& structure) {
            if (structure) study_.setTool({});
            for (PlaneView* view : views_) view->setMarked(structure);
          });
  connect(panel_, &CtPanel::insertRequested, this, [this](const QString& code) {
    withFreshMeasures([this, code] { withFreeCode(code, [this, code] { insert(code); }); });
  });
  connect(panel_, &CtPanel::planRequested, this, [this](const QString& code) {
    withFreshMeasures([this, code] { withFreeCode(code, [this, code] { plan(code); }); });
  });
  connect(panel_, &CtPanel::saveSurfaceRequested, this,
          [this] { withFreshMeasures([this] { saveSurface(); }); });
  connect(panel_, &CtPanel::sendRequested, this, [this] { withFreshMeasures([this] { send(); }); });
  connect(panel_, &CtPanel::saveMarksRequested, this, &CtPage::saveMarks);
  connect(panel_, &CtPanel::loadMarksRequested, this, &CtPage::loadMarks);
}

bool CtPage::eventFilter(QObject* watched, QEvent* event)
{
  if (watched == surface_ && event->type() == QEvent::FocusIn) active_ = surface_;
  return Page::eventFilter(watched, event);
}

void CtPage::connectArchive()
{
  connect(archive_, &ArchiveView::leaveRequested, this, [this] { showArchive(false); });
  connect(archive_, &ArchiveView::serversRequested, this, &CtPage::serversRequested);
  connect(archive_, &ArchiveView::fetched, this,
          [this](const std::filesystem::path& folder) { read(folder, {}); });
}

void CtPage::showArchive(bool isShown)
{
  if (!isShown && stages_->currentWidget() == archive_) archive_->leave();
  if (isShown)
    stages_->setCurrentWidget(archive_);
  else
    stages_->setCurrentIndex(study_.hasCt() ? pictureStage : emptyStage);
  if (isShown) archive_->enter();
}

void CtPage::showServers() { archive_->showServers(); }

bool CtPage::isBusy() const { return work_.isBusy() || archive_->isBusy(); }

void CtPage::open(const std::filesystem::path& path)
{
  Q_EMIT pageRequested(id());  // it may have been dropped on another page
  openSeries(path, {});
}

void CtPage::openSeries(const std::filesystem::path& path, const std::string& series)
{
  panel_->source().remember(path);
  read(path, series);
}

void CtPage::read(const std::filesystem::path& path, const std::string& series)
{
  showArchive(false);
  then_ = {};
  wanted_ = {};
  isOpening_ = true;
  isReopening_ = false;
  beginTask(tr("Reading the CT…"));
  work_.open(path, series);
}

void CtPage::beginTask(const QString& task)
{
  task_ = task;
  since_.start();
  panel_->showTask(task_, 0.0);
}

void CtPage::showProgress(double fraction)
{
  panel_->showTask(taskText(task_, fraction, 1e-3 * double(since_.elapsed())), fraction);
}

bool CtPage::cancel()
{
  if (stages_->currentWidget() == archive_) {
    if (!archive_->cancel()) showArchive(false);
    return true;
  }
  for (PlaneView* view : views_)
    if (view->cancelText()) return true;
  if (study_.tool()) {
    study_.setTool({});
    return true;
  }
  if (panel_->endStructure()) return true;
  if (!work_.isBusy()) return false;
  work_.cancel();
  return true;
}

bool CtPage::isInMeasuredCochlea(const session::Scenario& scenario) const
{
  return scenario.anatomy() == anatomy::AnatomySource::mean && isMeasured(scenario.patient());
}

bool CtPage::isMeasured(const anatomy::Patient& inserted) const
{
  const auto& measures = study_.measures();
  if (!measures || !patient_ || patient_->origin.seriesKey != measures->provenance.seriesKey)
    return false;
  // The same label may be of another person, whose cochlea the array would be shown in.
  anatomy::Patient measured = imaging::measuredPatient(*measures);
  const auto numbers = [](anatomy::Patient patient) {
    patient.errors.reset();
    patient.origin = {};
    return anatomy::patientText(patient);
  };
  measured.label = patient_->label;
  return numbers(inserted) == numbers(measured);
}

void CtPage::giveApproach()
{
  const auto approach = study_.approach();
  if (!approach) return;
  if (insertionSetup_.scenario && isInMeasuredCochlea(insertionSetup_.scenario())) {
    if (areSame(perilymph::gui::approachOf(insertionSetup_.scenario()), *approach)) return;
    if (!insertionSetup_.mayChange()) {
      followSetup();
      return panel_->showIdle(
          tr("An insertion into this cochlea is in progress, or is replayed: reset it, or close "
             "the replay, to turn its line of approach."),
          true);
    }
    insertionSetup_.change(approachChange(*approach));
  }
  Q_EMIT approachChanged();
}

void CtPage::followSetup()
{
  if (!insertionSetup_.scenario) return;
  const session::Scenario& scenario = insertionSetup_.scenario();
  if (!isInMeasuredCochlea(scenario)) return;
  study_.showApproach(perilymph::gui::approachOf(scenario));
  Q_EMIT approachChanged();
}

std::optional<anatomy::Approach> CtPage::approachOf(const anatomy::Patient& patient) const
{
  return isMeasured(patient) ? study_.approach() : std::nullopt;
}

void CtPage::onShown()
{
  followSetup();
  const auto scala = control_.sharedAnatomy();
  if (scala == nullptr) return;
  const session::Scenario& scenario = control_.scenario();
  if (!isInMeasuredCochlea(scenario)) return study_.setArray({});
  study_.setArray(insertedArray(*study_.measures(), scenario.array(), *scala,
                                perilymph::gui::approachOf(scenario), control_.now()));
}

std::optional<broadcast::PlacedCt> CtPage::placedCt(const session::Scenario& scenario) const
{
  if (!isInMeasuredCochlea(scenario)) return std::nullopt;
  const ct::CochleaMeasures& measures = *study_.measures();
  return broadcast::PlacedCt{study_.volume(), measures.anatomyAxes_PW, measures.anatomyOrigin_P};
}

std::shared_ptr<const visualization::BoneModel> CtPage::boneOf(
    const anatomy::Patient& patient) const
{
  return isMeasured(patient) ? bone_.inAnatomy() : nullptr;
}

void CtPage::withFreshMeasures(std::function<void()> then)
{
  if (!study_.measures()) return;
  if (!study_.isStale()) return then();
  measure(true, std::move(then));
}

void CtPage::withFreeCode(const QString& code, std::function<void()> then)
{
  anatomy::Patient measured = imaging::measuredPatient(*study_.measures());
  measured.label = code.toStdString();
  auto saved = findSavedPatient(measured.label, measured.side);
  if (saved && haveSameMeasures(saved->patient, measured)) saved.reset();
  const QStringList doubts = seriesDoubts(measured);
  if (!saved && doubts.isEmpty()) return then();
  panel_->question().ask(saved, measured, doubts, std::move(then));
}

void CtPage::insert(const QString& code)
{
  const auto setup =
      setupOfMeasures(*study_.measures(), code, study_.approach().value_or(anatomy::Approach{}),
                      study_.former().get());
  if (!setup) return panel_->showIdle(dataText(setup.error().message), true);
  patient_ = imaging::measuredPatient(*study_.measures());
  patient_->label = setup->scenario.patient().label;
  markupFile_ = libraryFileOf(*patient_);
  keepMarkups();
  keepKeyImage();
  Q_EMIT insertionRequested({*setup});
}

void CtPage::plan(const QString& code)
{
  const auto patient = patientOfMeasures(*study_.measures(), code, study_.former().get());
  if (!patient) return panel_->showIdle(dataText(patient.error().message), true);
  patient_ = *patient;
  markupFile_ = libraryFileOf(*patient_);
  keepMarkups();
  keepKeyImage();
  Q_EMIT planRequested(*patient);
}

void CtPage::keepKeyImage()
{
  rememberScan(study_.series().key, list_.path, patient_->label);
  const std::filesystem::path file = keyImageFile(*patient_);
  std::error_code failure;
  std::filesystem::create_directories(file.parent_path(), failure);
  const auto kept = imaging::writeMeasuredPicture(study_.volume(), *study_.measures(), file);
  if (!kept) panel_->showIdle(dataText(kept.error().message), true);  // reports do without
}

void CtPage::measure(bool isAtCrosshair, std::function<void()> then)
{
  if (!study_.hasCt()) return;
  // marks of a scan that is opened again stay: the second fit, which begins there, is theirs
  atRequest_ = isReopening_ ? ct::Marks() : study_.marksByHand();
  then_ = std::move(then);
  ct::MeasureRequest request;
  request.side = std::exchange(side_, {});
  if (isAtCrosshair && study_.isCorrected()) {
    // proposed landmarks of a wrong fit lie elsewhere, so those placed by hand come first
    request.marks = study_.marksByHand();
    const bool isEnough = request.marks[ct::Mark::modiolus] || request.marks[ct::Mark::farWall];
    request.click_P = (isEnough ? request.marks : study_.marks()).inside_P();
  } else if (isAtCrosshair && study_.isStale()) {
    request.click_P = study_.marks().inside_P();  // landmarks were taken back, not moved
  } else if (isAtCrosshair) {
    request.click_P = study_.crosshair_P();
  }
  beginTask(isAtCrosshair ? tr("Measuring the cochlea…") : tr("Looking for the cochlea…"));
  work_.measure(study_.volume(), std::move(request));
}

void CtPage::maximize(QWidget* chosen)
{
  const std::array<QWidget*, 4> all{views_[0], views_[1], views_[2], surface_};
  const bool isAlone = std::ranges::count_if(all, &QWidget::isVisible) == 1;
  for (QWidget* view : all) view->setVisible(isAlone || view == chosen);
}

void CtPage::showDone(const Result<void>& done, const QString& file)
{
  if (done)
    panel_->showIdle(tr("Saved to %1.").arg(file));
  else
    panel_->showIdle(dataText(done.error().message), true);
}

void CtPage::saveSurface()
{
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Surface of the cochlea"), QStringLiteral("cochlea.stl"),
      QStringLiteral("STL (*.stl);;PLY (*.ply);;glTF (*.gltf);;OBJ (*.obj);;VTP (*.vtp)"));
  if (file.isEmpty() || !study_.measures()) return;
  const anatomy::Surface surface = imaging::measuredSurface(*study_.measures());
  const std::filesystem::path path = file.toStdString();
  showDone(path.extension() == ".gltf"
               ? imaging::writeGltf(surface, imaging::measuredSurfaceTitle, path)
               : anatomy::writeSurface(surface, imaging::measuredSurfaceTitle, path),
           file);
}

std::optional<std::filesystem::path> CtPage::placeOf(const std::string& seriesKey) const
{
  std::error_code failed;
  const bool isFolder =
      list_.path.filename() == "DICOMDIR" || std::filesystem::is_directory(list_.path, failed);
  if (!study_.hasCt() || study_.series().key != seriesKey || !isFolder) return std::nullopt;
  return list_.path;
}

void CtPage::send()
{
  (new SendDialog(ctParts(study_), placeOf(study_.series().key), this))->open();
}

void CtPage::connectMarkups()
{
  constexpr int pause_ms = 500;  // a drag changes them with every motion of the mouse
  keeping_.setSingleShot(true);
  keeping_.setInterval(pause_ms);
  connect(&keeping_, &QTimer::timeout, this, &CtPage::keepMarkups);
  connect(&study_, &CtStudy::markupsChanged, this, [this] {
    if (!isShowingKept_ && study_.hasCt()) keeping_.start();
  });
  connect(&study_, &CtStudy::changed, this, [this] {
    if (study_.tool()) panel_->endStructure();  // clicks place its points now
  });
  surface_->installEventFilter(this);  // what is looked at last is kept as a key image
  connect(markupBar_, &MarkupBar::keyImageRequested, this, &CtPage::takeKeyImage);
  connect(markupBar_, &MarkupBar::keyImageRemoved, this, [this](const std::filesystem::path& file) {
    removeCtKeyImage(file);
    markupBar_->showKeyImages(ctKeyImages(study_.series().key));
  });
  connect(markupBar_, &MarkupBar::slicerRequested, this, [this] { saveMarkups(false); });
  connect(markupBar_, &MarkupBar::tableRequested, this, [this] { saveMarkups(true); });
  connect(markupBar_, &MarkupBar::loadRequested, this, &CtPage::loadMarkups);
}

void CtPage::toggleTool(ct::MarkupKind tool)
{
  for (PlaneView* view : views_) view->setPlaced({});
  panel_->showMark({});
  study_.setTool(study_.tool() == tool ? std::nullopt : std::optional(tool));
}

bool CtPage::takeKey(const QKeyEvent& event)
{
  if (!study_.hasCt() || stages_->currentWidget() != pictures_) return false;
  if (event.matches(QKeySequence::Undo)) return study_.undo(), true;
  if (event.matches(QKeySequence::Redo)) return study_.redo(), true;
  if ((event.modifiers() & ~Qt::KeypadModifier) != 0) return false;
  auto* plane = qobject_cast<PlaneView*>(active_);
  switch (event.key()) {
    case Qt::Key_D:
      toggleTool(ct::MarkupKind::distance);
      return true;
    case Qt::Key_A:
      toggleTool(ct::MarkupKind::angle);
      return true;
    case Qt::Key_N:
      toggleTool(ct::MarkupKind::note);
      return true;
    case Qt::Key_K:
      for (QWidget* view : {static_cast<QWidget*>(views_[0]), static_cast<QWidget*>(views_[1]),
                            static_cast<QWidget*>(views_[2]), static_cast<QWidget*>(surface_)})
        if (view->isVisible() && view->underMouse()) active_ = view;
      takeKeyImage();
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (!study_.tool()) return false;
      (plane ? plane : views_[0])->placeToolPoint(study_.crosshair_P());
      return true;
    case Qt::Key_Delete:
      if (!study_.chosenMarkup()) return false;
      study_.removeMarkup(*study_.chosenMarkup());
      return true;
    default:
      return false;
  }
}

void CtPage::showKeptMarkups()
{
  const std::string& key = study_.series().key;
  markupFile_.clear();
  std::vector<ct::Markup> kept;
  for (const SavedPatient& each : savedPatients()) {
    const ct::CtMarkups* found = session::markupsOf(each.record, key);
    if (found == nullptr) continue;
    kept = found->markups;
    markupFile_ = each.file;
    break;  // the patient who was used last
  }
  if (markupFile_.empty())
    if (const auto found = markupsOfSeries_.find(key); found != markupsOfSeries_.end())
      kept = found->second;
  isShowingKept_ = true;
  study_.showMarkups(std::move(kept));
  isShowingKept_ = false;
  markupBar_->showKeyImages(ctKeyImages(key));
  showKeeping();
}

void CtPage::showKeeping()
{
  markupBar_->showKeeping(
      markupFile_.empty()
          ? tr("Kept with the patient by a plan or an insertion")
          : tr("Kept with %1").arg(QString::fromStdString(markupFile_.stem().string())));
}

void CtPage::keepMarkups()
{
  keeping_.stop();
  if (!study_.hasCt()) return;
  const ct::CtMarkups markups = study_.ctMarkups();
  markupsOfSeries_[markups.seriesKey] = markups.markups;
  if (markupFile_.empty()) return;
  const auto before = session::loadPatientRecord(markupFile_);
  const ct::CtMarkups* known = before ? session::markupsOf(*before, markups.seriesKey) : nullptr;
  const bool isKept = known != nullptr ? *known == markups : markups.markups.empty();
  if (isKept && before) return showKeeping();
  const auto kept = session::changePatientRecord(
      markupFile_, [&](session::PatientRecord& record) { session::setMarkups(record, markups); });
  if (!kept) panel_->showIdle(dataText(kept.error().message), true);
  showKeeping();
}

void CtPage::takeKeyImage()
{
  if (!study_.hasCt()) return;
  auto* plane = qobject_cast<PlaneView*>(active_);
  const bool isBone = active_ == surface_;
  if (plane == nullptr || !plane->isVisible()) plane = views_[0];
  constexpr double ratio = 2.0;  // type of the overlay 2.6 mm high on paper
  const QSize size(keyImageWidth_px, keyImageHeight_px);
  QImage picture;
  QString place;
  if (isBone) {
    const QImage seen =
        surface_->grab().toImage().scaled(size, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    picture = QImage(size, QImage::Format_RGB32);
    picture.fill(Qt::black);
    QPainter painter(&picture);
    painter.drawImage((size.width() - seen.width()) / 2, (size.height() - seen.height()) / 2, seen);
    place = tr("Bone and measured cochlea, 3D");
  } else {
    picture = plane->pictureOf(size, ratio);
    const auto index = std::size_t(std::ranges::find(views_, plane) - views_.begin());
    place = planePlaceText(study_, index);
  }
  const std::string key = study_.series().key;
  PlaneView* asks = isBone && !views_[0]->isVisible() ? nullptr : plane;
  const auto keep = [this, key, picture, place](const QString& caption) {
    const auto kept = keepCtKeyImage(key, picture, caption, place);
    if (!kept) return panel_->showIdle(dataText(kept.error().message), true);
    const auto images = ctKeyImages(study_.series().key);
    markupBar_->showKeyImages(images);
    panel_->showIdle(
        tr("Key image %1 goes into the reports of this CT’s patient.").arg(images.size()));
  };
  if (asks == nullptr) return keep({});
  asks->askText(tr("Caption of the key image, Return keeps it, Esc drops it"), {},
                QPointF(0.0, asks->height()), keep);
}

void CtPage::saveMarkups(bool isTable)
{
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Markups"),
      isTable ? QStringLiteral("markups.csv") : QStringLiteral("markups.mrk.json"),
      isTable ? QStringLiteral("*.csv") : QStringLiteral("*.mrk.json"));
  if (file.isEmpty()) return;
  const ct::CtMarkups markups = study_.ctMarkups();
  const std::filesystem::path path = file.toStdString();
  auto done =
      writeWhole(path, isTable ? imaging::markupsCsv(markups) : imaging::slicerMarkups(markups),
                 {Links::followed, Audience::owner});
  if (done && isTable) {
    std::filesystem::path dictionary = path;
    dictionary.replace_filename(path.stem().string() + "-dictionary.csv");
    done = writeWhole(dictionary, imaging::markupsDictionaryCsv());
  }
  showDone(done, file);
}

void CtPage::loadMarkups()
{
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Markups"), {}, QStringLiteral("*.mrk.json *.json"));
  if (file.isEmpty()) return;
  const auto markups = imaging::readMarkups(file.toStdString(), study_.series().key);
  if (!markups) return panel_->showIdle(dataText(markups.error().message), true);
  const auto added = study_.addMarkups(*markups);
  if (!added) return panel_->showIdle(dataText(added.error().message), true);
  panel_->showIdle(tr("%1 markups were loaded.").arg(markups->size()));
}

void CtPage::saveMarks()
{
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Landmarks"), QStringLiteral("cochlea.mrk.json"), QStringLiteral("*.mrk.json"));
  if (file.isEmpty()) return;
  showDone(writeWhole(file.toStdString(), imaging::planText(planOf(study_))), file);
}

void CtPage::loadMarks()
{
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Landmarks"), {}, QStringLiteral("*.mrk.json *.json"));
  if (file.isEmpty()) return;
  const auto marks = imaging::readLandmarks(file.toStdString(), study_.series().key);
  if (!marks) return panel_->showIdle(dataText(marks.error().message), true);
  study_.setMarks(*marks);
  if (const auto inside = marks->inside_P()) study_.moveCrosshair(*inside);
}

}  // namespace perilymph::gui
