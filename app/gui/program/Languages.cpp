#include "gui/program/Languages.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

// Outside of every namespace, where Qt looks for the resource.
static void initializeTranslations() { Q_INIT_RESOURCE(translations); }

namespace perilymph::gui {

void useLanguage(QCoreApplication& application, const QString& word)
{
  initializeTranslations();
  for (QTranslator* translator :
       application.findChildren<QTranslator*>(QString(), Qt::FindDirectChildrenOnly))
    delete translator;  // which takes itself out of the application

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
  // Qt's own words (names of keys) where the system has them, then ours.
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  add(QStringLiteral("qtbase"), QLibraryInfo::location(QLibraryInfo::TranslationsPath));
#else
  add(QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
#endif
  add(QStringLiteral("perilymph"), QStringLiteral(":/translations"));
}

}  // namespace perilymph::gui
