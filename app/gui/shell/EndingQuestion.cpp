// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/EndingQuestion.h"

#include <QCoreApplication>

#include "gui/pages/insert/InsertPage.h"
#include "gui/parts/Notice.h"
#include "gui/parts/Numbers.h"
#include "gui/run/WorkflowPredicates.h"

namespace perilymph::gui {

namespace {

QString translated(const char* text) { return QCoreApplication::translate("EndingQuestion", text); }

}  // namespace

bool EndingQuestion::isNeeded() const
{
  return !isBetweenInsertions(stateOf(insertion_.control()));
}

void EndingQuestion::askBefore(const QString& action, const std::function<void()>& act)
{
  if (!isNeeded()) return act();
  const Length travel = Length::fromSi(insertion_.control().now().output.travel);
  notice_.ask(
      translated(QT_TRANSLATE_NOOP("EndingQuestion",
                                   "An insertion is in progress at %1 mm. It is recorded up "
                                   "to here."))
          .arg(numberText(inMillimeters(travel), 1)),
      action, translated(QT_TRANSLATE_NOOP("EndingQuestion", "Keep inserting")), [this, act] {
        insertion_.reset();
        act();
      });
}

}  // namespace perilymph::gui
