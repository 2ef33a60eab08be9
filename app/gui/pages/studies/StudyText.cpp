// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/studies/StudyText.h"

#include <QCoreApplication>
#include <QLocale>
#include <map>

#include "gui/setup/Catalog.h"
#include "gui/text/Numbers.h"
#include "perilymph/session/Csv.h"

namespace perilymph::gui {

namespace {

constexpr int maxDigits = 9;  // of a number in a list

struct Name {
  const char* key;
  const char* text;
};

// lupdate reads the texts here.
constexpr Name quantities[] = {
    {"A_mm", QT_TRANSLATE_NOOP("Study", "A: basal-turn diameter, mm")},
    {"B_mm", QT_TRANSLATE_NOOP("Study", "B: basal-turn width, mm")},
    {"cdl_oc_mm", QT_TRANSLATE_NOOP("Study", "cochlear duct length, mm")},
    {"st_length_mm", QT_TRANSLATE_NOOP("Study", "scala tympani length, mm")},
    {"angle_deg", QT_TRANSLATE_NOOP("Study", "angular insertion depth, °")},
    {"coverage_percent", QT_TRANSLATE_NOOP("Study", "cochlear coverage, %")},
    {"depth_mm", QT_TRANSLATE_NOOP("Study", "insertion depth, mm")},
    {"max_depth_mm", QT_TRANSLATE_NOOP("Study", "maximum insertion depth, mm")},
    {"peak_mN", QT_TRANSLATE_NOOP("Study", "peak insertion force, mN")},
    {"peak_depth_mm", QT_TRANSLATE_NOOP("Study", "depth of the peak force, mm")},
    {"end_mN", QT_TRANSLATE_NOOP("Study", "final insertion force, mN")},
    {"partition_mN", QT_TRANSLATE_NOOP("Study", "maximum partition force, mN")},
    {"speed_mm_s", QT_TRANSLATE_NOOP("Study", "speed, mm/s")},
    {"stop_force_mN", QT_TRANSLATE_NOOP("Study", "force limit, mN")},
    {"stop_force_N", QT_TRANSLATE_NOOP("Study", "force limit, mN")},
    {"start_inside_mm", QT_TRANSLATE_NOOP("Study", "depth at the start, mm")},
    {"stop_travel_mm", QT_TRANSLATE_NOOP("Study", "stop travel, mm")},
    {"approach_tilt_deg", QT_TRANSLATE_NOOP("Study", "approach angle, tilt, °")},
    {"approach_turn_deg", QT_TRANSLATE_NOOP("Study", "approach angle, rotation, °")},
    {"friction_static", QT_TRANSLATE_NOOP("Study", "static friction coefficient")},
    {"friction_dynamic", QT_TRANSLATE_NOOP("Study", "kinetic friction coefficient")},
    {"nodes", QT_TRANSLATE_NOOP("Study", "nodes of the array model")},
    {"dt_ms", QT_TRANSLATE_NOOP("Study", "time step, ms")},
};

constexpr Name settings[] = {
    {"ending", QT_TRANSLATE_NOOP("Study", "outcome")},
    {"array", QT_TRANSLATE_NOOP("Study", "array")},
    {"friction", QT_TRANSLATE_NOOP("Study", "friction")},
    {"technique", QT_TRANSLATE_NOOP("Study", "technique")},
    {"opening", QT_TRANSLATE_NOOP("Study", "opening")},
    {"membrane", QT_TRANSLATE_NOOP("Study", "basilar membrane")},
    {"model", QT_TRANSLATE_NOOP("Study", "array model")},
    {"coupling", QT_TRANSLATE_NOOP("Study", "input coupling")},
    {"anatomy", QT_TRANSLATE_NOOP("Study", "anatomy")},
};

constexpr Name levels[] = {
    {"finished", QT_TRANSLATE_NOOP("Study", "finished")},
    {"out_of_opening", QT_TRANSLATE_NOOP("Study", "slipped out of the opening")},
    {"stopped_by_resistance", QT_TRANSLATE_NOOP("Study", "stopped by resistance")},
    {"folded_tip", QT_TRANSLATE_NOOP("Study", "folded tip")},
    {"jammed", QT_TRANSLATE_NOOP("Study", "jammed")},
    {"buckled", QT_TRANSLATE_NOOP("Study", "buckled")},
    {"fault", QT_TRANSLATE_NOOP("Study", "stopped with a fault")},
    {"refused", QT_TRANSLATE_NOOP("Study", "could not be prepared")},
    {"standard", QT_TRANSLATE_NOOP("Study", "standard")},
    {"aos", QT_TRANSLATE_NOOP("Study", "advance off-stylet")},
    {"none", QT_TRANSLATE_NOOP("Study", "wide opening")},
    {"round-window", QT_TRANSLATE_NOOP("Study", "round window")},
    {"cochleostomy", QT_TRANSLATE_NOOP("Study", "cochleostomy")},
    {"rigid", QT_TRANSLATE_NOOP("Study", "rigid")},
    {"soft", QT_TRANSLATE_NOOP("Study", "soft")},
    {"spring", QT_TRANSLATE_NOOP("Study", "spring")},
    {"tissue", QT_TRANSLATE_NOOP("Study", "tissue-like")},
    {"mean", QT_TRANSLATE_NOOP("Study", "average")},
};

QString tr(const char* text) { return QCoreApplication::translate("Study", text); }

template <std::size_t Count>
const char* textOf(const Name (&names)[Count], const std::string& key)
{
  for (const Name& each : names)
    if (key == each.key) return each.text;
  return nullptr;
}

/// Titles of arrays and frictions by their names.
std::map<QString, QString> catalogTitles()
{
  std::map<QString, QString> titles;
  for (const CatalogFriction& friction : catalogFrictions()) titles[friction.name] = friction.title;
  for (const CatalogArray& array : catalogArrays()) titles[array.name] = array.title;
  return titles;
}

QString number(double value, int decimals) { return numberText(value, decimals); }

/// A number in a text of a file, with the window's decimal sign.
QString localNumber(const std::string& text)
{
  return QString::fromStdString(text).replace(QLatin1Char('.'), QLocale().decimalPoint());
}

}  // namespace

QString quantityTitle(const std::string& key)
{
  const char* text = textOf(quantities, key);
  return text != nullptr ? tr(text) : QString::fromStdString(key);
}

QString settingTitle(const std::string& key)
{
  const char* text = textOf(settings, key);
  return text != nullptr ? tr(text) : quantityTitle(key);
}

QString levelText(const std::string& level)
{
  const char* text = textOf(levels, level);
  if (text != nullptr) return tr(text);
  const QString name = QString::fromStdString(level);
  static std::map<QString, std::map<QString, QString>> byLanguage;
  const auto [titles, isNew] = byLanguage.try_emplace(settingTitle("friction"));
  if (isNew) titles->second = catalogTitles();
  if (const auto found = titles->second.find(name); found != titles->second.end())
    return found->second;
  bool isNumber = false;
  const double value = name.toDouble(&isNumber);
  if (isNumber && name.size() > maxDigits) return number(value, 3);  // drawn from a range
  if (isNumber) return localNumber(level);
  return level.empty() ? QStringLiteral("–") : QString::fromStdString(level);
}

QString valueText(const std::string& key, const std::string& value)
{
  if (key != "stop_force_N") return levelText(value);
  bool isNumber = false;
  const double force_N = QString::fromStdString(value).toDouble(&isNumber);
  return isNumber ? localNumber(session::shortestDecimal(force_N * 1e3)) : levelText(value);
}

QString selectionText(study::StudySelection selection)
{
  return selection == study::StudySelection::ran
             ? QCoreApplication::translate("Study", "all that ran")
             : QCoreApplication::translate("Study", "complete only");
}

QString unitOf(const std::string& key)
{
  const QString title = quantityTitle(key);
  const auto comma = title.lastIndexOf(QStringLiteral(", "));
  return comma < 0 ? QString() : title.mid(comma + 2);
}

QString inTheList(const QString& words) { return words.left(1).toUpper() + words.mid(1); }

QString durationText(double seconds)
{
  constexpr double minute_s = 60.0, hour_s = 3600.0;
  if (seconds < 100.0) return QCoreApplication::translate("Study", "%1 s").arg(number(seconds, 0));
  if (seconds < 100.0 * minute_s)
    return QCoreApplication::translate("Study", "%1 min").arg(number(seconds / minute_s, 0));
  return QCoreApplication::translate("Study", "%1 h").arg(number(seconds / hour_s, 1));
}

QString cochleaText(const std::string& name)
{
  const QString text = QString::fromStdString(name);
  const QString drawn = QStringLiteral("virtual ");
  if (text.startsWith(drawn))
    return QCoreApplication::translate("Study", "Simulated cochlea %1").arg(text.mid(drawn.size()));
  return name == "mean" ? QCoreApplication::translate("Study", "Average cochlea") : text;
}

std::vector<std::pair<QString, QString>> valuesOf(const study::StudyResult& result)
{
  const analysis::InsertionRun& found = result.insertion;
  std::vector<std::pair<QString, QString>> values{
      {QCoreApplication::translate("Study", "insertion"), QString::number(result.number)},
      {QCoreApplication::translate("Study", "cochlea"), cochleaText(result.cochlea)},
      {settingTitle("ending"), levelText(haptics::nameOf(found.end))}};
  if (!found.reason.empty())
    values.emplace_back(QCoreApplication::translate("Study", "reason"),
                        QString::fromStdString(found.reason));
  for (const auto& [key, value] : result.settings)
    values.emplace_back(settingTitle(key), valueText(key, value));
  const auto add = [&values](const char* key, double value, int decimals) {
    values.emplace_back(quantityTitle(key), number(value, decimals));
  };
  add("A_mm", result.a_mm, 2);
  add("B_mm", result.b_mm, 2);
  add("cdl_oc_mm", result.ductLength_mm(), 1);
  add("st_length_mm", result.scalaLength_mm, 1);
  add("depth_mm", inMillimeters(found.depth), 2);
  add("max_depth_mm", inMillimeters(found.maxDepth), 2);
  add("angle_deg", inDegrees(found.apical), 0);
  add("coverage_percent", 100.0 * found.coverage, 0);
  add("peak_mN", inMillinewtons(found.peak.force), 1);
  add("peak_depth_mm", inMillimeters(found.peak.depth), 2);
  add("end_mN", inMillinewtons(found.endForce), 1);
  add("partition_mN", inMillinewtons(found.partition), 1);
  for (auto& [name, value] : values) name = inTheList(name);
  return values;
}

}  // namespace perilymph::gui
