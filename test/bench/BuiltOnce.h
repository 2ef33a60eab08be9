// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <mutex>

namespace perilymph::bench {

/// A cache of objects that take long to build: the first thread that needs one builds it, and all
/// threads share it.
template <class Key, class Value>
class BuiltOnce {
public:
  /// The value of a key, built with `build(key)` at its first call.
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
