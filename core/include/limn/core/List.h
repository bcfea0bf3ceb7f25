#pragma once

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace limn
{

/// A std::vector with the members that lines of C# call, which exists for such lines only: wherever
/// limn takes a std::vector or a std::span, it takes a List. .NET:
/// System.Collections.Generic.List<T>.
template <typename T>
class List : public std::vector<T>
{
public:
    using std::vector<T>::vector;
    List() = default;
    List(std::vector<T> values) : std::vector<T>(std::move(values)) {}

    int Count() const { return static_cast<int>(this->size()); }
    void Add(T item) { this->push_back(std::move(item)); }
    template <typename Range>
    void AddRange(const Range& items)
    {
        this->insert(this->end(), std::begin(items), std::end(items));
    }
    /// @throws std::out_of_range unless 0 <= index <= Count()
    void Insert(int index, T item)
    {
        ExpectIndex(index, Count());
        this->insert(this->begin() + index, std::move(item));
    }
    void Clear() { this->clear(); }
    bool Contains(const T& item) const { return IndexOf(item) >= 0; }
    /// Returns the index of the first item that is equal; -1 = none.
    int IndexOf(const T& item) const
    {
        const auto found = std::find(this->begin(), this->end(), item);
        return found == this->end() ? -1 : static_cast<int>(found - this->begin());
    }
    /// Removes the first item that is equal. @return whether there was one
    bool Remove(const T& item)
    {
        const int index = IndexOf(item);
        if (index >= 0)
        {
            RemoveAt(index);
        }
        return index >= 0;
    }
    /// @throws std::out_of_range unless 0 <= index < Count()
    void RemoveAt(int index)
    {
        ExpectIndex(index, Count() - 1);
        this->erase(this->begin() + index);
    }

private:
    static void ExpectIndex(int index, int last)
    {
        if (index < 0 || index > last)
        {
            throw std::out_of_range("List: index " + std::to_string(index) + " of 0..." +
                                    std::to_string(last));
        }
    }
};

} // namespace limn
