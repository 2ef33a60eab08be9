// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/WindowPicture.h"

#include "gui/text/DataText.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QPixmap>
#include <QStandardPaths>
#include <QWidget>

#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::gui {

QString keepPicture(QWidget& window)
{
  const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  QDir().mkpath(pictures);  // an error is reported when the file is written
  const QString name = QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"));
  QString file = QStringLiteral("%1/perilymph-%2.png").arg(pictures, name);
  for (int number = 2; QFile::exists(file); ++number)
    file = QStringLiteral("%1/perilymph-%2-%3.png").arg(pictures, name).arg(number);
  const QPixmap picture = window.grab();
  const Result<void> written =
      writeWhole(file.toStdString(), [&picture](const std::filesystem::path& place) {
        return picture.save(QString::fromStdString(place.string()), "PNG");
      });
  if (!written) return dataText(written.error().message);
  return QCoreApplication::translate("perilymph::gui", "Screenshot saved: %1").arg(file);
}

}  // namespace perilymph::gui
