// SPDX-License-Identifier: BSD-3-Clause
#include "RecordColumns.h"

#include "Bindings.h"
#include "NumberArrays.h"

namespace perilymph::python {

void RecordColumns::add(const haptics::TickRecord& tick)
{
  if (!period_.keeps(tick.output.time)) return;
  const auto values = session::columnValues(tick);
  for (std::size_t i = 0; i < values.size(); ++i) columns_[i].push_back(values[i]);
}

py::dict RecordColumns::result()
{
  py::dict found = dictOfRenamed();
  for (std::size_t i = 0; i < columns_.size(); ++i)
    found[session::columnNames[i]] = arrayOf(std::move(columns_[i]));
  return found;
}

}  // namespace perilymph::python
