// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/Catalog.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlReader.h"

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* label) { return QCoreApplication::translate("perilymph::gui", label); }

}  // namespace

QString summaryOf(const electrode::ArrayDesign& array)
{
  const auto& curvature = array.restCurvature.value;
  const bool isCurved = std::any_of(curvature.begin(), curvature.end(),
                                    [](Curvature value) { return value.si() != 0.0; });
  const QString shape = isCurved ? tr("precurved") : tr("straight");
  const QStringList label{tr("%1 mm").arg(numberText(inMillimeters(array.insertable), 1)), shape,
                          tr("%1 contacts").arg(array.contactsFromTip.size())};
  return label.join(QStringLiteral(" · "));
}

std::vector<CatalogArray> catalogArrays()
{
  std::vector<std::pair<electrode::ArrayDesign, QString>> arrays;
  for (const std::string& name : shippedNames("plugins/electrodes")) {
    const auto file = findByName("array", "plugins/electrodes", name);
    if (!file) continue;
    auto array = electrode::loadArray(*file);
    if (array) arrays.emplace_back(*std::move(array), QString::fromStdString(name));
  }
  std::sort(arrays.begin(), arrays.end(), [](const auto& one, const auto& other) {
    return std::tie(one.first.maker, one.first.insertable, one.first.name) <
           std::tie(other.first.maker, other.first.insertable, other.first.name);
  });
  std::vector<CatalogArray> catalog;
  catalog.reserve(arrays.size());
  for (const auto& [array, name] : arrays)
    catalog.push_back({name, QString::fromStdString(array.name),
                       QString::fromStdString(array.maker), summaryOf(array),
                       QString::fromStdString(array.note).simplified()});
  return catalog;
}

std::vector<CatalogFriction> catalogFrictions()
{
  std::vector<CatalogFriction> catalog;
  for (const std::string& name : shippedNames("resources/friction")) {
    const auto file = findByName("friction", "resources/friction", name);
    if (!file) continue;
    auto reader = TomlReader::open(*file);
    if (!reader) continue;
    const std::string title = reader->text("title", name);
    const std::string source = reader->table("coefficients").text("source", "");
    catalog.push_back(
        {QString::fromStdString(name), dataText(title), QString::fromStdString(source)});
  }
  return catalog;
}

}  // namespace perilymph::gui
