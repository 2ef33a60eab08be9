// The devices of the main window: which there are, and how the hand in use is doing.

#include "gui/pages/devices/DevicePage.h"
#include "gui/pages/insert/SidePanel.h"
#include "gui/parts/DeviceRate.h"
#include "gui/scene/OperationView.h"
#include "gui/shell/KeyList.h"
#include "gui/shell/MainWindow.h"

namespace perilymph::gui {

void MainWindow::toggleDevices()
{
  const bool isShown = !devices_->isVisible();
  devices_->setVisible(isShown);
  if (isShown) {
    showDevice();
    devices_->refresh();
    devices_->move(view_->rect().center() - devices_->rect().center());
    devices_->raise();
  }
  // Asking for the page checks its choice; what is chosen is the hand in use.
  side_->setHand(control_.hand(), QString::fromStdString(control_.handName()));
}

void MainWindow::useDevice(const device::FoundDevice& found)
{
  control_.choose(found);
  prepare(InputSource::device);
}

void MainWindow::usePlugin(const std::filesystem::path& library)
{
  control_.choose(library);
  prepare(InputSource::device);
}

void MainWindow::showDevice()
{
  const auto health = control_.deviceHealth();
  deviceText_ = deviceRateText(health);
  if (!devices_->isVisible()) return;
  devices_->showHand(QString::fromStdString(control_.handName()), health, control_.now(),
                     QString::fromStdString(control_.couplingText()));
}

}  // namespace perilymph::gui
