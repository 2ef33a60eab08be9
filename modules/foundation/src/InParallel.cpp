// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/InParallel.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

#include "perilymph/foundation/CallNoThrow.h"
#include "perilymph/foundation/RealTime.h"

namespace perilymph {
namespace {

/// Data shared by the threads.
struct Board {
  std::atomic<std::size_t> next{0};
  std::stop_source ending;  ///< Ends all pieces.
  std::mutex lock;          ///< Protects the following members.
  std::condition_variable changed;
  std::size_t done = 0;
  std::size_t working = 0;
  std::vector<std::optional<Error>> errors;
};

}  // namespace

unsigned processors() noexcept { return std::max(1u, std::thread::hardware_concurrency()); }

Result<void> doInParallel(
    std::size_t count, unsigned jobs,
    const std::function<Result<void>(std::size_t, const std::stop_token& stop)>& work,
    const PieceProgress& progress, const std::stop_token& stop)
{
  if (jobs == 0) jobs = processors();
  Board board;
  board.errors.resize(count);
  board.working = std::min<std::size_t>(jobs, count);
  const std::stop_callback forward(stop, [&board] { board.ending.request_stop(); });

  const auto worker = [&] {
    declareThread(ThreadRole::calculation);
    const std::stop_token ending = board.ending.get_token();
    for (std::size_t piece = board.next++; piece < count && !ending.stop_requested();
         piece = board.next++) {
      const Result<void> result =
          callNoThrow("The calculation", [&] { return work(piece, ending); });
      const std::lock_guard guard(board.lock);
      ++board.done;
      // A piece stopped on request is not an error.
      if (!result && !ending.stop_requested()) {
        board.errors[piece] = result.error();
        board.ending.request_stop();
      }
      board.changed.notify_one();
    }
    const std::lock_guard guard(board.lock);
    --board.working;
    board.changed.notify_one();
  };
  std::vector<std::jthread> threads;
  for (std::size_t i = 0; i < std::min<std::size_t>(jobs, count); ++i) threads.emplace_back(worker);

  std::unique_lock guard(board.lock);
  while (board.working > 0) {
    // A tenth of a second, so that the caller can look for a request to stop even if no piece ends.
    board.changed.wait_for(guard, std::chrono::milliseconds(100));
    const std::size_t done = board.done;
    guard.unlock();
    if (progress) progress(done);
    guard.lock();
  }
  guard.unlock();
  threads.clear();

  if (stop.stop_requested()) return Error{"Stopped; nothing was kept."};
  for (const auto& error : board.errors)
    if (error) return *error;
  return {};
}

}  // namespace perilymph
