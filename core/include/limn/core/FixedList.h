#pragma once

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limn/base/Diagnostic.h>
#include <string>

namespace limn
{

/// A vector of at most `Most` values, which it stores in itself: it allocates no memory.
template <typename Value, std::size_t Most>
class FixedList
{
public:
    using value_type = Value;
    using iterator = Value*;
    using const_iterator = const Value*;

    FixedList() = default;
    /// @throws ContractError for more than `Most` values
    FixedList(std::initializer_list<Value> values) { assign(values.begin(), values.end()); }
    template <typename Iterator>
    FixedList(Iterator first, Iterator last)
    {
        assign(first, last);
    }

    /// @throws ContractError for more than `Most` values
    template <typename Iterator>
    void assign(Iterator first, Iterator last)
    {
        clear();
        for (; first != last; ++first)
        {
            push_back(*first);
        }
    }
    /// @throws ContractError for more than `Most` values
    void resize(std::size_t size)
    {
        RequireRoom(size);
        std::fill(begin() + std::min(size, m_Size), end(), Value());
        m_Size = size;
    }
    /// @throws ContractError for more than `Most` values
    void push_back(Value value)
    {
        RequireRoom(m_Size + 1);
        m_Values[m_Size++] = std::move(value);
    }
    void clear() { resize(0); }

    std::size_t size() const { return m_Size; }
    bool full() const { return m_Size == Most; }
    bool empty() const { return m_Size == 0; }
    iterator begin() { return m_Values.data(); }
    iterator end() { return begin() + m_Size; }
    const_iterator begin() const { return m_Values.data(); }
    const_iterator end() const { return begin() + m_Size; }
    Value& operator[](std::size_t index) { return m_Values[index]; }
    const Value& operator[](std::size_t index) const { return m_Values[index]; }
    Value& front() { return m_Values[0]; }
    const Value& front() const { return m_Values[0]; }
    const Value& back() const { return m_Values[m_Size - 1]; }

    bool operator==(const FixedList& other) const
    {
        return std::equal(begin(), end(), other.begin(), other.end());
    }

private:
    static void RequireRoom(std::size_t size)
    {
        if (size > Most)
        {
            throw ContractError("a list of at most " + std::to_string(Most) + " was given " +
                                std::to_string(size) + " values");
        }
    }

    std::array<Value, Most> m_Values{};
    std::size_t m_Size = 0;
};

} // namespace limn
