#include "SessionsPage.h"

#include <QVBoxLayout>

#include "EmptyPage.h"
#include "Theme.h"

namespace perilymph::gui {

SessionsPage::SessionsPage(QWidget* parent) : QWidget(parent)
{
  setObjectName(QStringLiteral("sessionsPage"));
  auto* column = new QVBoxLayout(this);
  column->addWidget(new EmptyPage(tr("No insertion has been recorded yet"),
                                  tr("Every insertion is kept by itself. Here it can be found "
                                     "again, replayed, compared and written as a report."),
                                  this));
}

}  // namespace perilymph::gui
