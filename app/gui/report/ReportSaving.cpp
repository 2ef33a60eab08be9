// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/ReportSaving.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <stop_token>
#include <utility>

#include "gui/text/DataText.h"
#include "gui/widgets/StatusLine.h"

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

QString savedText(const ReportPlace& place)
{
  const QString name = QString::fromStdString(place.file.filename().string());
  return place.ct
             ? tr("The report was saved as %1. It names the patient, as the CT does.").arg(name)
             : tr("The report was saved as %1.").arg(name);
}

}  // namespace

std::optional<ReportPlace> askReportPlace(const QString& title, const QString& name,
                                          QWidget* parent)
{
  const QString pdf = tr("PDF (*.pdf)"), dicom = tr("DICOM with the patient’s code (*.dcm)"),
                filed = tr("DICOM in the study of the CT, with the patient’s name (*.dcm)");
  QFileDialog dialog(parent, title, documentsFolder());
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setNameFilters({pdf, dicom, filed});
  dialog.setDefaultSuffix(QStringLiteral("pdf"));
  dialog.selectFile(name + QStringLiteral(".pdf"));
  QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, [&](const QString& filter) {
    const QString suffix = filter == pdf ? QStringLiteral("pdf") : QStringLiteral("dcm");
    dialog.setDefaultSuffix(suffix);
    const QStringList typed = dialog.selectedFiles();
    const std::filesystem::path file(typed.isEmpty() ? std::string() : typed.front().toStdString());
    if (file.extension() == ".pdf" || file.extension() == ".dcm")
      dialog.selectFile(QString::fromStdString(file.stem().string()) + QLatin1Char('.') + suffix);
  });
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return std::nullopt;
  ReportPlace place{dialog.selectedFiles().front().toStdString()};
  if (!place.isDicom() || dialog.selectedNameFilter() != filed) return place;
  const QString folder = QFileDialog::getExistingDirectory(
      parent, tr("Folder of the patient’s CT; the report takes name and number from it"),
      documentsFolder());
  if (folder.isEmpty()) return std::nullopt;
  place.ct = folder.toStdString();
  return place;
}

void ReportSaving::save(const PdfWriting& writing, const ReportIdentity& identity,
                        const ReportPlace& place)
{
  if (place.ct && identity.seriesKey.empty())
    return failed(dataText(
        Sentence{"The report states no CT series for which a seal vouches, so it cannot be "
                 "compared with %1. Save it without a CT.",
                 place.ct->string()}));
  if (!place.isDicom()) {
    const auto written = writing(place.file);
    if (!written) return failed(dataText(written.error().message));
    return saved(place.file, savedText(place));
  }
  auto pdf = pdfBytes(writing);
  if (!pdf) return failed(dataText(pdf.error().message));
  background_.run(
      "The report",
      [bytes = *std::move(pdf), identity, place](const std::stop_token&) {
        return writeDicom(bytes, identity, place);
      },
      [this, place](const Result<void>& written) {
        if (!written) return failed(dataText(written.error().message));
        saved(place.file, savedText(place));
      });
}

}  // namespace perilymph::gui
