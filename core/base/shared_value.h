#pragma once

#include <memory>
#include <utility>

namespace kumite {

/// A value that is never changed in place, so that its copies share it: what makes snapshots of a
/// project cheap. Compares by value.
template <typename T>
class SharedValue {
public:
    SharedValue() : value_(std::make_shared<const T>()) {}
    SharedValue(T value) : value_(std::make_shared<const T>(std::move(value))) {}

    const T& operator*() const { return *value_; }
    const T* operator->() const { return value_.get(); }

    bool operator==(const SharedValue& other) const {
        return value_ == other.value_ || *value_ == *other.value_;
    }

private:
    std::shared_ptr<const T> value_;
};

}  // namespace kumite
