#pragma once

#include <charconv>
#include <cstdint>
#include <deque>
#include <limn/base/Diagnostic.h>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// A value as a UnityTree holds it: in front of the values below it.
struct UnityValue
{
    enum class Kind : std::uint8_t
    {
        Scalar,
        Map,
        List
    };
    std::string_view key;
    std::string_view text;
    std::uint32_t size = 1; ///< the number of values: this one and those below it
    std::int32_t line = 0;
    Kind kind = Kind::Scalar;
};

/// A value of a UnityTree, and the way to the values below it. It must not outlive its tree. A
/// value that is not there is empty: its text is "", it has no children, and nothing below it is
/// there either.
class UnityNode
{
public:
    UnityNode() = default;

    explicit operator bool() const { return m_Value != &k_Nothing; }

    /// Returns the text of a scalar without its quotes, or "" for everything else.
    std::string_view text() const { return m_Value->text; }
    /// Returns the key in the map above, or "" for items of a list.
    std::string_view key() const { return m_Value->key; }
    int line() const { return m_Value->line; } ///< in the file, from 1; 0 if it is not there
    bool isList() const { return m_Value->kind == UnityValue::Kind::List; }
    bool isMap() const { return m_Value->kind == UnityValue::Kind::Map; }

    /// Returns the value of a map's key. Among several equal keys the last one counts, as in Unity.
    UnityNode operator[](std::string_view key) const;
    UnityNode At(std::size_t index) const; ///< returns an item of a list

    class Iterator
    {
    public:
        explicit Iterator(const UnityValue* value) : m_Value(value) {}
        UnityNode operator*() const { return UnityNode(m_Value); }
        Iterator& operator++()
        {
            m_Value += m_Value->size;
            return *this;
        }
        bool operator==(const Iterator&) const = default;

    private:
        const UnityValue* m_Value;
    };
    /// Returns the entries of a map or the items of a list, in the file's order.
    Iterator begin() const { return Iterator(m_Value + 1); }
    Iterator end() const { return Iterator(m_Value + m_Value->size); }

private:
    friend class UnityTree;
    explicit UnityNode(const UnityValue* value) : m_Value(value) {}

    static constexpr UnityValue k_Nothing{};
    const UnityValue* m_Value = &k_Nothing;
};

/// Returns the number that a value's text begins with, or `otherwise` if it begins with none.
template <typename Number>
Number NumberOf(const UnityNode& node, Number otherwise)
{
    const std::string_view text = node.text();
    std::from_chars(text.data(), text.data() + text.size(), otherwise);
    return otherwise;
}

/// The body of one object of a Unity text asset, or a .meta file. It reads the part of YAML that
/// Unity writes: maps and lists in lines or in braces, plain and quoted text that may continue in
/// the next lines. Text stays text: callers that need a number convert it. Keys may repeat, as in
/// materials of Unity 4. Takes time and memory linear in the text. The text must outlive the tree.
class UnityTree
{
public:
    /// @param file       the file's name in errors
    /// @param firstLine  the number of the text's first line in that file
    /// @throws AssetError  at the first line that Unity would not write in that way
    UnityTree(std::string_view text, const std::string& file, int firstLine);
    UnityTree(const UnityTree&) = delete;
    UnityTree& operator=(const UnityTree&) = delete;

    UnityNode root() const { return UnityNode(m_Values.data()); } ///< a map

private:
    friend class UnityTreeReader;

    std::vector<UnityValue> m_Values;
    std::deque<std::string> m_Texts; ///< texts that differ from those in the file
};

} // namespace limn
