// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/Unfinished.h"

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <ctime>
#include <regex>
#include <string>

#include "Descriptor.h"

namespace perilymph {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t maxStem = 100, maxHost = 32;
constexpr std::time_t old_s = 3600;

/// The name of this machine: letters, digits and hyphens. A folder may be shared by several.
std::string hostName()
{
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) return "unknown";
  std::string host(name.data());
  host.resize(std::min(host.size(), maxHost));
  for (char& letter : host)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '-';
  return host.empty() ? "unknown" : host;
}

bool hasEnded(const std::string& process)
{
  return ::kill(std::stoi(process), 0) != 0 && errno == ESRCH;
}

/// Whether a file is of a process that has ended. Names of 0.2.0 lack the machine: another one may
/// write such a file now, unless it is old.
bool isLeftover(const std::string& name, const struct stat& status)
{
  static const std::regex now(R"(\..+\.([A-Za-z0-9-]+)-([0-9]{1,9})\.[0-9]+\.part([.-].*)?)");
  static const std::regex before(
      R"(\..+\.([0-9]{1,9})\.[0-9]{1,3}\.part(\..*)?|.+\.begin-([0-9]{1,9})(-.*)?)");
  std::smatch found;
  if (status.st_uid != ::geteuid()) return false;
  if (std::regex_match(name, found, now)) return found[1] == hostName() && hasEnded(found[2]);
  // Those were files only.
  return S_ISREG(status.st_mode) && std::regex_match(name, found, before) &&
         status.st_mtime < std::time(nullptr) - old_s &&
         hasEnded(found[1].matched ? found[1] : found[3]);
}

}  // namespace

fs::path unfinishedPath(const fs::path& target)
{
  static std::atomic<unsigned> number{0};
  return target.parent_path() / ("." + target.stem().string().substr(0, maxStem) + "." +
                                 hostName() + "-" + std::to_string(::getpid()) + "." +
                                 std::to_string(number++) + ".part" + target.extension().string());
}

int giveNewName(const fs::path& unfinished, const fs::path& target) noexcept
{
  if (::renameat2(AT_FDCWD, unfinished.c_str(), AT_FDCWD, target.c_str(), RENAME_NOREPLACE) == 0)
    return 0;
  if (errno != EINVAL) return errno;
  // A file system without this flag: a second name fails, too, where there is a file.
  if (::link(unfinished.c_str(), target.c_str()) != 0) return errno;
  ::unlink(unfinished.c_str());
  return 0;
}

void removeLeftovers(const fs::path& folder) noexcept
{
  try {
    std::error_code failed;
    fs::directory_iterator entries(folder.empty() ? fs::path(".") : folder, failed);
    for (; !failed && entries != fs::directory_iterator(); entries.increment(failed)) {
      const std::string name = entries->path().filename().string();
      if (name.find(".part") == std::string::npos && name.find(".begin-") == std::string::npos)
        continue;
      struct stat status = {};
      if (::lstat(entries->path().c_str(), &status) != 0 || !isLeftover(name, status)) continue;
      std::error_code ignored;
      if (S_ISREG(status.st_mode)) fs::remove(entries->path(), ignored);
      if (S_ISDIR(status.st_mode)) fs::remove_all(entries->path(), ignored);
    }
  } catch (...) {  // memory is short: they stay for the next start
  }
}

Result<UnfinishedFolder> UnfinishedFolder::create(const fs::path& target)
{
  removeLeftovers(target.parent_path());
  for (int attempt = 0; attempt < 1000; ++attempt) {
    fs::path path = unfinishedPath(target);
    if (::mkdir(path.c_str(), S_IRWXU) == 0) return UnfinishedFolder(std::move(path), target);
    if (errno != EEXIST) break;
  }
  return Error{"%1 cannot be created: %2 in its folder. Choose another place.", target,
               reason(errno)};
}

UnfinishedFolder::UnfinishedFolder(UnfinishedFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})), target_(std::move(other.target_))
{
}

UnfinishedFolder::~UnfinishedFolder()
{
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

Result<void> UnfinishedFolder::finish()
{
  int outcome = ::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target_.c_str(), RENAME_NOREPLACE);
  std::error_code ignored;
  // A file system without this flag; rename() itself replaces empty folders only.
  if (outcome != 0 && errno == EINVAL && !fs::exists(fs::symlink_status(target_, ignored)))
    outcome = ::rename(path_.c_str(), target_.c_str());
  if (outcome != 0)
    return Error{"%1 cannot be created: %2. Choose another place.", target_, reason(errno)};
  path_.clear();
  return {};
}

}  // namespace perilymph
