// SPDX-License-Identifier: BSD-3-Clause
#include "recording/BlockTable.h"

#include <Eigen/QR>
#include <cmath>

#include "perilymph/haptics/Snapshot.h"
#include "recording/TickFields.h"

namespace perilymph::session {

namespace {

BlockColumns listColumns()
{
  const haptics::TickRecord record;
  std::vector<const void*> fields;
  forEachColumn(record, [&fields](const auto& field) { fields.push_back(&field); });
  const auto at = [&fields](const double& field) {
    return static_cast<std::size_t>(std::find(fields.begin(), fields.end(), &field) -
                                    fields.begin());
  };
  const auto three = [&at](const std::array<double, 3>& values) {
    return std::vector<std::size_t>{at(values[0]), at(values[1]), at(values[2])};
  };
  const haptics::TickOutput& output = record.output;
  const auto force_W = three(output.force_W);
  BlockColumns columns{fields.size(),
                       {{at(output.depth), {at(output.travel)}}, {at(output.axialForce), force_W}}};
  for (std::size_t i = 0; i < 3; ++i) {
    columns.relations.push_back({at(output.wrench_D.force_D[i]), force_W});
    columns.relations.push_back({at(output.device_W[i]), three(record.sample.position_D)});
  }
  return columns;
}

}  // namespace

const BlockColumns& columnsOfATick()
{
  static const BlockColumns columns = listColumns();
  return columns;
}

std::uint64_t BlockTable::predicted(const BlockColumns::Relation& relation,
                                    const Coefficients& terms, std::size_t row) const
{
  double sum = terms[0];
  for (std::size_t i = 0; i < relation.sources.size(); ++i)
    sum += terms[i + 1] * real(relation.sources[i], row);
  return std::bit_cast<std::uint64_t>(std::isfinite(sum) ? sum : 0.0);
}

Coefficients BlockTable::fit(const BlockColumns::Relation& relation) const
{
  const auto rows = static_cast<Eigen::Index>(rows_);
  const auto sources = static_cast<Eigen::Index>(relation.sources.size());
  const auto vector = [&](std::size_t column) {
    Eigen::VectorXd values(rows);
    for (std::size_t i = 0; i < rows_; ++i) values[static_cast<Eigen::Index>(i)] = real(column, i);
    return values;
  };
  Eigen::MatrixXd x(rows, sources);
  for (Eigen::Index i = 0; i < sources; ++i)
    x.col(i) = vector(relation.sources[static_cast<std::size_t>(i)]);
  const Eigen::VectorXd y = vector(relation.target);
  Coefficients terms{};
  if (!x.allFinite() || !y.allFinite()) return terms;
  const Eigen::RowVectorXd meanX = x.colwise().mean();
  const double meanY = y.mean();
  x.rowwise() -= meanX;
  const Eigen::VectorXd slopes = x.colPivHouseholderQr().solve((y.array() - meanY).matrix());
  terms[0] = meanY - meanX.dot(slopes);
  for (Eigen::Index i = 0; i < sources; ++i) terms[static_cast<std::size_t>(i) + 1] = slopes[i];
  return terms;
}

}  // namespace perilymph::session
