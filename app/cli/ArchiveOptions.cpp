// SPDX-License-Identifier: BSD-3-Clause
#include "ArchiveOptions.h"

#include <CLI/CLI.hpp>

#include "FileOptions.h"
#include "NumberOptions.h"

namespace perilymph::cli {

namespace {

void addServer(CLI::App& command, ArchiveOptions& options)
{
  command.add_option("server", options.server, "Name of a server in servers.toml")->required();
}

void addJson(CLI::App& command, FileOptions& files, ArchiveOptions& options)
{
  files.writes(command.add_option("--json", options.json, "Write the result (JSON)"));
}

void addServers(CLI::App& archive, FileOptions& files, ArchiveOptions& options)
{
  CLI::App& command =
      *archive.add_subcommand("servers", "List the servers in servers.toml, or change them");
  CLI::Option* add = command.add_option(
      "--add", options.add, "Add a server of this name, or replace the one of this name");
  command.add_option("--remove", options.remove, "Remove the server of this name")->excludes(add);
  CLI::Option* title = command.add_option("--ae-title", options.aeTitle, "AE title of the server");
  CLI::Option* host =
      command.add_option("--host", options.host, "Name or IPv4 address of the server");
  add->needs(title)->needs(host);
  title->needs(add);
  host->needs(add);
  const CLI::Validator ports = wholeNumber(1, 65535);
  command.add_option("--port", options.port, "Port of the server")
      ->capture_default_str()
      ->check(ports)
      ->needs(add);
  command
      .add_option("--own-ae-title", options.ownAeTitle,
                  "AE title by which the server knows this workstation")
      ->capture_default_str()
      ->needs(add);
  command
      .add_option("--retrieve", options.retrieve,
                  "How series are fetched: get, or move to this workstation's own port")
      ->capture_default_str()
      ->check(CLI::IsMember({"get", "move"}))
      ->needs(add);
  command
      .add_option("--own-port", options.ownPort,
                  "Port of this workstation during a move, as the server knows it")
      ->capture_default_str()
      ->check(ports)
      ->needs(add);
  CLI::Option* authority =
      command
          .add_option("--tls-authority", options.tlsAuthority,
                      "TLS: certificate of the authority that signed the server's (PEM)")
          ->needs(add);
  CLI::Option* certificate = command
                                 .add_option("--tls-certificate", options.tlsCertificate,
                                             "TLS: certificate of this workstation (PEM)")
                                 ->needs(authority);
  CLI::Option* key =
      command.add_option("--tls-key", options.tlsKey, "TLS: key of that certificate (PEM)")
          ->needs(certificate);
  certificate->needs(key);
  for (CLI::Option* file : {authority, certificate, key}) files.reads(file);
  addJson(command, files, options);
}

void addEcho(CLI::App& archive, FileOptions& files, ArchiveOptions& options)
{
  CLI::App& command = *archive.add_subcommand("echo", "Test whether a server answers");
  addServer(command, options);
  addJson(command, files, options);
}

void addFind(CLI::App& archive, FileOptions& files, ArchiveOptions& options)
{
  CLI::App& command =
      *archive.add_subcommand("find", "Find studies, or the series of one study; at most 500");
  addServer(command, options);
  CLI::Option* study =
      command.add_option("--study", options.study, "Study UID: list the series of this study");
  for (CLI::Option* condition :
       {command.add_option("--patient-id", options.patientId, "Patient number; * and ? match any"),
        command.add_option("--patient-name", options.patientName,
                           "Patient name, FAMILY^GIVEN; * and ? match any"),
        command.add_option("--birth-date", options.birthDate, "Birth date, YYYYMMDD"),
        command.add_option("--from", options.from, "First study date, YYYYMMDD"),
        command.add_option("--until", options.until, "Last study date, YYYYMMDD"),
        command.add_option("--modality", options.modality, "Modality of a series, such as CT")})
    condition->excludes(study);
  command
      .add_flag("--show-patients", options.showsPatients,
                "Show names, numbers and birth dates of patients, also in the JSON file")
      ->excludes(study);
  addJson(command, files, options);
}

void addFetch(CLI::App& archive, FileOptions& files, ArchiveOptions& options)
{
  CLI::App& command = *archive.add_subcommand(
      "fetch", "Fetch a series into a new folder; the same command resumes what was interrupted");
  addServer(command, options);
  command.add_option("--study", options.study, "Study UID, as listed by 'find'")->required();
  command.add_option("--series", options.series, "Series UID, as listed by 'find'")->required();
  files.writes(
      command
          .add_option("--out", options.out,
                      "New folder; until the series is complete it is called FOLDER.partial")
          ->required());
  addJson(command, files, options);
}

void addSend(CLI::App& archive, FileOptions& files, ArchiveOptions& options)
{
  CLI::App& command =
      *archive.add_subcommand("send", "Send a report into the study of the CT it was made from");
  addServer(command, options);
  files.reads(
      command.add_option("file", options.file, "DICOM file written by this program")->required());
  addJson(command, files, options);
}

}  // namespace

void addArchive(CLI::App& app, FileOptions& files, ArchiveOptions& options)
{
  CLI::App& archive = *app.add_subcommand(
      "archive", "Fetch a CT from a DICOM server, and send results into its study");
  archive.require_subcommand(1);
  addServers(archive, files, options);
  addEcho(archive, files, options);
  addFind(archive, files, options);
  addFetch(archive, files, options);
  addSend(archive, files, options);
}

Result<void> runArchive(const CLI::App& archive, const ArchiveOptions& options)
{
  if (archive.got_subcommand("servers")) return archiveServers(options);
  if (archive.got_subcommand("echo")) return archiveEcho(options);
  if (archive.got_subcommand("find")) return archiveFind(options);
  if (archive.got_subcommand("fetch")) return archiveFetch(options);
  return archiveSend(options);
}

}  // namespace perilymph::cli
