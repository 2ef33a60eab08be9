// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/ContactTable.h"

#include <iterator>
#include <utility>

#include "gui/text/Numbers.h"
#include "gui/widgets/TableHeads.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int contactRow_px = 24, contactHeader_px = 40;
constexpr int contactWidths_px[] = {36, 58, 104, 126, 78, 72, 64, 94};

QString spanText(const planning::Band& band, int decimals)
{
  return QStringLiteral("%1 (%2–%3)")
      .arg(numberText(band.median, decimals), numberText(band.low, decimals),
           numberText(band.high, decimals));
}

}  // namespace

ContactTable::ContactTable(QWidget* parent)
    : QTableWidget(0, int(std::size(contactWidths_px)), parent)
{
  setObjectName(QStringLiteral("planContacts"));
  setAccessibleName(tr("Contacts"));
  const std::pair<QString, QString> columns[] = {
      {tr("No."), tr("Number of the contact; 1 at the tip")},
      {tr("Inside"),
       tr("Simulations in which the contact is inserted; the other columns are over these")},
      {tr("Angle"), tr("From the round window. Median and the band that the head names.")},
      {tr("To modiolus"), tr("From the center line of the array to the inner wall. Median and the "
                             "band that the head names.")},
      {tr("Greenwood"), tr("Frequency of the place along the organ of Corti (Greenwood 1990)")},
      {tr("Spiral ganglion"),
       tr("Frequency of the spiral ganglion at the angle (Stakhovskaya et al. 2007)")},
      {tr("Default filter"), tr("Center of the filter that the contact gets by default; – if no "
                                "allocation is known")},
      {tr("Mismatch"), tr("Frequency of its place on the spiral ganglion above its default filter, "
                          "in semitones; positive: it hears a lower frequency than its place")}};
  showValues(*this, columns, sized(contactRow_px), sized(contactHeader_px));
  show({}, 0);
}

void ContactTable::show(const std::vector<planning::ContactBand>& contacts, std::size_t draws)
{
  setRowCount(int(contacts.size()));
  const auto kilohertz = [](double value_Hz) {
    return value_Hz > 0.0 ? tr("%1 kHz").arg(kilohertzText(value_Hz)) : tr("–");
  };
  for (int row = 0; row < int(contacts.size()); ++row) {
    const planning::ContactBand& each = contacts[std::size_t(row)];
    QStringList texts{QString::number(each.number), tr("%1 of %2").arg(each.draws).arg(draws)};
    if (each.draws == 0)
      texts << tr("–") << tr("–") << tr("–") << tr("–") << tr("–") << tr("–");
    else
      texts << tr("%1°").arg(spanText(each.angle_deg, 0))
            << (each.toModiolus_mm.high > 0.0 ? tr("%1 mm").arg(spanText(each.toModiolus_mm, 2))
                                              : tr("–"))
            << kilohertz(each.greenwood_Hz) << kilohertz(each.spiralGanglion_Hz)
            << kilohertz(each.filter_Hz)
            << (each.filter_Hz > 0.0 ? tr("%1 st").arg(spanText(each.mismatch_semitones, 0))
                                     : tr("–"));
    for (int column = 0; column < texts.size(); ++column)
      setItem(row, column, new QTableWidgetItem(texts[column]));
  }
  fitColumns(*this, contactWidths_px);
}

}  // namespace perilymph::gui
