// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/ReportSending.h"

#include "gui/archive/SendDialog.h"

namespace perilymph::gui {

Result<std::string> pdfToSend(const PdfWriting& writing, const ReportIdentity& identity)
{
  if (const auto known = checkFiled(identity); !known) return known.error();
  return pdfBytes(writing);
}

void sendReport(const QString& name, const std::string& pdf, const ReportIdentity& identity,
                const CtPlaces& places, QWidget* parent)
{
  const auto write = [pdf, identity](const std::filesystem::path& ct,
                                     const std::filesystem::path& file) {
    return writeDicom(pdf, identity, {file, ct});
  };
  (new SendDialog({{name, write}}, places ? places(identity.seriesKey) : std::nullopt, parent))
      ->open();
}

}  // namespace perilymph::gui
