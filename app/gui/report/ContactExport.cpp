// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/ContactExport.h"

#include <QCoreApplication>
#include <QFileDialog>

#include "gui/widgets/StatusLine.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/planning/ContactsCsv.h"

namespace perilymph::gui {

Result<Done> writeContactTable(const std::filesystem::path& file, const std::string& csv)
{
  if (const auto written = writeWhole(file, csv, {Links::refused}); !written) return written;
  const std::filesystem::path dictionary =
      file.parent_path() / (file.stem().string() + "-dictionary.csv");
  return writeWhole(dictionary, planning::contactsDictionaryCsv(), {Links::refused});
}

std::optional<std::filesystem::path> chooseContactFile(QWidget* parent, const std::string& array)
{
  const std::string stem = std::filesystem::path(array).stem().string();
  const QString proposed =
      documentsFolder() + QStringLiteral("/contacts-%1.csv").arg(QString::fromStdString(stem));
  const QString chosen = QFileDialog::getSaveFileName(
      parent, QCoreApplication::translate("perilymph::gui", "Save the contacts"), proposed,
      QCoreApplication::translate("perilymph::gui", "Tables (*.csv)"));
  if (chosen.isEmpty()) return std::nullopt;
  return std::filesystem::path(chosen.toStdString());
}

}  // namespace perilymph::gui
