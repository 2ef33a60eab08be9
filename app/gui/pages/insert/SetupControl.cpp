// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/SetupControl.h"

#include <utility>

#include "gui/run/ScenarioDifference.h"
#include "gui/setup/StopTravel.h"
#include "gui/text/DataText.h"

namespace perilymph::gui {

SetupControl::SetupControl(const InsertionControl& control, QObject* parent)
    : QObject(parent),
      control_(control),
      history_(new SetupHistory(this)),
      firstBuilder_(control.cochleae(), this),
      builder_(control.cochleae(), this)
{
  firstBuilder_.build(control.scenario(), nullptr,
                      [this](const Result<InsertionControl::Parts>& built) {
                        if (built) first_ = *built;
                      });
}

std::optional<InsertionControl::Parts> SetupControl::takeFirst()
{
  firstBuilder_.finish();
  return std::exchange(first_, std::nullopt);
}

QString SetupControl::change(const SetupChange& change)
{
  const session::Scenario before = history_->now().scenario;
  history_->change(change);
  return stopChangeText(before, history_->now().scenario);
}

void SetupControl::follow()
{
  const session::Scenario& wanted = history_->now().scenario;
  const session::Scenario& shown = control_.scenario();
  if (wanted.text() == shown.text()) {
    builder_.cancel();
    return followed();
  }
  if (haveSameModel(wanted, shown)) {
    builder_.cancel();
    return ready(wanted, std::nullopt);
  }
  build(wanted, [this, wanted](const InsertionControl::Parts& parts) { ready(wanted, parts); });
}

void SetupControl::build(const session::Scenario& scenario,
                         std::function<void(const InsertionControl::Parts&)> use)
{
  const bool isSameCochlea = haveSameCochlea(scenario, control_.scenario());
  builder_.build(scenario, isSameCochlea ? control_.sharedAnatomy() : nullptr,
                 [this, use = std::move(use)](const Result<InsertionControl::Parts>& built) {
                   if (built) return use(*built);
                   giveUp();
                   failed(dataText(built.error().message));
                 });
  Q_EMIT followed();
}

bool SetupControl::cancel()
{
  if (!isBuilding()) return false;
  giveUp();
  return true;
}

void SetupControl::giveUp()
{
  abandon();
  history_->goTo(control_.scenario().text());  // the panel shows the actual setup
  Q_EMIT followed();
}

void SetupControl::abandon()
{
  builder_.cancel();
  isStartRequested_ = false;
}

}  // namespace perilymph::gui
