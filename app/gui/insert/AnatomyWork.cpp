#include "AnatomyWork.h"

#include "perilymph/foundation/RealTime.h"

namespace perilymph::gui {

AnatomyWork::AnatomyWork(QObject* parent) : QObject(parent) { thread_.setMaxThreadCount(1); }

AnatomyWork::~AnatomyWork() { thread_.waitForDone(); }

void AnatomyWork::build(const session::Scenario& scenario, Answer answer)
{
  isBusy_ = true;
  const int request = ++request_;
  thread_.start([this, scenario, answer = std::move(answer), request]() mutable {
    registerThreadRole(ThreadRole::worker);
    auto built = session::buildAnatomy(scenario);
    QMetaObject::invokeMethod(
        this,
        [this, built = std::move(built), answer = std::move(answer), request] {
          if (request != request_) return;
          isBusy_ = false;
          answer(built);
        },
        Qt::QueuedConnection);
  });
}

void AnatomyWork::forget()
{
  ++request_;
  isBusy_ = false;
}

}  // namespace perilymph::gui
