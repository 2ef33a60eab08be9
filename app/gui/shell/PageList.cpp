// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/PageList.h"

#include "gui/pages/compare/ComparePage.h"
#include "gui/pages/ct/CtPage.h"
#include "gui/pages/insert/InsertPage.h"
#include "gui/pages/insert/InsertionController.h"
#include "gui/pages/outcome/OutcomePage.h"
#include "gui/pages/outcomes/OutcomesPage.h"
#include "gui/pages/plan/PlanPage.h"
#include "gui/pages/sessions/SessionsPage.h"
#include "gui/pages/start/StartPage.h"
#include "gui/pages/studies/StudiesPage.h"
#include "gui/pages/validate/ValidatePage.h"

namespace perilymph::gui {

PageList standardPages()
{
  using Insertion = InsertionController&;
  using Parent = QWidget*;
  return {
      [](Insertion i, Parent parent) { return new StartPage(i.control(), i.history(), parent); },
      [](Insertion i, Parent parent) { return new CtPage(i.control(), parent); },
      [](Insertion, Parent parent) { return new PlanPage(parent); },
      [](Insertion i, Parent parent) { return new InsertPage(i, parent); },
      [](Insertion i, Parent parent) { return new OutcomePage(i.control(), parent); },
      [](Insertion, Parent parent) { return new ComparePage(parent); },
      [](Insertion, Parent parent) { return new ValidatePage(parent); },
      [](Insertion i, Parent parent) { return new SessionsPage(i.control(), parent); },
      [](Insertion, Parent parent) { return new StudiesPage(parent); },
      [](Insertion, Parent parent) { return new OutcomesPage(parent); },
  };
}

}  // namespace perilymph::gui
