// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/GhostControl.h"

#include "gui/scene/OperationView.h"

namespace perilymph::gui {

void GhostControl::setReference(const std::optional<ReferenceInsertion>& reference)
{
  reference_ = reference;
  draw();
}

void GhostControl::setCurrent(const session::ScenarioSubject& current)
{
  current_ = current;
  draw();
}

void GhostControl::follow(double depth)
{
  if (depth == depth_) return;
  depth_ = depth;
  if (isShown()) draw();
}

bool GhostControl::isShown() const
{
  return reference_ && reference_->shapes && reference_->subject.cochlea == current_.cochlea;
}

void GhostControl::draw()
{
  if (!isShown()) return view_.showGhost({}, {});
  view_.showGhost(reference_->shapes->array, reference_->shapes->nodesAt(depth_));
}

}  // namespace perilymph::gui
