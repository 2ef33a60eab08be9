// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/visualization/Picture.h"

#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkWindowToImageFilter.h>

#include "PrivateDisplay.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::visualization {
namespace {

constexpr int minPixels = 64;
constexpr int maxPixels = 8192;

Result<void> check(const PictureRequest& request)
{
  if (request.scala == nullptr)
    return Error{"There is no scala tympani to draw. Name a scenario, a patient or a preset."};
  for (const int pixels : {request.width, request.height})
    if (pixels < minPixels || pixels > maxPixels)
      return Error{"A picture of %1 x %2 pixels cannot be drawn; each must be 64 to 8192.",
                   request.width, request.height};
  if (request.file.extension() != ".png")
    return Error{"The picture %1 must end in .png.", request.file};
  return {};
}

Result<void> draw(const PictureRequest& request)
{
  InsertionScene scene(*request.scala, request.array.value_or(electrode::ArrayDesign{}),
                       request.side, Quality::software, request.style);
  if (request.now != nullptr) scene.show(*request.now);
  scene.lookFrom(request.view);
  scene.setScale(request.height / 960.0);

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetSize(request.width, request.height);
  scene.attachTo(*window);
  window->Render();

  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  return writeWhole(request.file, [&](const std::filesystem::path& neighbor) {
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(grab->GetOutputPort());
    writer->SetFileName(neighbor.c_str());
    writer->Write();
    return writer->GetErrorCode() == 0;
  });
}

}  // namespace

Result<void> canRender() { return probeDisplay(); }

Result<void> renderPicture(const PictureRequest& request)
{
  if (const Result<void> checked = check(request); !checked) return checked;
  if (probeDisplay()) return draw(request);

  Result<PrivateDisplay> display = PrivateDisplay::start();
  if (!display) return display.error();
  if (const Result<void> probed = probeDisplay(); !probed) return probed;
  return draw(request);
}

}  // namespace perilymph::visualization
