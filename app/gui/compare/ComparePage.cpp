#include "ComparePage.h"

#include <QVBoxLayout>

#include "EmptyPage.h"
#include "Theme.h"

namespace perilymph::gui {

ComparePage::ComparePage(QWidget* parent) : QWidget(parent)
{
  setObjectName(QStringLiteral("comparePage"));
  auto* column = new QVBoxLayout(this);
  column->addWidget(new EmptyPage(tr("Insertions side by side"),
                                  tr("Choose two or more on the page Sessions and press Compare: "
                                     "their forces over travel stand here on common axes, with "
                                     "the printed forces of the published experiment."),
                                  this));
}

}  // namespace perilymph::gui
