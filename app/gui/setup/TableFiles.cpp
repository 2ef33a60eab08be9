// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/TableFiles.h"

#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::gui {

Result<void> writeTable(const std::filesystem::path& file, const std::string& csv,
                        const std::string& dictionary)
{
  if (const auto written = writeWhole(file, csv, {Links::refused}); !written) return written;
  return writeWhole(file.parent_path() / (file.stem().string() + "-dictionary.csv"), dictionary,
                    {Links::refused});
}

}  // namespace perilymph::gui
