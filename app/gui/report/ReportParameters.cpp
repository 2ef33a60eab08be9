// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/ReportParameters.h"

#include <QCoreApplication>
#include <QStringList>
#include <cmath>
#include <map>
#include <string_view>

#include "gui/setup/Catalog.h"
#include "gui/text/Numbers.h"

namespace perilymph::gui {

namespace {

/// A parameter by its key: its name, and its unit if it is a number.
struct ParameterName {
  const char* key;
  const char* name;
  const char* unit = "";
};

constexpr ParameterName parameterNames[] = {
    {"anatomy", QT_TRANSLATE_NOOP("ReportParameters", "Anatomy")},
    {"side", QT_TRANSLATE_NOOP("ReportParameters", "Ear")},
    {"patient_numbers.st_length_mm", QT_TRANSLATE_NOOP("ReportParameters", "Organ of Corti length"),
     "mm"},
    {"patient_numbers.rw_width_mm",
     QT_TRANSLATE_NOOP("ReportParameters", "Scala width at round window"), "mm"},
    {"patient_numbers.rw_height_mm",
     QT_TRANSLATE_NOOP("ReportParameters", "Scala height at round window"), "mm"},
    {"patient_numbers.a_mm", QT_TRANSLATE_NOOP("ReportParameters", "A: basal-turn diameter"), "mm"},
    {"patient_numbers.b_mm", QT_TRANSLATE_NOOP("ReportParameters", "B: basal-turn width"), "mm"},
    {"patient_numbers.h_mm", QT_TRANSLATE_NOOP("ReportParameters", "H: cochlear height"), "mm"},
    {"patient_numbers.a_sd_mm",
     QT_TRANSLATE_NOOP("ReportParameters", "Standard deviation of the error of A"), "mm"},
    {"patient_numbers.b_sd_mm",
     QT_TRANSLATE_NOOP("ReportParameters", "Standard deviation of the error of B"), "mm"},
    {"patient_numbers.h_sd_mm",
     QT_TRANSLATE_NOOP("ReportParameters", "Standard deviation of the error of H"), "mm"},
    {"lead_in_mm",
     QT_TRANSLATE_NOOP("ReportParameters", "Straight lead-in before the round window"), "mm"},
    {"opening", QT_TRANSLATE_NOOP("ReportParameters", "Opening")},
    {"cochleostomy_diameter_mm", QT_TRANSLATE_NOOP("ReportParameters", "Cochleostomy diameter"),
     "mm"},
    {"opening_outward_mm",
     QT_TRANSLATE_NOOP("ReportParameters", "Offset of the opening, toward the outer wall"), "mm"},
    {"opening_vertical_mm",
     QT_TRANSLATE_NOOP("ReportParameters", "Offset of the opening, toward the roof"), "mm"},
    {"passage_mm", QT_TRANSLATE_NOOP("ReportParameters", "Length of the drilled passage"), "mm"},
    {"passage_modulus_MPa",
     QT_TRANSLATE_NOOP("ReportParameters", "Modulus of the array in the passage"), "MPa"},
    {"passage_friction", QT_TRANSLATE_NOOP("ReportParameters", "Friction in the passage")},
    {"rib_exit_loss",
     QT_TRANSLATE_NOOP("ReportParameters", "Energy lost where a rib leaves the passage")},
    {"approach_tilt_deg", QT_TRANSLATE_NOOP("ReportParameters", "Approach angle, tilt"), "°"},
    {"approach_turn_deg", QT_TRANSLATE_NOOP("ReportParameters", "Approach angle, rotation"), "°"},
    {"free_length_mm",
     QT_TRANSLATE_NOOP("ReportParameters", "Free length between opening and forceps"), "mm"},
    {"technique", QT_TRANSLATE_NOOP("ReportParameters", "Technique")},
    {"speed_mm_s", QT_TRANSLATE_NOOP("ReportParameters", "Speed of the scripted insertion"),
     "mm/s"},
    {"start_inside_mm", QT_TRANSLATE_NOOP("ReportParameters", "Insertion depth at the start"),
     "mm"},
    {"stop_travel_mm", QT_TRANSLATE_NOOP("ReportParameters", "Travel at which the insertion stops"),
     "mm"},
    {"withdraw", QT_TRANSLATE_NOOP("ReportParameters", "Withdrawal after the insertion")},
    {"stylet_pull_mm_s", QT_TRANSLATE_NOOP("ReportParameters", "Speed of stylet withdrawal"),
     "mm/s"},
    {"friction", QT_TRANSLATE_NOOP("ReportParameters", "Friction law")},
    {"friction_static", QT_TRANSLATE_NOOP("ReportParameters", "Static friction coefficient")},
    {"friction_dynamic", QT_TRANSLATE_NOOP("ReportParameters", "Kinetic friction coefficient")},
    {"friction_stopping",
     QT_TRANSLATE_NOOP("ReportParameters", "Coefficient below which sliding stops")},
    {"friction_shared_sd_log",
     QT_TRANSLATE_NOOP("ReportParameters", "SD of ln friction, common to all ears")},
    {"friction_ear_sd_log",
     QT_TRANSLATE_NOOP("ReportParameters", "SD of ln friction between ears")},
    {"friction_stribeck_mm_s", QT_TRANSLATE_NOOP("ReportParameters", "Stribeck speed of friction"),
     "mm/s"},
    {"friction_speed_mm_s", QT_TRANSLATE_NOOP("ReportParameters", "Speeds of the friction curve"),
     "mm/s"},
    {"friction_coefficient",
     QT_TRANSLATE_NOOP("ReportParameters", "Friction coefficients at these speeds")},
    {"relaxation_fraction",
     QT_TRANSLATE_NOOP("ReportParameters", "Fractions of the bending stiffness that relax")},
    {"relaxation_time_s", QT_TRANSLATE_NOOP("ReportParameters", "Their time constants"), "s"},
    {"film_relaxation_fraction",
     QT_TRANSLATE_NOOP("ReportParameters", "Fraction of the friction that relaxes at rest")},
    {"film_relaxation_time_s", QT_TRANSLATE_NOOP("ReportParameters", "Its time constant"), "s"},
    {"wire_packing",
     QT_TRANSLATE_NOOP("ReportParameters", "Packing of the wires of straight arrays")},
    {"taper_fraction", QT_TRANSLATE_NOOP("ReportParameters", "Taper within the range of its file")},
    {"wire_yield_MPa", QT_TRANSLATE_NOOP("ReportParameters", "Yield stress of the wires"), "MPa"},
    {"stylet_yield_MPa", QT_TRANSLATE_NOOP("ReportParameters", "Yield stress of the stylet"),
     "MPa"},
    {"wall_stiffness_N_m", QT_TRANSLATE_NOOP("ReportParameters", "Wall stiffness, normal"), "N/m"},
    {"wall_lining_mm", QT_TRANSLATE_NOOP("ReportParameters", "Soft lining of the wall"), "mm"},
    {"wall_tangential_stiffness_N_m",
     QT_TRANSLATE_NOOP("ReportParameters", "Wall stiffness, tangential"), "N/m"},
    {"wall_section_delay_ms",
     QT_TRANSLATE_NOOP("ReportParameters", "Delay of the section's reach at an oval wall"), "ms"},
    {"wall_edge_mm",
     QT_TRANSLATE_NOOP("ReportParameters", "Depth over which the wall stiffens behind the opening"),
     "mm"},
    {"rim_stiffness_N_m", QT_TRANSLATE_NOOP("ReportParameters", "Stiffness of the opening's rim"),
     "N/m"},
    {"membrane", QT_TRANSLATE_NOOP("ReportParameters", "Basilar membrane")},
    {"membrane_stiffness_N_m",
     QT_TRANSLATE_NOOP("ReportParameters", "Basilar membrane stiffness, if soft"), "N/m"},
    {"partition_strength_N",
     QT_TRANSLATE_NOOP("ReportParameters",
                       "Strength of the cochlear partition, 0 if it never ruptures"),
     "mN"},
    {"stiffness_scale",
     QT_TRANSLATE_NOOP("ReportParameters", "Calibrated scale of the array stiffness")},
    {"residual_curvature_fraction",
     QT_TRANSLATE_NOOP("ReportParameters", "Calibrated residual curvature with stylet")},
    {"model", QT_TRANSLATE_NOOP("ReportParameters", "Array model")},
    {"nodes", QT_TRANSLATE_NOOP("ReportParameters", "Nodes of the array model")},
    {"dt_ms", QT_TRANSLATE_NOOP("ReportParameters", "Time step"), "ms"},
    {"coupling", QT_TRANSLATE_NOOP("ReportParameters", "Coupling to the input device")},
    {"coupling_stiffness_N_m",
     QT_TRANSLATE_NOOP("ReportParameters", "Coupling stiffness, if a spring"), "N/m"},
    {"coupling_damping_N_s_m",
     QT_TRANSLATE_NOOP("ReportParameters", "Coupling damping, if a spring"), "N·s/m"},
    {"force_scale", QT_TRANSLATE_NOOP("ReportParameters", "Force feedback gain")},
    {"stop_force_N", QT_TRANSLATE_NOOP("ReportParameters", "Force limit of the surgeon, 0 if none"),
     "mN"},
    {"seed", QT_TRANSLATE_NOOP("ReportParameters", "Random seed")}};

/// Values that are words.
constexpr const char* valueNames[][2] = {
    {"published", QT_TRANSLATE_NOOP("ReportParameters", "published scala tympani")},
    {"mean", QT_TRANSLATE_NOOP("ReportParameters", "average of 15 human cochleae")},
    {"clark", QT_TRANSLATE_NOOP("ReportParameters", "Clark spiral")},
    {"right", QT_TRANSLATE_NOOP("ReportParameters", "right")},
    {"left", QT_TRANSLATE_NOOP("ReportParameters", "left")},
    {"none", QT_TRANSLATE_NOOP("ReportParameters", "wide opening (no edge contact)")},
    {"round-window", QT_TRANSLATE_NOOP("ReportParameters", "round window")},
    {"cochleostomy", QT_TRANSLATE_NOOP("ReportParameters", "cochleostomy")},
    {"standard", QT_TRANSLATE_NOOP("ReportParameters", "standard")},
    {"aos", QT_TRANSLATE_NOOP("ReportParameters", "advance off-stylet")},
    {"rigid", QT_TRANSLATE_NOOP("ReportParameters", "rigid")},
    {"soft", QT_TRANSLATE_NOOP("ReportParameters", "soft")},
    {"true", QT_TRANSLATE_NOOP("ReportParameters", "yes")},
    {"false", QT_TRANSLATE_NOOP("ReportParameters", "no")},
    {"spring", QT_TRANSLATE_NOOP("ReportParameters", "spring")},
    {"rod", QT_TRANSLATE_NOOP("ReportParameters", "elastic rod")},
    {"points", QT_TRANSLATE_NOOP("ReportParameters", "point set (published)")}};

QString tr(const char* text) { return QCoreApplication::translate("ReportParameters", text); }

/// A number with the decimals that it has, at most six; any other text unchanged.
QString plainText(QString text)
{
  bool isNumber = false;
  const double number = text.toDouble(&isNumber);
  if (isNumber && text.contains(QLatin1Char('.'))) {
    int decimals = 1;
    const auto rest = [number](int places) {
      const double power = std::pow(10.0, places);
      return std::fabs(number - std::round(number * power) / power);
    };
    while (decimals < 6 && rest(decimals) > 1e-9) ++decimals;
    text = numberText(number, decimals);
  }
  return text;
}

/// A value in TOML format, for people.
QString valueText(const std::string& value, const char* unit)
{
  QString text = QString::fromStdString(value);
  text.remove(QLatin1Char('"'));
  for (const auto& [word, name] : valueNames)
    if (text == QLatin1String(word)) return tr(name);
  for (const CatalogFriction& friction : catalogFrictions())
    if (text == friction.name) return friction.title;
  bool isForce = false;
  const double force = text.toDouble(&isForce);
  // forces are in mN on every page
  if (isForce && std::string_view(unit) == "mN")
    return numberText(1e3 * force, 0) + QStringLiteral(" mN");
  QStringList numbers;
  for (const QString& part : text.remove(QLatin1Char('[')).remove(QLatin1Char(']')).split(", "))
    numbers << plainText(part);
  text = numbers.join(QStringLiteral("; "));
  const QString sign = QString::fromUtf8(unit);
  if (sign.isEmpty() || sign == QStringLiteral("°")) return text + sign;
  return text + QLatin1Char(' ') + sign;
}

}  // namespace

std::vector<std::pair<QString, QString>> parametersOf(const session::Scenario& scenario)
{
  std::map<std::string, std::string> values(scenario.values().begin(), scenario.values().end());
  std::vector<std::pair<QString, QString>> parameters;
  for (const ParameterName& each : parameterNames) {
    const auto found = values.find(each.key);
    if (found != values.end())
      parameters.emplace_back(tr(each.name), valueText(found->second, each.unit));
  }
  return parameters;
}

}  // namespace perilymph::gui
