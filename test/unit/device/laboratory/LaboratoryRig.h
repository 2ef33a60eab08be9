// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A laboratory's device as the program uses it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <optional>

#include "LaboratoryPeer.h"
#include "perilymph/device/DeviceHealth.h"
#include "perilymph/device/PluginDevice.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::test {

class LaboratoryRig : public testing::Test {
protected:
  void use(const LaboratoryDevice& device) { peer_.emplace(device); }
  void TearDown() override
  {
    if (peer_) peer_->state().fault = PeerState::none;  // a call that hangs returns
    device_.reset();
    peer_.reset();
  }
  PeerState& state() { return peer_->state(); }

  void load()
  {
    auto loaded = device::loadPluginDevice(peer_->library());
    ASSERT_TRUE(loaded) << loaded.error().message;
    device_ = *std::move(loaded);
  }
  void open()
  {
    if (!device_) {
      ASSERT_NO_FATAL_FAILURE(load());
    }
    const auto opened = device_->open();
    ASSERT_TRUE(opened) << opened.error().message;
  }
  /// The sentence with which it cannot be opened.
  std::string refusal()
  {
    load();
    if (!device_) return {};
    const auto opened = device_->open();
    return opened ? "it was opened" : opened.error().message;
  }
  static bool isOneSentence(const std::string& text)
  {
    return !text.empty() && std::isupper(static_cast<unsigned char>(text.front())) != 0 &&
           text.back() == '.' && text.find('\n') == std::string::npos;
  }

  /// One tick of a program that renders a force.
  device::DeviceSample tick(const Vector3& force_D = {})
  {
    device_->await(milliseconds(2));
    const device::DeviceSample sample = device_->read();
    device_->write({force_D, {}});
    return sample;
  }
  template <class Condition>
  [[nodiscard]] bool tickUntil(const Vector3& force_D, Condition holds)
  {
    return waitUntil(
        [&] {
          newest_ = tick(force_D);
          return holds();
        },
        std::chrono::seconds(30));
  }
  void tickFor(const Vector3& force_D, std::chrono::milliseconds time)
  {
    const auto end = std::chrono::steady_clock::now() + time;
    while (std::chrono::steady_clock::now() < end) newest_ = tick(force_D);
  }
  /// Renders until the hand feels it.
  void push()
  {
    ASSERT_NO_FATAL_FAILURE(open());
    ASSERT_TRUE(tickUntil(pushed, [this] { return peer_->force() > 0.9 * pushed[2]; }));
  }
  std::string error() { return device_->health()->error; }

  static constexpr Vector3 pushed = {0.0, 0.0, 0.5};  // [N]
  std::optional<LaboratoryPeer> peer_;
  std::unique_ptr<device::HapticDevice> device_;
  device::DeviceSample newest_;
};

}  // namespace perilymph::test
