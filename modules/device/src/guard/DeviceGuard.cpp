// SPDX-License-Identifier: BSD-3-Clause
#include "guard/DeviceGuard.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <new>
#include <utility>
#include <vector>

#include "guard/CompanionProcess.h"
#include "guard/GuardScript.h"

namespace perilymph::device {

namespace {

namespace fs = std::filesystem;

constexpr const char* programName = "perilymph-device-guard";
constexpr int patienceForEnd_ms = 200;  // for the end of a guard after goodbye

/// Starts the guard with its descriptors; 0 if that fails.
pid_t start(const fs::path& program, int wire, int device, int pulse)
{
  return startCompanion({program,
                         {},
                         {{wire, guard::wire}, {device, guard::device}, {pulse, guard::pulse}},
                         CompanionOutput::nowhere});
}

/// A started guard process, and the pipe to it.
class Guard {
public:
  Guard(pid_t id, OwnedFile wire, guard::Pulse* pulse) noexcept
      : id_(id), wire_(std::move(wire)), pulse_(pulse)
  {
  }
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;
  ~Guard()
  {
    say(wire_, guard::goodbye);
    wire_ = OwnedFile();
    endCompanion(id_, patienceForEnd_ms);
    ::munmap(pulse_, sizeof *pulse_);
  }

  guard::Pulse& pulse() noexcept { return *pulse_; }

private:
  pid_t id_;
  OwnedFile wire_;
  guard::Pulse* pulse_;
};

/// Counts the writes to the device in the guard's pulse.
class WatchedTransport final : public Transport {
public:
  WatchedTransport(std::unique_ptr<Transport> handle, std::unique_ptr<Guard> guard,
                   const std::vector<FixedReport>& noForce)
      : handle_(std::move(handle)), guard_(std::move(guard)), noForce_(noForce)
  {
  }

  Transfer read(RawReport& report, Duration timeout) noexcept override
  {
    return handle_->read(report, timeout);
  }
  Transfer write(const RawReport& report) noexcept override
  {
    // Set before the write, because the process may die while it blocks.
    if (!isNoForce(report)) {
      calm_ = 0;
      guard_->pulse().isPushing = 1;
    }
    const Transfer transfer = handle_->write(report);
    if (transfer != Transfer::done) return transfer;
    if (isNoForce(report) && ++calm_ >= noForce_.size()) guard_->pulse().isPushing = 0;
    ++guard_->pulse().forces;
    return transfer;
  }
  Transfer setFeature(const RawReport& report) noexcept override
  {
    return handle_->setFeature(report);
  }
  Transfer getFeature(RawReport& report) noexcept override { return handle_->getFeature(report); }

private:
  bool isNoForce(const RawReport& report) const noexcept
  {
    const auto bytes = report.view();
    return std::any_of(noForce_.begin(), noForce_.end(), [&](const FixedReport& none) {
      return std::equal(bytes.begin(), bytes.end(), none.bytes.begin(), none.bytes.end());
    });
  }

  // Closing the handle sends goodbye to the guard.
  std::unique_ptr<Transport> handle_;
  std::unique_ptr<Guard> guard_;
  std::vector<FixedReport> noForce_;
  std::size_t calm_ = 0;  // consecutive reports of no force
};

Result<std::unique_ptr<Guard>> post(const OwnedFile& device, const guard::Script& script)
{
  const auto refused = [](const std::string& what) {
    return Error{"%1 If this program dies, only the device's own watchdog takes the force away.",
                 what};
  };
  const fs::path program = companionProgram(programName);
  if (program.empty())
    return refused("The program " + std::string(programName) +
                   ", which takes the force away when this one cannot, is not installed.");

  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) != 0)
    return refused(std::string("No guard for the device: ") + std::strerror(errno) + ".");
  const OwnedFile wireEnd(ends[0]);
  OwnedFile wire(ends[1]);
  const OwnedFile memory(::memfd_create("perilymph pulse", MFD_CLOEXEC));
  void* place = MAP_FAILED;
  if (::ftruncate(memory.get(), sizeof(guard::Pulse)) == 0)
    place =
        ::mmap(nullptr, sizeof(guard::Pulse), PROT_READ | PROT_WRITE, MAP_SHARED, memory.get(), 0);
  if (place == MAP_FAILED)
    return refused(std::string("No guard for the device: ") + std::strerror(errno) + ".");
  auto* const pulse = new (place) guard::Pulse;

  // The script is in the pipe before the guard reads it: any later death is detected.
  const auto bytes = script.bytes();
  const bool isWritten =
      ::write(wire.get(), bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
  const pid_t id = isWritten ? start(program, wireEnd.get(), device.get(), memory.get()) : 0;
  if (id == 0) {
    ::munmap(place, sizeof(guard::Pulse));
    return refused(program.string() + " could not be started.");
  }
  return std::make_unique<Guard>(id, std::move(wire), pulse);
}

}  // namespace

GuardedHandle guarded(std::unique_ptr<Transport> handle, int file,
                      const ShutdownReports& shutdownReports, Duration patience)
{
  const OwnedFile device(file);
  GuardedHandle result;
  result.handle = std::move(handle);
  if (device.get() < 0 || shutdownReports.noForce.empty()) {
    result.obstacle =
        "This device cannot be guarded: only its own watchdog takes the force away if "
        "this program dies.";
    return result;
  }
  const double patience_ms = std::clamp(std::ceil(patience.si() * 1e3), 0.0, 255.0);
  guard::Script script(static_cast<std::uint8_t>(patience_ms));
  bool fits = true;
  for (const FixedReport& report : shutdownReports.noForce)
    fits = fits && script.addNoForce({report.kind == ReportKind::feature, report.bytes});
  for (const FixedReport& report : shutdownReports.switchOff)
    fits = fits && script.addSwitchOff({report.kind == ReportKind::feature, report.bytes});
  if (!fits) {
    result.obstacle = "The device cannot be guarded: its last reports are more than " +
                      std::to_string(guard::Script::capacity) + " bytes.";
    return result;
  }
  auto posted = post(device, script);
  if (!posted) {
    result.obstacle = posted.error().message;
    return result;
  }
  result.handle = std::make_unique<WatchedTransport>(std::move(result.handle), *std::move(posted),
                                                     shutdownReports.noForce);
  return result;
}

}  // namespace perilymph::device
