#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace limn
{

/// Appends values to a string of bytes, in the byte order of the machine.
class ByteWriter
{
public:
    template <typename T>
    requires std::is_arithmetic_v<T> || std::is_enum_v<T>
    void Value(const T& value) { m_Bytes.append(reinterpret_cast<const char*>(&value), sizeof(T)); }
    void Value(const std::string& text)
    {
        Value(static_cast<std::uint32_t>(text.size()));
        m_Bytes += text;
    }
    template <typename... Ts>
    void Values(const Ts&... values)
    {
        (Value(values), ...);
    }
    template <typename T, typename F>
    void List(const std::vector<T>& items, F&& each)
    {
        Value(static_cast<std::uint32_t>(items.size()));
        for (const T& item : items)
        {
            each(item);
        }
    }
    /// Appends numbers, or structures that contain only numbers, at once.
    template <typename T>
    requires std::is_trivially_copyable_v<T>
    void Array(const std::vector<T>& items)
    {
        Value(static_cast<std::uint64_t>(items.size()));
        m_Bytes.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(T));
    }
    const std::string& bytes() const { return m_Bytes; }

private:
    std::string m_Bytes;
};

/// Reads what ByteWriter wrote. Throws std::out_of_range if the bytes end too early.
class ByteReader
{
public:
    explicit ByteReader(std::string_view bytes) : m_Bytes(bytes) {}

    template <typename T>
    requires std::is_arithmetic_v<T> || std::is_enum_v<T>
    void Value(T& value)
    {
        const std::string_view raw = Take(sizeof(T));
        std::memcpy(&value, raw.data(), sizeof(T));
    }
    void Value(std::string& text)
    {
        std::uint32_t size = 0;
        Value(size);
        text = std::string(Take(size));
    }
    template <typename... Ts>
    void Values(Ts&... values)
    {
        (Value(values), ...);
    }
    template <typename T, typename F>
    void List(std::vector<T>& items, F&& each)
    {
        std::uint32_t size = 0;
        Value(size);
        if (size > m_Bytes.size())
        {
            throw std::out_of_range("list");
        }
        items.resize(size);
        for (T& item : items)
        {
            each(item);
        }
    }
    template <typename T>
    requires std::is_trivially_copyable_v<T>
    void Array(std::vector<T>& items)
    {
        std::uint64_t size = 0;
        Value(size);
        if (size > m_Bytes.size() / sizeof(T))
        {
            throw std::out_of_range("array");
        }
        const std::string_view raw = Take(static_cast<std::size_t>(size) * sizeof(T));
        if constexpr (sizeof(T) == 1)
        {
            // Millions of them are not filled with zeros first.
            const T* first = reinterpret_cast<const T*>(raw.data());
            items.assign(first, first + raw.size());
        }
        else if (items.resize(static_cast<std::size_t>(size)); !raw.empty())
        {
            std::memcpy(static_cast<void*>(items.data()), raw.data(), raw.size());
        }
    }

private:
    std::string_view Take(std::size_t size)
    {
        if (size > m_Bytes.size())
        {
            throw std::out_of_range("value");
        }
        const std::string_view taken = m_Bytes.substr(0, size);
        m_Bytes.remove_prefix(size);
        return taken;
    }

    std::string_view m_Bytes;
};

} // namespace limn
