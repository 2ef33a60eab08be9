// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Keeps what VTK complains of away from the terminal.

#include <vtkCommand.h>
#include <vtkObject.h>

#include <initializer_list>

namespace perilymph::imaging {

/// Takes errors and warnings of VTK objects and remembers that there was one.
class ErrorCollector : public vtkCommand {
public:
  static ErrorCollector* New() { return new ErrorCollector; }
  void Execute(vtkObject*, unsigned long, void*) override { isAny = true; }

  void listenTo(std::initializer_list<vtkObject*> objects)
  {
    for (vtkObject* const object : objects) {
      object->AddObserver(vtkCommand::ErrorEvent, this);
      object->AddObserver(vtkCommand::WarningEvent, this);
    }
  }

  bool isAny = false;
};

}  // namespace perilymph::imaging
