// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <system_error>

#include "Commands.h"
#include "Interruption.h"
#include "JsonText.h"
#include "OutputFolder.h"
#include "Terminal.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Version.h"
#if PERILYMPH_HAS_TOOLKIT
#include "perilymph/archive/Echo.h"
#include "perilymph/archive/Fetch.h"
#include "perilymph/archive/Query.h"
#include "perilymph/archive/Send.h"
#include "perilymph/archive/Servers.h"
#include "perilymph/imaging/CtSeries.h"
#endif

namespace perilymph::cli {

#if PERILYMPH_HAS_TOOLKIT

namespace {

using archive::Server;
using Json = nlohmann::ordered_json;

Json newResult(const std::string& server)
{
  Json json;
  json["version"] = version();
  json["server"] = server;
  return json;
}

Result<void> writeJson(const ArchiveOptions& options, const Json& json)
{
  if (options.json.empty()) return {};
  return writeWhole(options.json, jsonText(json), {Links::followed, Audience::owner});
}

/// A request that a signal cancels.
archive::Exchange interruptible()
{
  archive::Exchange exchange;
  exchange.stop = watchForInterruption();
  exchange.onWait = [] { static_cast<void>(isInterrupted()); };
  return exchange;
}

std::string absolute(const std::string& file)
{
  std::error_code ignored;
  return file.empty() ? file : std::filesystem::absolute(file, ignored).lexically_normal().string();
}

Server serverOf(const ArchiveOptions& options)
{
  Server server;
  server.name = options.add;
  server.aeTitle = options.aeTitle;
  server.host = options.host;
  server.port = options.port;
  server.ownAeTitle = options.ownAeTitle;
  server.retrieval =
      options.retrieve == "move" ? archive::Retrieval::move : archive::Retrieval::get;
  server.ownPort = options.ownPort;
  if (!options.tlsAuthority.empty())
    server.tls = archive::TlsFiles{absolute(options.tlsAuthority), absolute(options.tlsCertificate),
                                   absolute(options.tlsKey)};
  return server;
}

Json described(const Server& server)
{
  const bool isMove = server.retrieval == archive::Retrieval::move;
  Json json;
  json["name"] = server.name;
  json["ae_title"] = server.aeTitle;
  json["host"] = server.host;
  json["port"] = server.port;
  json["own_ae_title"] = server.ownAeTitle;
  json["retrieve"] = isMove ? "move" : "get";
  json["own_port"] = server.ownPort;
  json["tls"] = server.tls.has_value();
  return json;
}

/// Changes the list as asked for. @return Whether it has changed.
Result<bool> change(std::vector<Server>& servers, const ArchiveOptions& options)
{
  const std::string& name = options.add.empty() ? options.remove : options.add;
  if (name.empty()) return false;
  const auto found = std::find_if(servers.begin(), servers.end(),
                                  [&name](const Server& server) { return server.name == name; });
  if (!options.add.empty() && found == servers.end())
    servers.push_back(serverOf(options));
  else if (!options.add.empty())
    *found = serverOf(options);
  else if (found == servers.end())
    return Error{"There is no server '%1' to be removed.", name};
  else
    servers.erase(found);
  return true;
}

std::string orUnknown(const std::string& text) { return text.empty() ? "?" : text; }

/// The studies or series of an answer, and whether there were more.
void printCount(std::size_t count, bool isCut, const char* what)
{
  if (isCut)
    print("the first {} {}; the server has more: narrow the query\n", count, what);
  else
    print("{} {}\n", count, what);
}

Result<void> findSeriesOf(const Server& server, const ArchiveOptions& options)
{
  const auto found = archive::findSeries(server, options.study, interruptible());
  if (!found) return found.error();
  Json json = newResult(server.name);
  json["study_uid"] = options.study;
  json["cut"] = found->isCut;
  json["series"] = Json::array();
  printCount(found->rows.size(), found->isCut, "series");
  for (const archive::FoundSeries& series : found->rows) {
    Json one;
    one["series_uid"] = series.uid;
    one["number"] = series.number;
    one["modality"] = series.modality;
    one["description"] = series.description;
    one["images"] = series.images ? Json(*series.images) : Json(nullptr);
    json["series"].push_back(one);
    const std::string images = series.images ? std::to_string(*series.images) : "?";
    print("{}\n    {} {}, {} images{}\n", series.uid, orUnknown(series.modality),
          orUnknown(series.number), images,
          series.description.empty() ? "" : ", " + series.description);
  }
  return writeJson(options, json);
}

Result<void> findStudiesOf(const Server& server, const ArchiveOptions& options)
{
  const archive::StudyQuery query{options.patientId, options.patientName, options.birthDate,
                                  options.from,      options.until,       options.modality};
  const auto found = archive::findStudies(server, query, interruptible());
  if (!found) return found.error();
  Json json = newResult(server.name);
  json["cut"] = found->isCut;
  json["studies"] = Json::array();
  printCount(found->rows.size(), found->isCut, "studies");
  for (const archive::FoundStudy& study : found->rows) {
    Json one;
    one["study_uid"] = study.uid;
    one["date"] = study.date;
    one["modalities"] = study.modalities;
    one["description"] = study.description;
    if (options.showsPatients) {
      one["patient_name"] = study.patientName;
      one["patient_id"] = study.patientId;
      one["birth_date"] = study.birthDate;
    }
    json["studies"].push_back(one);
    print("{}\n    {}, {}{}\n", study.uid, orUnknown(study.date), orUnknown(study.modalities),
          study.description.empty() ? "" : ", " + study.description);
    if (options.showsPatients)
      print("    {}, {}, born {}\n", orUnknown(study.patientName), orUnknown(study.patientId),
            orUnknown(study.birthDate));
  }
  return writeJson(options, json);
}

}  // namespace

Result<void> archiveServers(const ArchiveOptions& options)
{
  auto servers = archive::readServers();
  if (!servers) return servers.error();
  const auto hasChanged = change(*servers, options);
  if (!hasChanged) return hasChanged.error();
  if (*hasChanged)
    if (const auto written = archive::writeServers(*servers); !written) return written;
  Json json;
  json["version"] = version();
  json["file"] = archive::serversFile().string();
  json["servers"] = Json::array();
  print("{} servers in {}\n", servers->size(), archive::serversFile());
  for (const Server& server : *servers) {
    json["servers"].push_back(described(server));
    print("{}\n    {} at {}:{}{}, by {} as {}\n", server.name, server.aeTitle, server.host,
          server.port, server.tls ? " with TLS" : "",
          server.retrieval == archive::Retrieval::move
              ? "move to port " + std::to_string(server.ownPort)
              : "get",
          server.ownAeTitle);
  }
  return writeJson(options, json);
}

Result<void> archiveEcho(const ArchiveOptions& options)
{
  const auto server = archive::readServer(options.server);
  if (!server) return server.error();
  if (const auto answered = archive::echo(*server, interruptible()); !answered) return answered;
  print("{} answers\n", server->name);
  Json json = newResult(server->name);
  json["answers"] = true;
  return writeJson(options, json);
}

Result<void> archiveFind(const ArchiveOptions& options)
{
  const auto server = archive::readServer(options.server);
  if (!server) return server.error();
  return options.study.empty() ? findStudiesOf(*server, options) : findSeriesOf(*server, options);
}

Result<void> archiveFetch(const ArchiveOptions& options)
{
  const auto server = archive::readServer(options.server);
  if (!server) return server.error();
  archive::Exchange exchange = interruptible();
  exchange.onProgress = [](double fraction) {
    constexpr std::size_t all = 100;  // percent
    showProgress("fetched", static_cast<std::size_t>(std::lround(fraction * all)), all);
  };
  const auto fetched =
      archive::fetchSeries(*server, {options.study, options.series}, options.out, exchange);
  if (!fetched) return fetched.error();
  print("{} images in {}, {} of them from an earlier call\n", fetched->images, options.out,
        fetched->resumed);
  Json json = newResult(server->name);
  json["study_uid"] = options.study;
  json["series_uid"] = options.series;
  json["folder"] = options.out;
  json["images"] = fetched->images;
  json["resumed"] = fetched->resumed;
  // What arrived is checked as any folder.
  const auto list = imaging::findSeries(options.out);
  const imaging::CtSeries* series = list && !list->series.empty() ? &list->series.front() : nullptr;
  const Sentence obstacle = series == nullptr
                                ? list ? Sentence{"It holds no image."} : list.error().message
                                : series->obstacle;
  json["readable"] = obstacle.empty();
  json["obstacle"] = obstacle;
  if (!obstacle.empty()) print("It cannot be measured. {}\n", obstacle);
  return writeJson(options, json);
}

Result<void> archiveSend(const ArchiveOptions& options)
{
  const auto server = archive::readServer(options.server);
  if (!server) return server.error();
  const auto sent = archive::sendObject(*server, options.file, interruptible());
  if (!sent) return sent.error();
  print("stored in the study {} as series {}\n", sent->studyUid, sent->seriesNumber);
  if (!sent->warning.empty()) print("{}\n", sent->warning);
  Json json = newResult(server->name);
  json["study_uid"] = sent->studyUid;
  json["series_uid"] = sent->seriesUid;
  json["instance_uid"] = sent->instanceUid;
  json["series_number"] = sent->seriesNumber;
  json["warning"] = sent->warning;
  return writeJson(options, json);
}

#else

namespace {

Error withoutToolkit()
{
  return Error{"This build has no DICOM network; use a build of the preset release."};
}

}  // namespace

Result<void> archiveServers(const ArchiveOptions&) { return withoutToolkit(); }
Result<void> archiveEcho(const ArchiveOptions&) { return withoutToolkit(); }
Result<void> archiveFind(const ArchiveOptions&) { return withoutToolkit(); }
Result<void> archiveFetch(const ArchiveOptions&) { return withoutToolkit(); }
Result<void> archiveSend(const ArchiveOptions&) { return withoutToolkit(); }

#endif

}  // namespace perilymph::cli
