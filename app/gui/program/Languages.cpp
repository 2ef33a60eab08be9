// SPDX-License-Identifier: BSD-3-Clause
#include "gui/program/Languages.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

// In the global namespace, where Qt expects the resource.
static void initializeTranslations() { Q_INIT_RESOURCE(translations); }

namespace perilymph::gui {

void useLanguage(QCoreApplication& application, const QString& word)
{
  initializeTranslations();
  for (QTranslator* translator :
       application.findChildren<QTranslator*>(QString(), Qt::FindDirectChildrenOnly))
    delete translator;  // its destructor removes it from the application

  const QLocale locale = word == QLatin1String("system") ? QLocale::system() : QLocale(word);
  QLocale::setDefault(locale);
  if (locale.language() == QLocale::English || locale.language() == QLocale::C) return;
  const auto add = [&](const QString& name, const QString& folder) {
    auto* translator = new QTranslator(&application);
    if (translator->load(locale, name, QStringLiteral("_"), folder))
      QCoreApplication::installTranslator(translator);
    else
      delete translator;
  };
  // Qt's own texts (names of keys) if installed, then those of this program.
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  add(QStringLiteral("qtbase"), QLibraryInfo::location(QLibraryInfo::TranslationsPath));
#else
  add(QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
#endif
  add(QStringLiteral("perilymph"), QStringLiteral(":/translations"));
}

}  // namespace perilymph::gui
