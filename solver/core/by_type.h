// SPDX-License-Identifier: MIT
// A container for values of different types, at most one of each type.
#pragma once

#include <any>
#include <typeindex>
#include <unordered_map>

namespace bake {

/// The container does not name the types that it holds. A scene keeps the settings of all effects in it, so that only code which asks for
/// the settings of an effect has to include that effect's header.
class ByType {
 public:
  /// The value of that type; a default-constructed one if none was set.
  template <class Value>
  const Value& get() const {
    static const Value k_defaults{};
    const auto found = values_.find(typeid(Value));
    return found == values_.end() ? k_defaults : *std::any_cast<Value>(&found->second);
  }
  /// The same, to change it.
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
