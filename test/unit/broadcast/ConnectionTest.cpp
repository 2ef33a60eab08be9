// SPDX-License-Identifier: BSD-3-Clause
#include "Connection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string>
#include <vector>

namespace perilymph::broadcast {
namespace {

constexpr std::int64_t second = 1'000'000'000;  // [ns]

/// Clients that connected at the time 0.
class Clients : public testing::Test {
protected:
  void connect(int count)
  {
    for (int i = 0; i < count; ++i) {
      int ends[2];
      ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends), 0);
      theirs_.emplace_back(ends[0]);
      clients_.emplace_back(OwnedSocket(ends[1]), std::to_string(i), 0);
    }
  }
  /// A client sends a header with a body of this size, of which so much.
  void send(std::size_t client, std::uint64_t body, std::size_t bytes, std::int64_t now)
  {
    std::vector<std::uint8_t> message(58 + bytes, 0);
    message[1] = 1;
    message[2] = 'X';
    for (std::size_t i = 0; i < 8; ++i)
      message[42 + i] = static_cast<std::uint8_t>(body >> (56 - 8 * i));
    push(client, message, now);
  }
  void push(std::size_t client, const std::vector<std::uint8_t>& bytes, std::int64_t now)
  {
    std::size_t sent = 0;
    while (sent < bytes.size()) {
      const ssize_t count =
          ::send(theirs_[client].get(), bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
      if (count > 0) sent += static_cast<std::size_t>(count);
      clients_[client].receive(now);
    }
    // What is still in the socket: it takes 64 KiB at a time.
    for (int i = 0; i < 64; ++i) clients_[client].receive(now);
  }
  std::vector<int> ended() const
  {
    std::vector<int> which;
    for (std::size_t i = 0; i < clients_.size(); ++i)
      if (clients_[i].hasEnded()) which.push_back(static_cast<int>(i));
    return which;
  }

  std::vector<OwnedSocket> theirs_;
  std::deque<Connection> clients_;
};

TEST_F(Clients, GiveWayIfTheySaidNothingLongest)
{
  connect(3);
  send(0, 0, 0, 1 * second);
  send(1, 0, 0, 3 * second);
  send(2, 0, 0, 2 * second);
  EXPECT_FALSE(makeRoom(clients_, 5 * second));  // all of them spoke within 5 s
  EXPECT_THAT(ended(), testing::IsEmpty());
  EXPECT_TRUE(makeRoom(clients_, 7 * second));
  EXPECT_THAT(ended(), testing::ElementsAre(0));
  EXPECT_THAT(clients_[0].fault(), testing::HasSubstr("it asked for nothing for 6 s"));
}

TEST_F(Clients, GiveWayThoughTheyNeverSaidAnything)
{
  connect(2);
  send(0, 0, 0, 1 * second);
  EXPECT_TRUE(makeRoom(clients_, 6 * second));
  EXPECT_THAT(ended(), testing::ElementsAre(1));
}

TEST_F(Clients, MaySendALongMessageSlowlyButNotTooSlowly)
{
  connect(1);
  constexpr std::uint64_t megabyte = RequestReader::maxBody;
  send(0, 10 * megabyte, 0, 0);
  for (int i = 1; i <= 3; ++i) {
    push(0, std::vector<std::uint8_t>(megabyte, 1), 4 * i * second);
    clients_[0].checkPatience(4 * i * second + second / 2);
    EXPECT_FALSE(clients_[0].hasEnded()) << i;
  }
  push(0, std::vector<std::uint8_t>(megabyte / 2, 1), 16 * second);
  clients_[0].checkPatience(18 * second);
  EXPECT_TRUE(clients_[0].hasEnded());
  EXPECT_THAT(clients_[0].fault(), testing::HasSubstr("unfinished for 5 s"));
}

}  // namespace
}  // namespace perilymph::broadcast
