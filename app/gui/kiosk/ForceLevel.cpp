// SPDX-License-Identifier: BSD-3-Clause
#include "gui/kiosk/ForceLevel.h"

#include <QCoreApplication>

#include "gui/text/Numbers.h"
#include "gui/widgets/Theme.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

namespace {

QString translated(const char* text) { return QCoreApplication::translate("ForceLevel", text); }

}  // namespace

ForceLevel levelOf(double force_N, const analysis::PrintedRange& measured)
{
  if (force_N < measured.low) return ForceLevel::gentle;
  return force_N > measured.high ? ForceLevel::tooMuch : ForceLevel::firm;
}

QString wordOf(ForceLevel level)
{
  switch (level) {
    case ForceLevel::gentle:
      return translated(QT_TRANSLATE_NOOP("ForceLevel", "gentle"));
    case ForceLevel::firm:
      return translated(QT_TRANSLATE_NOOP("ForceLevel", "firm"));
    case ForceLevel::tooMuch:
      return translated(QT_TRANSLATE_NOOP("ForceLevel", "too much"));
  }
  return {};
}

QString signOf(ForceLevel level)
{
  switch (level) {
    case ForceLevel::gentle:
      return QStringLiteral("●");
    case ForceLevel::firm:
      return QStringLiteral("▲");
    case ForceLevel::tooMuch:
      return QStringLiteral("■");
  }
  return {};
}

QColor colorOf(ForceLevel level)
{
  switch (level) {
    case ForceLevel::gentle:
      return shownTheme().accent;
    case ForceLevel::firm:
      return shownTheme().warning;
    case ForceLevel::tooMuch:
      return shownTheme().alarm;
  }
  return {};
}

QString sentenceOf(ForceLevel level)
{
  switch (level) {
    case ForceLevel::gentle:
      return translated(
          QT_TRANSLATE_NOOP("ForceLevel", "Gentle: below the forces measured in patients."));
    case ForceLevel::firm:
      return translated(
          QT_TRANSLATE_NOOP("ForceLevel", "Firm: like the forces measured in patients."));
    case ForceLevel::tooMuch:
      return translated(
          QT_TRANSLATE_NOOP("ForceLevel", "Too much: above the forces measured in patients."));
  }
  return {};
}

QString levelSource(const analysis::PrintedRange& measured)
{
  return translated(QT_TRANSLATE_NOOP("ForceLevel",
                                      "Peak forces measured in patients: %1–%2 mN (Rau et al. "
                                      "2024). This comparison is not a safety assessment."))
      .arg(numberText(inMillinewtons(newtons(measured.low)), 0),
           numberText(inMillinewtons(newtons(measured.high)), 0));
}

}  // namespace perilymph::gui
