// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/ContactExport.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFileDialog>

#include "gui/setup/Setup.h"
#include "gui/setup/TableFiles.h"
#include "gui/widgets/StatusLine.h"
#include "perilymph/planning/ContactsCsv.h"

namespace perilymph::gui {

Result<void> writeContactTable(const std::filesystem::path& file, const std::string& csv)
{
  return writeTable(file, csv, planning::contactsDictionaryCsv());
}

std::string contactFileStem(const ContactSubject& subject)
{
  const auto utc = QDateTime::fromString(QString::fromStdString(subject.utc), Qt::ISODate);
  const std::string date = utc.toLocalTime().toString(QStringLiteral("yyyy-MM-dd")).toStdString();
  return fileStemOf(subject.patient.label) + "-" + anatomy::nameOf(subject.patient.side) + "-" +
         std::filesystem::path(subject.array).stem().string() +
         (subject.isPlanned ? "-planned" : "-inserted") + "-contacts" +
         (date.empty() ? "" : "-" + date);
}

std::optional<std::filesystem::path> chooseContactFile(QWidget* parent,
                                                       const ContactSubject& subject)
{
  const QString proposed = documentsFolder() + QLatin1Char('/') +
                           QString::fromStdString(contactFileStem(subject)) +
                           QStringLiteral(".csv");
  const QString chosen = QFileDialog::getSaveFileName(
      parent, QCoreApplication::translate("perilymph::gui", "Save the contacts"), proposed,
      QCoreApplication::translate("perilymph::gui", "Tables (*.csv)"));
  if (chosen.isEmpty()) return std::nullopt;
  return std::filesystem::path(chosen.toStdString());
}

}  // namespace perilymph::gui
