// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <mutex>

namespace perilymph::bench {

/// Things that take long to build, each built by whichever thread asks for it first and then shared
/// by all.
template <class Key, class Value>
class BuiltOnce {
public:
  /// The value of a key: `build(key)`, at the first call for that key.
  template <class Build>
  const Value& of(const Key& key, const Build& build)
  {
    const std::scoped_lock lock(mutex_);
    const auto found = values_.find(key);
    return (found != values_.end() ? found : values_.emplace(key, build(key)).first)->second;
  }

private:
  std::mutex mutex_;
  std::map<Key, Value> values_;
};

}  // namespace perilymph::bench
