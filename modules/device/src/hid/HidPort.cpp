// SPDX-License-Identifier: BSD-3-Clause
#include "hid/HidPort.h"

#include <fcntl.h>

#include <utility>

#include "hid/HidTransport.h"
#include "hid/PlugWatch.h"
#include "tape/TapePorts.h"

namespace perilymph::device {

namespace {

ReportNumbers numbersOf(const HidNode& node)
{
  const auto descriptor = ReportDescriptor::parse(node.descriptor);
  const bool isNumbered = descriptor && descriptor->isNumbered();
  return isNumbered ? ReportNumbers::inFront : ReportNumbers::none;
}

class HidrawPort final : public HidPort {
public:
  HidrawPort(HidNode node, SystemRoots roots)
      : node_(std::move(node)), roots_(std::move(roots)), numbers_(numbersOf(node_))
  {
    ownNode(findHidNodes(roots_));
  }

  Result<std::unique_ptr<Transport>> open() override
  {
    const std::vector<HidNode> nodes = findHidNodes(roots_);
    const HidNode* const found = ownNode(nodes);
    if (found == nullptr) return Error{"%1 is not plugged in.", called()};
    if (found->access == NodeAccess::denied)
      return Error{
          "You may not open %1 (%2). Put this line into %3 and plug the device in again: %4",
          found->path, called(), localRulesFile,
          udevRule(node_.identity.vendor, node_.identity.product)};
    node_.path = found->path;
    node_.place = found->place;
    if (!isTape()) return openHidTransport(node_.path, numbers_);

    if (!played_) {
      auto tape = loadTape(node_.path);
      if (!tape) return tape.error();
      played_ = playingPort(*std::move(tape));
    }
    return played_->open();
  }

  int fileForGuard() noexcept override
  {
    if (isTape()) return -1;
    return ::open(node_.path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
  }

  void awaitChange(Duration timeout) noexcept override { watch_.await(timeout); }

private:
  /// The node of this device. After it was plugged in again it may have another number, and another
  /// place, unless an equal device was seen beside it: then only the one at its place is this one.
  const HidNode* ownNode(const std::vector<HidNode>& nodes)
  {
    const HidNode* atPlace = nullptr;
    const HidNode* elsewhere = nullptr;
    for (const HidNode& node : nodes) {
      if (!isSameDevice(node, node_)) continue;
      if (node.place != node_.place)
        elsewhere = &node;
      else if (atPlace == nullptr || node.path == node_.path)
        atPlace = &node;
    }
    if (atPlace != nullptr && elsewhere != nullptr) hasTwin_ = true;
    return atPlace == nullptr && !hasTwin_ ? elsewhere : atPlace;
  }
  std::string called() const
  {
    const std::string name = node_.name.empty() ? "The HID device" : node_.name;
    return name + " " + identityText(node_.identity);
  }

  /// A recorded tree may contain a tape in place of a node.
  bool isTape() const noexcept
  {
    std::error_code ignored;
    return std::filesystem::is_regular_file(node_.path, ignored) &&
           std::filesystem::file_size(node_.path, ignored) > 0;
  }

  HidNode node_;
  bool hasTwin_ = false;
  SystemRoots roots_;
  ReportNumbers numbers_;
  PlugWatch watch_;
  std::unique_ptr<HidPort> played_;
};

}  // namespace

std::unique_ptr<HidPort> hidPort(HidNode node, SystemRoots roots)
{
  return std::make_unique<HidrawPort>(std::move(node), std::move(roots));
}

}  // namespace perilymph::device
