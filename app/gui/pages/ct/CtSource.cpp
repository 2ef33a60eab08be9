// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/CtSource.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/pages/ct/CtSeriesList.h"
#include "gui/pages/ct/RecentScans.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

CtSource::CtSource(QWidget* parent, const QString& place)
    : QWidget(parent), series_(new CtSeriesList(this))
{
  // a narrower panel has them one above the other
  auto* row = new QBoxLayout(place.isEmpty() ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  auto* folder = rowButton(tr("Open folder…"), "openCtFolderButton", this);
  auto* file = rowButton(tr("Open file…"), "openCtFileButton", this);
  folder->setToolTip(tr("A folder with DICOM files, or the folder of a DICOMDIR"));
  file->setToolTip(
      tr("DICOM (.zip), DICOMDIR, enhanced DICOM, NIfTI (.nii, .nii.gz), NRRD (.nrrd, .nhdr) or "
         "MetaImage (.mha, .mhd)"));
  row->setSpacing(4);
  for (QPushButton* button : {folder, file}) {
    button->setProperty("small", true);
    row->addWidget(button);
  }
  auto* archive = rowButton(tr("From the archive…"), "openArchiveButton", this);
  archive->setToolTip(tr("Find the CT in a DICOM archive (PACS) and retrieve it"));
  auto* recent = rowButton({}, "recentCtButton", this);  // its arrow: a name has no room
  recent->setAccessibleName(tr("Recent CTs"));
  recent->setFixedWidth(sized(34));
  recent->setToolTip(tr("Recent CTs, by the patient’s code and the date"));
  auto* menu = new RecentScans(recent);
  recent->setMenu(menu);
  auto* others = new QHBoxLayout;
  others->setSpacing(4);
  for (QPushButton* button : {archive, recent}) {
    button->setProperty("small", true);
    others->addWidget(button);
  }
  if (!place.isEmpty())
    for (QWidget* each : {static_cast<QWidget*>(series_), static_cast<QWidget*>(folder),
                          static_cast<QWidget*>(file), static_cast<QWidget*>(archive),
                          static_cast<QWidget*>(recent)})
      each->setObjectName(place + each->objectName());
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  column->addLayout(row);
  column->addLayout(others);
  column->addWidget(series_);
  connect(folder, &QPushButton::clicked, this, &CtSource::askFolder);
  connect(file, &QPushButton::clicked, this, &CtSource::askFile);
  connect(archive, &QPushButton::clicked, this, &CtSource::archiveRequested);
  connect(menu, &RecentScans::chosen, this, &CtSource::recentRequested);
  connect(series_, &QListWidget::itemClicked, this,
          [this](QListWidgetItem* item) { Q_EMIT seriesChosen(CtSeriesList::uidOf(*item)); });
}

void CtSource::remember(const std::filesystem::path& path)
{
  folder_ = QString::fromStdString(path.parent_path().string());
}

void CtSource::askFolder()
{
  const QString folder =
      QFileDialog::getExistingDirectory(this, tr("Folder with a temporal-bone CT"), folder_);
  if (!folder.isEmpty()) Q_EMIT opened(folder.toStdString());
}

void CtSource::askFile()
{
  const QString file = QFileDialog::getOpenFileName(this, tr("CT"), folder_);
  if (!file.isEmpty()) Q_EMIT opened(file.toStdString());
}

}  // namespace perilymph::gui
