#pragma once

#include <limn/base/Diagnostic.h>
#include <limn/core/PluginCallSite.h>
#include <memory>

// Pointers that say so where nothing is used as if it were an object, as C# does with a
// NullReferenceException. `limn port` writes them, as no C++ compiler asks whether something is
// null.

namespace limn
{

namespace detail
{

/// Returns the object.
/// @throws ContractError naming the type if there is none
template <typename T>
T& NotNull(T* object)
{
    if (object == nullptr)
    {
        throw ContractError("a '" + TypeName(typeid(T)) +
                            "' is used that is null: nobody has set it");
    }
    return *object;
}

} // namespace detail

/// A std::shared_ptr of which `->` and `*` throw ContractError if it is null.
template <typename T>
class Shared : public std::shared_ptr<T>
{
public:
    using std::shared_ptr<T>::shared_ptr;
    Shared(std::shared_ptr<T> object) : std::shared_ptr<T>(std::move(object)) {}
    T* operator->() const { return &detail::NotNull(this->get()); }
    T& operator*() const { return detail::NotNull(this->get()); }
};

/// A std::unique_ptr of which `->` and `*` throw ContractError if it is null.
template <typename T>
class Owned : public std::unique_ptr<T>
{
public:
    using std::unique_ptr<T>::unique_ptr;
    using std::unique_ptr<T>::operator=;
    T* operator->() const { return &detail::NotNull(this->get()); }
    T& operator*() const { return detail::NotNull(this->get()); }
};

/// A pointer to an object of another owner, of which `->` and `*` throw ContractError if it is
/// null.
template <typename T>
class Borrowed
{
public:
    Borrowed(T* object = nullptr) : m_Object(object) {}
    operator T*() const { return m_Object; }
    T* operator->() const { return &detail::NotNull(m_Object); }
    T& operator*() const { return detail::NotNull(m_Object); }

private:
    T* m_Object;
};

} // namespace limn
