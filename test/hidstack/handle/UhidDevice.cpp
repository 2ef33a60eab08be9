// SPDX-License-Identifier: BSD-3-Clause
#include "UhidDevice.h"

#include <fcntl.h>
#include <linux/input.h>
#include <linux/uhid.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>

namespace perilymph::hidstack {

struct UhidDevice::Buffers {
  uhid_event incoming{};
  uhid_event outgoing{};
};

UhidDevice::UhidDevice() : buffers_(std::make_unique<Buffers>()) {}

UhidDevice::~UhidDevice() { unplug(); }

Result<void> UhidDevice::plug(const std::string& name, std::uint16_t vendor, std::uint16_t product,
                              std::span<const std::uint8_t> descriptor)
{
  unplug();
  file_ = ::open("/dev/uhid", O_RDWR | O_CLOEXEC | O_NONBLOCK);
  if (file_ < 0)
    return Error{std::string("/dev/uhid could not be opened (") + std::strerror(errno) +
                 "): load the kernel's module uhid and run as root."};

  uhid_event& outgoing = buffers_->outgoing;
  outgoing = {};
  outgoing.type = UHID_CREATE2;
  uhid_create2_req& request = outgoing.u.create2;
  std::memcpy(request.name, name.data(), std::min(name.size(), sizeof request.name - 1));
  std::memcpy(request.rd_data, descriptor.data(),
              std::min(descriptor.size(), sizeof request.rd_data));
  request.rd_size = static_cast<__u16>(descriptor.size());
  request.bus = BUS_USB;
  request.vendor = vendor;
  request.product = product;
  if (::write(file_, &outgoing, sizeof outgoing) != static_cast<ssize_t>(sizeof outgoing)) {
    const Error error{std::string("The kernel refused the virtual device: ") +
                      std::strerror(errno) + "."};
    unplug();
    return error;
  }
  return {};
}

void UhidDevice::unplug() noexcept
{
  if (file_ >= 0) ::close(file_);
  file_ = -1;
}

bool UhidDevice::send(std::span<const std::uint8_t> report) noexcept
{
  // Only what counts is written: the kernel takes the rest as zero.
  uhid_event& outgoing = buffers_->outgoing;
  outgoing.type = UHID_INPUT2;
  outgoing.u.input2.size = static_cast<__u16>(report.size());
  std::memcpy(outgoing.u.input2.data, report.data(), report.size());
  const std::size_t size =
      offsetof(uhid_event, u) + offsetof(uhid_input2_req, data) + report.size();
  return ::write(file_, &outgoing, size) == static_cast<ssize_t>(size);
}

UhidEvent UhidDevice::take(std::span<const std::uint8_t>& report) noexcept
{
  uhid_event& incoming = buffers_->incoming;
  if (::read(file_, &incoming, sizeof incoming) <= 0) return UhidEvent::nothing;
  switch (incoming.type) {
    case UHID_OUTPUT:
      report = {incoming.u.output.data, incoming.u.output.size};
      return UhidEvent::output;
    case UHID_SET_REPORT:
      report = {incoming.u.set_report.data, incoming.u.set_report.size};
      return UhidEvent::featureSet;
    case UHID_GET_REPORT:
      report = {&incoming.u.get_report.rnum, 1};
      return UhidEvent::featureRequested;
    default:
      return UhidEvent::other;
  }
}

void UhidDevice::refuse() noexcept { reply(EIO, {}); }

void UhidDevice::accept() noexcept { reply(0, {}); }

void UhidDevice::answer(std::span<const std::uint8_t> report) noexcept { reply(0, report); }

void UhidDevice::reply(int error, std::span<const std::uint8_t> report) noexcept
{
  const uhid_event& asked = buffers_->incoming;
  uhid_event& outgoing = buffers_->outgoing;
  outgoing = {};
  const auto code = static_cast<__u16>(error);
  if (asked.type == UHID_GET_REPORT) {
    uhid_get_report_reply_req& answer = outgoing.u.get_report_reply;
    outgoing.type = UHID_GET_REPORT_REPLY;
    answer.id = asked.u.get_report.id;
    answer.err = code;
    answer.size = static_cast<__u16>(std::min(report.size(), sizeof answer.data));
    if (answer.size > 0) std::memcpy(answer.data, report.data(), answer.size);
  } else {
    outgoing.type = UHID_SET_REPORT_REPLY;
    outgoing.u.set_report_reply.id = asked.u.set_report.id;
    outgoing.u.set_report_reply.err = code;
  }
  // The requester times out after five seconds, so a lost answer is harmless.
  [[maybe_unused]] const auto written = ::write(file_, &outgoing, sizeof outgoing);
}

}  // namespace perilymph::hidstack
