// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/MainMenu.h"

#include <QFileDialog>
#include <QKeySequence>

#include "gui/run/WorkflowPredicates.h"
#include "gui/shell/Help.h"
#include "gui/shell/MainWindow.h"
#include "gui/shell/OverlayStack.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::gui {

MainMenu::MainMenu(MainWindow& window, QWidget* parent) : QMenu(parent), window_(window)
{
  // The keys are only displayed; the window itself handles them.
  const auto add = [this](const QString& text, const QString& key, const char* name, auto act) {
    QAction* action = addAction(key.isEmpty() ? text : text + QLatin1Char('\t') + key);
    action->setObjectName(QLatin1String(name));
    connect(action, &QAction::triggered, this, act);
    return action;
  };
  QAction* open = add(tr("Open recording…"), {}, "openAction", [this] { openRecording(); });
  add(tr("Export recordings…"), {}, "exportAction",
      [this] { window_.showPage(QStringLiteral("sessions")); });
  add(tr("Save screenshot"), tr("Ctrl+Shift+S"), "screenshotAction",
      [this] { window_.takePicture(); });
  addSeparator();
  add(tr("Settings"), tr("Ctrl+,"), "settingsAction",
      [this] { window_.sheets().toggleSettings(); });
  add(tr("Keys and mouse"), tr("F1"), "keysAction",
      [this] { window_.sheets().help().toggleKeys(); });
  add(tr("User guide"), tr("Shift+F1"), "guideAction",
      [this] { window_.sheets().help().toggleGuide(); });
  add(tr("About Perilymph"), {}, "aboutAction", [this] { window_.sheets().toggleAbout(); });
  addSeparator();
  add(tr("Quit"), tr("Ctrl+Q"), "quitAction", [this] { window_.close(); });
  // a dialog must not cover an insertion
  connect(this, &QMenu::aboutToShow, open,
          [this, open] { open->setEnabled(isBetweenInsertions(stateOf(window_.control()))); });
}

void MainMenu::openRecording()
{
  if (!isBetweenInsertions(stateOf(window_.control()))) return;
  auto* dialog = new QFileDialog(&window_, tr("Open recording"),
                                 QString::fromStdString(sessionFolder().string()),
                                 tr("Recordings (*.insertion)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, &window_, [this](const QString& file) {
    window_.replay(std::filesystem::path(file.toStdString()));
  });
  dialog->open();
}

}  // namespace perilymph::gui
