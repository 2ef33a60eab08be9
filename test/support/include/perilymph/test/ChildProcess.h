#pragma once

// Programs under test, run as people run them.

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace perilymph::test {

/// What to run, and where.
struct ProgramCall {
  std::string program;  ///< A path, or a name found through PATH.
  std::vector<std::string> arguments;
  /// Variables to set, or to take away (nullopt), on top of this process's own.
  std::vector<std::pair<std::string, std::optional<std::string>>> environment;
  std::optional<std::filesystem::path> folder;  ///< To run in; this process's own without one.
};

/// How it went.
struct ProgramOutcome {
  int status = -1;        ///< Exit status; -1 if it did not exit by itself.
  int signal = 0;         ///< That ended it; 0 if none did.
  bool timedOut = false;  ///< It was killed because its time was over.
  std::string out;        ///< Everything it wrote to standard output.
  std::string err;        ///< Everything it wrote to standard error.
};

/// A running program with everything it starts. Its standard input is empty.
class ChildProcess {
public:
  /// @throws std::system_error if it cannot be started.
  explicit ChildProcess(const ProgramCall& call);
  ~ChildProcess();  ///< Kills it, with everything it started, if it still runs.
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Waits until it has written `text` to standard output. False when it ended, or the time was
  /// over, without.
  bool waitForOutput(const std::string& text, std::chrono::milliseconds timeout);
  /// Waits for its end; kills it, with everything it started, when the time is over.
  ProgramOutcome wait(std::chrono::milliseconds timeout);
  /// Sends it a signal, such as SIGKILL for a power cut.
  void send(int signal);
  int id() const noexcept;

private:
  struct Content;
  std::unique_ptr<Content> content_;
};

/// Runs a program to its end.
ProgramOutcome run(const ProgramCall& call,
                   std::chrono::milliseconds timeout = std::chrono::minutes(2));

}  // namespace perilymph::test
