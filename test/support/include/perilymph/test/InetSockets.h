// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The network sockets of a process, and a port that is taken.

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iomanip>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace perilymph::test {

/// A TCP or UDP socket. Sockets of the display (AF_UNIX) are none.
struct InetSocket {
  std::string place;         ///< As the kernel writes it: "0100007F:4A00" is 127.0.0.1:18944.
  bool isListening = false;  ///< TCP, waiting for clients.
};

/// The place of a port of 127.0.0.1: "0100007F:4A00".
inline std::string loopback(int port)
{
  std::ostringstream text;
  text << "0100007F:" << std::hex << std::uppercase << std::setfill('0') << std::setw(4) << port;
  return text.str();
}

/// The network sockets that a process has open, from /proc.
inline std::vector<InetSocket> inetSocketsOf(int process)
{
  const auto folder = "/proc/" + std::to_string(process);
  std::set<std::string> own;  // "socket:[inode]"
  std::error_code failure;
  for (const auto& file : std::filesystem::directory_iterator(folder + "/fd", failure))
    own.insert(std::filesystem::read_symlink(file.path(), failure).string());
  std::vector<InetSocket> found;
  for (const char* table : {"tcp", "tcp6", "udp", "udp6", "raw", "raw6"}) {
    std::ifstream lines(folder + "/net/" + table);
    std::string line;
    std::getline(lines, line);  // titles
    while (std::getline(lines, line)) {
      std::istringstream words(line);
      std::vector<std::string> word(10);
      for (std::string& one : word) words >> one;
      const bool isTcp = std::string(table).find("tcp") == 0;
      if (own.count("socket:[" + word[9] + "]") > 0)
        found.push_back({word[1], isTcp && word[3] == "0A"});
    }
  }
  return found;
}

/// A port of the loopback that is listened at until the end of the object.
class TakenPort {
public:
  TakenPort() : file_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0))
  {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof place;
    EXPECT_EQ(::bind(file_, reinterpret_cast<sockaddr*>(&place), size), 0);
    EXPECT_EQ(::listen(file_, 1), 0);
    ::getsockname(file_, reinterpret_cast<sockaddr*>(&place), &size);
    port_ = ntohs(place.sin_port);
  }
  ~TakenPort() { ::close(file_); }
  TakenPort(const TakenPort&) = delete;
  TakenPort& operator=(const TakenPort&) = delete;
  int number() const { return port_; }

private:
  int file_;
  int port_ = 0;
};

/// A port that was free a moment ago.
inline int freePort() { return TakenPort().number(); }

}  // namespace perilymph::test
