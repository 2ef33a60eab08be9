// SPDX-License-Identifier: BSD-3-Clause
#include "WindowRig.h"

#include <QtTest/qtestspontaneevent.h>
#include <QAbstractItemView>
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <QWheelEvent>
#include <stdexcept>

#include "gui/widgets/Selector.h"

namespace perilymph::test {

namespace {

template <class Object>
Object& part(gui::MainWindow& window, const char* name)
{
  auto* found = window.findChild<Object*>(QLatin1String(name));
  if (found == nullptr) throw std::runtime_error(std::string("The window has no ") + name + ".");
  return *found;
}

session::Scenario published(const session::Overrides& overrides)
{
  auto scenario = session::loadScenario("contour-published", overrides);
  if (!scenario) throw std::runtime_error(scenario.error().message);
  return *scenario;
}

}  // namespace

const std::shared_ptr<gui::CochleaStore>& WindowRig::sharedCochleae()
{
  static const auto cochleae = std::make_shared<gui::CochleaStore>();
  return cochleae;
}

WindowRig::WindowRig(const session::Overrides& overrides,
                     std::optional<std::filesystem::path> record,
                     std::shared_ptr<gui::CochleaStore> cochleae, const gui::PageList& pages)
    : window_(std::make_unique<gui::MainWindow>(published(overrides), std::move(record),
                                                std::move(cochleae), pages))
{
  bool isShown = false;
  const QMetaObject::Connection shown =
      QObject::connect(window_.get(), &gui::MainWindow::firstFrameShown, window_.get(),
                       [&isShown] { isShown = true; });
  window_->show();
  const auto opened = window_->open();
  if (!opened) throw std::runtime_error(opened.error().message);
  if (!waitUntil([&] { return isShown; })) throw std::runtime_error("No frame came.");
  QObject::disconnect(shown);  // a test may say it again
}

void WindowRig::click(const char* name)
{
  QTest::mouseClick(&part<QAbstractButton>(*window_, name), Qt::LeftButton);
}

void WindowRig::choose(const char* selector, const char* value)
{
  auto& list = part<gui::Selector>(*window_, selector);
  const int wanted = list.findData(QLatin1String(value));
  if (wanted < 0) throw std::runtime_error(std::string("There is no choice ") + value + ".");
  list.setFocus();
  QTest::keyClick(&list, Qt::Key_Space);
  if (!waitUntil([&] { return list.view()->isVisible(); }))
    throw std::runtime_error("No list opened.");
  // as the arrow keys do, which a pointer at rest over the opened list would take back
  list.view()->setCurrentIndex(list.model()->index(wanted, 0));
  QTest::keyClick(list.view(), Qt::Key_Return);
  waitUntil([&] { return !list.view()->isVisible(); });
}

void WindowRig::type(const char* field, const char* text)
{
  auto& line = part<QLineEdit>(*window_, field);
  line.setFocus();
  line.selectAll();
  QTest::keyClicks(&line, QLatin1String(text));
  QTest::keyClick(&line, Qt::Key_Return);
}

QAbstractButton& WindowRig::button(const char* name)
{
  return part<QAbstractButton>(*window_, name);
}

QString WindowRig::label(const char* name) { return part<QLabel>(*window_, name).text(); }

QString WindowRig::readOut(const char* name) { return part<gui::ReadOut>(*window_, name).number(); }

void WindowRig::pressKey(Qt::Key key, Qt::KeyboardModifiers modifiers)
{
  QTest::keyClick(window_.get(), key, modifiers);
}

void WindowRig::holdKey(Qt::Key key) { QTest::keyPress(window_.get(), key); }

void WindowRig::releaseKey(Qt::Key key) { QTest::keyRelease(window_.get(), key); }

void WindowRig::turnWheel(int notches)
{
  gui::OperationView& view = window_->view();
  const QPoint middle = view.rect().center();
  QWheelEvent event(middle, view.mapToGlobal(middle), QPoint(), QPoint(0, 120 * notches),
                    Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
  // Only a spontaneous event propagates from a view to its parents.
  QSpontaneKeyEvent::setSpontaneous(&event);
  qApp->notify(&view, &event);
}

bool WindowRig::waitUntil(const std::function<bool()>& claim, int longest_ms)
{
  return QTest::qWaitFor(claim, longest_ms);
}

bool WindowRig::runForTicks(std::uint64_t ticks)
{
  const std::uint64_t end = now().tick + ticks;
  return waitUntil([&] { return now().tick >= end; });
}

QImage WindowRig::picture()
{
  window_->view().renderIfDirty();
  return window_->view().picture();
}

}  // namespace perilymph::test
