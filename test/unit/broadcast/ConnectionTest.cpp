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

TEST_F(Clients, AreEndedWithinAHeader)
{
  connect(1);
  push(0, {0, 1, 'G', 'E', 'T'}, second);
  clients_[0].checkPatience(5 * second);
  EXPECT_FALSE(clients_[0].hasEnded());
  clients_[0].checkPatience(7 * second);
  EXPECT_TRUE(clients_[0].hasEnded());
  EXPECT_THAT(clients_[0].fault(), testing::HasSubstr("unfinished for 5 s"));
}

// A megabyte at a time: those who wait for the next frame wait for no more of other clients.
TEST_F(Clients, TakeAtMostAMegabyteBeforeTheOthers)
{
  connect(1);
  Answers answers;
  answers[Item::image] = std::make_shared<const Bytes>(std::size_t{20} << 20);
  clients_[0].want(Item::image);
  std::size_t all = 0;
  std::vector<char> buffer(4 << 20);
  for (int i = 0; i < 1000 && all < std::size_t{20} << 20; ++i) {
    clients_[0].send(answers, second);
    std::size_t taken = 0;
    ssize_t count;
    while ((count = ::recv(theirs_[0].get(), buffer.data(), buffer.size(), 0)) > 0)
      taken += static_cast<std::size_t>(count);
    ASSERT_GT(taken, 0u);
    ASSERT_LE(taken, std::size_t{1} << 20);
    all += taken;
  }
  EXPECT_EQ(all, std::size_t{20} << 20);
  EXPECT_FALSE(clients_[0].isBusy());
}

TEST_F(Clients, KeepFewAnswersOfOneThatOnlyAsks)
{
  connect(1);
  for (int i = 0; i < 1000; ++i) {
    std::vector<std::uint8_t> request(58, 0);
    const std::string type = "GET_NONSENSE";
    request[1] = 1;
    std::copy(type.begin(), type.end(), request.begin() + 2);
    push(0, request, second);
  }
  std::size_t bytes = 0;
  std::vector<char> buffer(1 << 20);
  for (int i = 0; i < 100; ++i) {
    clients_[0].send({}, second);
    const ssize_t count = ::recv(theirs_[0].get(), buffer.data(), buffer.size(), 0);
    if (count > 0) bytes += static_cast<std::size_t>(count);
  }
  // 16 messages of 58 bytes, 30 of a status and a sentence
  EXPECT_GT(bytes, 16u * 88u);
  EXPECT_LT(bytes, 16u * 250u);
}

}  // namespace
}  // namespace perilymph::broadcast
