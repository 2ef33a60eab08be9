// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/StatusLine.h"

#include <QDir>
#include <QHBoxLayout>
#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <QStandardPaths>
#include <QStyle>
#include <QVariant>

#include "gui/widgets/Theme.h"

namespace perilymph::gui {

StatusLine::StatusLine(const char* name, QWidget* parent)
    : QWidget(parent), label_(new QLabel(this)), open_(new QPushButton(tr("Open folder"), this))
{
  label_->setObjectName(QLatin1String(name));
  label_->setFont(typeface(11));
  label_->setWordWrap(true);
  open_->setObjectName(QLatin1String(name) + QStringLiteral("Folder"));
  open_->setFont(typeface(11));
  open_->setFixedHeight(sized(24));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(spacing);
  row->addWidget(label_, 1);
  row->addWidget(open_);
  connect(open_, &QPushButton::clicked, this, [this] {
    // the desktop's file manager, for a local folder only
    const QString folder = QString::fromStdString(folder_.string());
    if (!QProcess::startDetached(QStringLiteral("xdg-open"), {folder})) showMessage(folder);
  });
  showMessage({});
}

void showSentence(QLabel& label, const QString& sentence, bool isError)
{
  label.setText(sentence);
  label.setProperty("error", isError);
  label.setProperty("quiet", !isError);
  label.style()->unpolish(&label);
  label.style()->polish(&label);
}

void StatusLine::showMessage(const QString& sentence, bool isError)
{
  showSentence(*label_, sentence, isError);
  open_->hide();
}

void StatusLine::sayWritten(const QString& sentence, const std::filesystem::path& folder)
{
  showMessage(sentence);
  folder_ = folder;
  open_->setToolTip(QString::fromStdString(folder.string()));
  open_->show();
}

QString documentsFolder()
{
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  return QDir(documents).exists() ? documents : QDir::homePath();
}

}  // namespace perilymph::gui
