// SPDX-License-Identifier: MIT
// Values of different types, one of each.
#pragma once

#include <any>
#include <typeindex>
#include <unordered_map>

namespace bake {

/// What it holds it need not know: a scene keeps every effect's settings so, and only who asks for an effect's includes that effect.
class ByType {
 public:
  /// The value of that type; its defaults if none was set.
  template <class Value>
  const Value& get() const {
    static const Value k_defaults{};
    const auto found = values_.find(typeid(Value));
    return found == values_.end() ? k_defaults : *std::any_cast<Value>(&found->second);
  }
  /// The same to be changed.
  template <class Value>
  Value& get() {
    std::any& value = values_[typeid(Value)];
    if (!value.has_value()) value = Value{};
    return *std::any_cast<Value>(&value);
  }

 private:
  std::unordered_map<std::type_index, std::any> values_;
};

}  // namespace bake
