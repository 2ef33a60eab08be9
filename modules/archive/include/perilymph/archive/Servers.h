// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The DICOM servers that a user works with, as in the file servers.toml of the settings folder.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::archive {

/// How a server hands over a series.
enum class Retrieval {
  get,   ///< C-GET: over the connection that this program opened.
  move,  ///< C-MOVE: over one that the server opens to this machine's own port.
};

/// Files of a TLS connection, PEM. Absolute paths.
struct TlsFiles {
  std::filesystem::path authority;         ///< Certificate that signed the server's.
  std::filesystem::path certificate, key;  ///< This workstation's own; both, or none.
};

/// One DICOM application entity that serves queries and images.
struct Server {
  std::string name;     ///< What the user calls it; 1 to 64 characters, unique in the file.
  std::string aeTitle;  ///< Its AE title; 1 to 16 ASCII characters.
  std::string host;     ///< Name or IPv4 address.
  int port = 104;
  std::string ownAeTitle = "PERILYMPH";  ///< The AE title that it has for this workstation.
  Retrieval retrieval = Retrieval::get;
  int ownPort = 11112;  ///< Where this workstation is listened for during a move.
  std::optional<TlsFiles> tls = std::nullopt;
};

/// The file of the servers: $XDG_CONFIG_HOME/perilymph/servers.toml, by default in ~/.config.
std::filesystem::path serversFile();

/// Reads the servers of a file, in its order; none if it does not exist. The error names file, line,
/// key, value and what is allowed.
Result<std::vector<Server>> readServers(const std::filesystem::path& file = serversFile());

/// The server of this name in a file; the error for an unknown name lists the known ones.
Result<Server> readServer(const std::string& name,
                          const std::filesystem::path& file = serversFile());

/// Returns an error for a server whose values may not be in the file: which value, and what is allowed.
Result<void> checkServer(const Server& server);

/// Writes the servers atomically for the owner only (mode 0600), and makes the file's folder (0700)
/// where it is absent. Refuses a server that readServers() would refuse, and nothing is written then.
Result<void> writeServers(const std::vector<Server>& servers,
                          const std::filesystem::path& file = serversFile());

}  // namespace perilymph::archive
