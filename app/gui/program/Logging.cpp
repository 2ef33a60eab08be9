// SPDX-License-Identifier: BSD-3-Clause
#include "gui/program/Logging.h"

#include <spdlog/sinks/rotating_file_sink.h>
#include <spdlog/spdlog.h>

#include <QString>
#include <memory>
#include <system_error>

namespace perilymph::gui {

namespace {

constexpr std::size_t maxBytes = 1 << 20;
constexpr std::size_t olderFiles = 3;

QtMessageHandler handlerOfQt = nullptr;  // Qt's own handler; set once, before any thread

void log(QtMsgType type, const QMessageLogContext& context, const QString& message)
{
  switch (type) {
    case QtDebugMsg:
      break;
    case QtInfoMsg:
      spdlog::info("{}", message.toStdString());
      break;
    case QtWarningMsg:
      spdlog::warn("{}", message.toStdString());
      break;
    case QtCriticalMsg:
    case QtFatalMsg:
      spdlog::error("{}", message.toStdString());
      break;
  }
  if (handlerOfQt != nullptr) handlerOfQt(type, context, message);
}

}  // namespace

Result<void> startLog(const std::filesystem::path& folder)
{
  std::error_code ignored;  // an error is reported when the file is opened
  std::filesystem::create_directories(folder, ignored);
  const std::filesystem::path file = folder / "perilymph.log";
  if (std::filesystem::is_symlink(std::filesystem::symlink_status(file, ignored)))
    return Error{"The log %1 is a link, which is not followed. Remove it, or set XDG_STATE_HOME.",
                 file};
  try {
    auto sink =
        std::make_shared<spdlog::sinks::rotating_file_sink_mt>(file.string(), maxBytes, olderFiles);
    auto logger = std::make_shared<spdlog::logger>("perilymph", std::move(sink));
    logger->flush_on(spdlog::level::info);
    spdlog::set_default_logger(std::move(logger));
  } catch (const spdlog::spdlog_ex& thrown) {
    return Error{
        "The log %1 cannot be written: %2. Make its folder writable, or set XDG_STATE_HOME.", file,
        thrown.what()};
  }
  if (handlerOfQt == nullptr) handlerOfQt = qInstallMessageHandler(log);
  return {};
}

}  // namespace perilymph::gui
