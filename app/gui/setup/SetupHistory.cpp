// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/SetupHistory.h"

#include <QStringList>
#include <algorithm>
#include <utility>

#include "gui/run/ScenarioDifference.h"
#include "gui/text/DataText.h"

namespace perilymph::gui {

class SetupCommand : public QUndoCommand {
public:
  SetupCommand(SetupHistory& history, Setup before, Setup after, SetupField field, int epoch,
               const QString& label)
      : QUndoCommand(label),
        history_(history),
        before_(std::move(before)),
        after_(std::move(after)),
        field_(field),
        epoch_(epoch)
  {
  }

  void redo() override { history_.now_ = after_; }
  void undo() override { history_.now_ = before_; }
  int id() const override { return static_cast<int>(field_); }
  const Setup& before() const { return before_; }
  const Setup& after() const { return after_; }
  SetupHistory::Step step() const { return {before_, after_, field_, epoch_, text()}; }

  bool mergeWith(const QUndoCommand* other) override
  {
    const auto* later = dynamic_cast<const SetupCommand*>(other);
    if (later == nullptr || later->field_ != field_ || later->epoch_ != epoch_) return false;
    after_ = later->after_;
    setText(later->text());
    // returning to the previous state is not a change
    setObsolete(after_.scenario.text() == before_.scenario.text());
    return true;
  }

private:
  SetupHistory& history_;
  Setup before_, after_;
  SetupField field_;
  int epoch_;
};

SetupHistory::SetupHistory(QObject* parent) : QObject(parent) {}

void SetupHistory::begin(Setup setup, SetupOrigin::Kind kind)
{
  stack_.clear();
  now_ = setup;
  origin_ = {std::move(setup), kind};
  Q_EMIT setupChanged();
}

SetupHistory::Memory SetupHistory::memory() const
{
  Memory memory{origin_, now_, {}, stack_.index()};
  for (int i = 0; i < stack_.count(); ++i)
    memory.steps.push_back(static_cast<const SetupCommand&>(*stack_.command(i)).step());
  return memory;
}

void SetupHistory::resume(const Memory& memory)
{
  stack_.clear();
  origin_ = memory.origin;
  for (const Step& step : memory.steps) {
    stack_.push(
        new SetupCommand(*this, step.before, step.after, step.field, step.epoch, step.text));
    epoch_ = std::max(epoch_, step.epoch);
  }
  stack_.setIndex(memory.index);
  now_ = memory.now;
  Q_EMIT setupChanged();
}

bool SetupHistory::isModified() const
{
  return origin_.kind == SetupOrigin::Kind::preset &&
         !differingKeys(origin_.setup.scenario, now_.scenario).empty();
}

QString SetupHistory::changedText() const
{
  QStringList label;
  for (const std::string& word : differingText(origin_.setup.scenario, now_.scenario))
    label << dataText(word);
  return label.join(QStringLiteral(", "));
}

void SetupHistory::change(const SetupChange& change)
{
  auto made = changed(now_, origin_, change);
  if (!made) {
    Q_EMIT setupChanged();  // the fields show the current values again
    Q_EMIT refused(dataText(made.error().message));
    return;
  }
  if (made->scenario.text() == now_.scenario.text()) return;
  push(*std::move(made), change.field, change.text);
}

void SetupHistory::restore()
{
  if (now_.scenario.text() == origin_.setup.scenario.text()) return;
  push(origin_.setup, SetupField::preset, tr("restore the preset"));
}

void SetupHistory::push(Setup after, SetupField field, const QString& label)
{
  stack_.push(new SetupCommand(*this, now_, std::move(after), field, epoch_, label));
  Q_EMIT setupChanged();
}

void SetupHistory::undo()
{
  stack_.undo();
  Q_EMIT setupChanged();
}

void SetupHistory::redo()
{
  stack_.redo();
  Q_EMIT setupChanged();
}

void SetupHistory::goTo(const std::string& scenarioText)
{
  if (now_.scenario.text() == scenarioText) return;
  int place = -1;
  for (int i = 0; i < stack_.count(); ++i) {
    const auto& each = static_cast<const SetupCommand&>(*stack_.command(i));
    if (i == 0 && each.before().scenario.text() == scenarioText) place = 0;
    if (each.after().scenario.text() == scenarioText) place = i + 1;
  }
  stack_.setIndex(std::max(place, 0));
  Q_EMIT setupChanged();
}

}  // namespace perilymph::gui
