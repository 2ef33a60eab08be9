// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/archive/Servers.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <system_error>

#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Choice.h"
#include "perilymph/foundation/TomlReader.h"

namespace perilymph::archive {

namespace fs = std::filesystem;

namespace {

constexpr std::array<Choice<Retrieval>, 2> retrievals = {
    {{Retrieval::get, "get"}, {Retrieval::move, "move"}}};

constexpr std::size_t maxName = 64;
constexpr std::size_t maxAeTitle = 16;  // DICOM PS3.5, value representation AE
constexpr std::size_t maxHost = 100;    // DCMTK has 128 characters for host and port
constexpr long lowestPort = 1, highestPort = 65535;

/// A key of a server that has a value it may not have, and why.
struct Fault {
  const char* key;
  Sentence sentence;
};

bool isPlain(const std::string& text)
{
  return std::none_of(text.begin(), text.end(), [](char letter) {
    return static_cast<unsigned char>(letter) < ' ' || letter == '\x7f' || letter == '\'';
  });
}

std::optional<Fault> aeTitleFault(const char* key, const std::string& title)
{
  const bool hasOnlyLetters = std::all_of(title.begin(), title.end(), [](char letter) {
    return letter >= ' ' && letter <= '~' && letter != '\\' && letter != '\'';
  });
  if (!title.empty() && title.size() <= maxAeTitle && hasOnlyLetters && title.front() != ' ' &&
      title.back() != ' ')
    return std::nullopt;
  return Fault{key,
               Sentence{"'%1' is no AE title: 1 to 16 ASCII letters, digits and signs, without "
                        "\\ and '. Enter the one that the archive's administrator states.",
                        title}};
}

std::optional<Fault> fileFault(const char* key, const fs::path& file)
{
  if (file.empty() || (file.is_absolute() && isPlain(file.string()))) return std::nullopt;
  return Fault{key,
               Sentence{"'%1' is no absolute path without quotation marks. Enter the whole path "
                        "of the PEM file.",
                        file}};
}

std::optional<Fault> tlsFault(const TlsFiles& tls)
{
  if (tls.authority.empty())
    return Fault{"authority", Sentence{"TLS needs the certificate of the authority that signed the "
                                       "server's. Enter its PEM file."}};
  if (tls.certificate.empty() != tls.key.empty())
    return Fault{"key", Sentence{"A certificate of this workstation and its key belong together. "
                                 "Enter both, or none."}};
  for (const auto& [key, file] : {std::pair{"authority", &tls.authority},
                                  {"certificate", &tls.certificate},
                                  {"key", &tls.key}})
    if (auto fault = fileFault(key, *file)) return fault;
  return std::nullopt;
}

std::optional<Fault> portFault(const char* key, int port)
{
  if (port >= lowestPort && port <= highestPort) return std::nullopt;
  return Fault{key, Sentence{"%1 is no port; a port is 1 to 65535.", port}};
}

std::optional<Fault> faultOf(const Server& server)
{
  if (server.name.empty() || server.name.size() > maxName || !isPlain(server.name))
    return Fault{"name",
                 Sentence{"'%1' is no name of a server: 1 to 64 letters, without '.", server.name}};
  const bool isHost = std::all_of(server.host.begin(), server.host.end(), [](char letter) {
    return (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'z') ||
           (letter >= 'A' && letter <= 'Z') || letter == '.' || letter == '-' || letter == '_';
  });
  if (server.host.empty() || server.host.size() > maxHost || !isHost)
    return Fault{"host", Sentence{"'%1' is no name or IPv4 address of a machine. Enter one such as "
                                  "pacs.hospital.example or 10.1.2.3.",
                                  server.host}};
  if (auto fault = aeTitleFault("ae_title", server.aeTitle)) return fault;
  if (auto fault = aeTitleFault("own_ae_title", server.ownAeTitle)) return fault;
  if (auto fault = portFault("port", server.port)) return fault;
  if (auto fault = portFault("own_port", server.ownPort)) return fault;
  return std::nullopt;
}

/// The first key of a table's children that is refused, if any.
void refuse(TomlReader& table, const std::optional<Fault>& fault)
{
  if (fault) table.refuse(fault->key, fault->sentence);
}

Server serverIn(TomlReader& table)
{
  const Server usual;
  Server server;
  server.name = table.text("name");
  server.aeTitle = table.text("ae_title");
  server.host = table.text("host");
  server.port = static_cast<int>(table.integer("port", lowestPort, highestPort, usual.port));
  server.ownAeTitle = table.text("own_ae_title", usual.ownAeTitle);
  server.retrieval = table.choice("retrieve", retrievals, usual.retrieval);
  server.ownPort =
      static_cast<int>(table.integer("own_port", lowestPort, highestPort, usual.ownPort));
  if (table.has("tls")) {
    TomlReader files = table.table("tls");
    server.tls =
        TlsFiles{files.text("authority"), files.text("certificate", ""), files.text("key", "")};
    refuse(files, tlsFault(*server.tls));
  }
  refuse(table, faultOf(server));
  return server;
}

std::string asToml(const Server& server)
{
  // Literal strings: faultOf() refuses what they cannot hold.
  const auto text = [](const char* key, const std::string& value) {
    return std::string(key) + " = '" + value + "'\n";
  };
  const auto number = [](const char* key, int value) {
    return std::string(key) + " = " + std::to_string(value) + '\n';
  };
  std::string toml = "\n[[server]]\n" + text("name", server.name) +
                     text("ae_title", server.aeTitle) + text("host", server.host) +
                     number("port", server.port) + text("own_ae_title", server.ownAeTitle) +
                     text("retrieve", nameIn(retrievals, server.retrieval)) +
                     number("own_port", server.ownPort);
  if (!server.tls) return toml;
  toml += "[server.tls]\n" + text("authority", server.tls->authority.string());
  if (!server.tls->certificate.empty())
    toml += text("certificate", server.tls->certificate.string()) +
            text("key", server.tls->key.string());
  return toml;
}

std::optional<Fault> wholeFault(const Server& server)
{
  auto fault = faultOf(server);
  if (!fault && server.tls) fault = tlsFault(*server.tls);
  return fault;
}

Result<void> check(const std::vector<Server>& servers, const fs::path& file)
{
  std::set<std::string> names;
  for (const Server& server : servers) {
    const auto fault = wholeFault(server);
    if (fault) return Error{"%1 is not changed. %2: %3", file, fault->key, fault->sentence};
    if (!names.insert(server.name).second)
      return Error{
          "%1 is not changed: two servers would be called '%2'. Give each a name of its own.", file,
          server.name};
  }
  return {};
}

}  // namespace

fs::path serversFile()
{
  // XDG Base Directory Specification: relative paths are ignored.
  const char* given = std::getenv("XDG_CONFIG_HOME");
  if (given != nullptr && fs::path(given).is_absolute())
    return fs::path(given) / "perilymph" / "servers.toml";
  const char* home = std::getenv("HOME");
  return fs::path(home == nullptr ? "/" : home) / ".config" / "perilymph" / "servers.toml";
}

Result<std::vector<Server>> readServers(const fs::path& file)
{
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return std::vector<Server>{};
  auto reader = TomlReader::open(file);
  if (!reader) return reader.error();
  std::vector<Server> servers;
  std::set<std::string> names;
  for (TomlReader& table : reader->tables("server")) {
    servers.push_back(serverIn(table));
    if (!names.insert(servers.back().name).second)
      table.refuse("name", Sentence{"'%1' is the name of another server, too. Give each its own.",
                                    servers.back().name});
  }
  if (const auto read = reader->finish(); !read) return read.error();
  return servers;
}

Result<Server> readServer(const std::string& name, const fs::path& file)
{
  const auto servers = readServers(file);
  if (!servers) return servers.error();
  std::string known;
  for (const Server& server : *servers) {
    if (server.name == name) return server;
    known += (known.empty() ? "" : ", ") + server.name;
  }
  if (known.empty())
    return Error{
        "There is no server '%1': %2 has none. Add it with 'perilymph-cli archive servers "
        "--add'.",
        name, file};
  return Error{"There is no server '%1' in %2. There are: %3.", name, file, known};
}

Result<void> checkServer(const Server& server)
{
  if (const auto fault = wholeFault(server)) return Error{fault->sentence};
  return {};
}

Result<void> writeServers(const std::vector<Server>& servers, const fs::path& file)
{
  if (const auto checked = check(servers, file); !checked) return checked;
  std::error_code failed;
  if (!fs::exists(file.parent_path(), failed)) {
    fs::create_directories(file.parent_path().parent_path(), failed);
    if (::mkdir(file.parent_path().c_str(), S_IRWXU) != 0 && errno != EEXIST)
      return Error{"The folder %1 cannot be made: %2.", file.parent_path(),
                   std::generic_category().message(errno)};
  }
  std::string toml =
      "# The DICOM servers of perilymph; the guide's page archive.md describes it.\n";
  for (const Server& server : servers) toml += asToml(server);
  return writeWhole(file, toml, {Links::followed, Audience::owner});
}

}  // namespace perilymph::archive
