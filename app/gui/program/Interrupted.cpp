#include "Interrupted.h"

#include <spdlog/spdlog.h>

#include "MainWindow.h"
#include "Notice.h"
#include "Numbers.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

void offerInterrupted(MainWindow& window, const std::vector<std::filesystem::path>& recordings)
{
  for (const std::filesystem::path& recording : recordings) {
    const session::SessionSummary left = session::summarize(recording);
    spdlog::warn("The program ended while it was writing {}; {} ticks of it are kept.",
                 recording.string(), left.highlights.ticks);
    if (left.highlights.ticks == 0) continue;
    const QString depth = numberText(inMillimeters(Length::fromSi(left.highlights.deepest)), 1);
    const QString sentence =
        MainWindow::tr(
            "The program ended unexpectedly. The insertion of then, to a depth of %1 mm, "
            "is kept in the library: %2.")
            .arg(depth, QString::fromStdString(recording.stem().string()));
    QObject::connect(&window, &MainWindow::firstFrameShown, &window, [&window, sentence] {
      window.notice().offer(sentence, MainWindow::tr("Show sessions"),
                            [&window] { window.showPage(Page::sessions); });
    });
    return;
  }
}

}  // namespace perilymph::gui
