// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/outcome/FoundContacts.h"

#include <iterator>
#include <utility>

#include "gui/setup/OutcomeWords.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/TableHeads.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int foundRow_px = 22, foundHeader_px = 40;
constexpr int foundWidths_px[] = {68, 104, 78, 84, 120, 126, 76, 92, 84};

}  // namespace

FoundContacts::FoundContacts(QWidget* parent)
    : QTableWidget(0, int(std::size(foundWidths_px)), parent)
{
  setObjectName(QStringLiteral("outcomeContacts"));
  setAccessibleName(tr("Contacts found in the CT"));
  const std::pair<QString, QString> columns[] = {
      {tr("No."),
       tr("Number of the contact, 1 at the tip; in brackets that in its maker’s fitting software")},
      {tr("Angle"), tr("From the round window, with its 95 % interval")},
      {tr("To modiolus"),
       tr("From the contact’s center to the inner wall, toward the modiolar axis")},
      {tr("In scala tympani"), tr("Probability that the contact lies below the basilar membrane, "
                                  "with the errors of the CT and of "
                                  "the ear. The membrane is not visible in a CT: no diagnosis.")},
      {tr("Greenwood"),
       tr("Estimated frequency of the place along the organ of Corti (Greenwood 1990), with "
          "its 95 % interval")},
      {tr("Spiral ganglion"),
       tr("Estimated frequency of the spiral ganglion at the angle (Stakhovskaya et "
          "al. 2007), with its 95 % interval")},
      {tr("Default filter"),
       tr("Center of the filter that the contact gets by default; – if no allocation is known")},
      {tr("Mismatch"),
       tr("Frequency of its place on the spiral ganglion above its default filter, in "
          "semitones, with its 95 % interval; positive: it hears a lower frequency than its "
          "place")},
      {tr("Placed"),
       tr("singly: its own brightness was seen; by spacing: the contacts merge in this CT, and "
          "the array’s spacings place it; by hand: a person placed it")}};
  showValues(*this, columns, sized(foundRow_px), sized(foundHeader_px));
  connect(this, &QTableWidget::itemSelectionChanged, this, [this] {
    if (const auto* number = item(currentRow(), 0))
      Q_EMIT contactChosen(number->data(Qt::UserRole).toInt());
  });
  show({});
}

void FoundContacts::show(const std::vector<outcome::FoundContact>& contacts)
{
  const QSignalBlocker quiet(this);
  const int chosen = currentRow();
  setRowCount(int(contacts.size()));
  for (int row = 0; row < int(contacts.size()); ++row) {
    const outcome::FoundContact& each = contacts[std::size_t(row)];
    QStringList texts{contactText(each), angleText(each)};
    if (each.isInside)
      texts << tr("%1 mm").arg(numberText(each.modiolus_mm, 2)) << scalaText(each)
            << frequencyText(each.greenwood_Hz) << frequencyText(each.spiralGanglion_Hz)
            << (each.filter_Hz > 0.0 ? tr("%1 kHz").arg(kilohertzText(each.filter_Hz)) : tr("–"))
            << (each.filter_Hz > 0.0 ? tr("%1 st").arg(mismatchText(each)) : mismatchText(each));
    else
      texts << tr("–") << tr("–") << tr("–") << tr("–") << tr("–") << tr("–");
    texts << placementText(each);
    for (int column = 0; column < texts.size(); ++column) {
      auto* item = new QTableWidgetItem(texts[column]);
      item->setToolTip(tr("Position known to %1 mm").arg(numberText(each.error_mm(), 2)));
      item->setData(Qt::UserRole, each.number);
      setItem(row, column, item);
    }
  }
  if (chosen >= 0 && chosen < rowCount()) selectRow(chosen);
  fitColumns(*this, foundWidths_px);
}

}  // namespace perilymph::gui
