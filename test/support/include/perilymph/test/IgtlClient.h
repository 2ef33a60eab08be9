// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A client of the OpenIGTLink library.

#include <gtest/gtest.h>
#include <igtlClientSocket.h>
#include <igtlMessageHeader.h>

#include <cerrno>
#include <string>

namespace perilymph::test {

/// The message whose header was received; its check sum is expected to be right.
template <class Message>
typename Message::Pointer bodyOf(igtl::ClientSocket& socket, igtl::MessageHeader* header)
{
  auto message = Message::New();
  message->SetMessageHeader(header);
  message->AllocatePack();
  socket.Receive(message->GetPackBodyPointer(), message->GetPackBodySize());
  EXPECT_NE(message->Unpack(1) & igtl::MessageHeader::UNPACK_BODY, 0)
      << "the check sum of " << header->GetDeviceName();
  return message;
}

/// Receives the next message of a device; others are skipped, such as a STATUS that the device has
/// nothing yet. Fails the test if none comes.
template <class Message>
typename Message::Pointer receive(igtl::ClientSocket& socket, const std::string& name)
{
  for (int i = 0; i < 2000; ++i) {
    auto header = igtl::MessageHeader::New();
    header->InitPack();
    const int count = socket.Receive(header->GetPackPointer(), header->GetPackSize());
    if (count != header->GetPackSize()) {
      ADD_FAILURE() << count << " bytes of a header, errno " << errno;
      break;
    }
    header->Unpack();
    const bool isStatus = header->GetDeviceType() == std::string("STATUS");
    if (header->GetDeviceName() != name || isStatus) {
      socket.Skip(header->GetBodySizeToRead());
      continue;
    }
    return bodyOf<Message>(socket, header);
  }
  ADD_FAILURE() << "No " << name << " came.";
  return Message::New();
}

}  // namespace perilymph::test
