#pragma once

#include <cstdint>
#include <deque>
#include <limn/base/Diagnostic.h>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

class UnityTree;

/// A value of a UnityTree, and the way to the values below it. It must not outlive its tree. A
/// value that is not there is empty: its text is "", it has no children, and nothing below it is
/// there either.
class UnityNode
{
public:
    UnityNode() = default;

    explicit operator bool() const { return m_Tree != nullptr; }

    /// Returns the text of a scalar without its quotes, or "" for everything else.
    std::string_view text() const;
    /// Returns the key in the map above, or "" for items of a list.
    std::string_view key() const;
    int line() const; ///< in the file, from 1; 0 if it is not there
    bool isList() const;
    bool isMap() const;

    /// Returns the value of a map's key. Among several equal keys the last one counts, as in Unity.
    UnityNode operator[](std::string_view key) const;

    class Iterator
    {
    public:
        Iterator(const UnityTree* tree, std::uint32_t index) : m_Tree(tree), m_Index(index) {}
        UnityNode operator*() const { return UnityNode(m_Tree, m_Index); }
        Iterator& operator++();
        bool operator==(const Iterator& other) const { return m_Index == other.m_Index; }

    private:
        const UnityTree* m_Tree;
        std::uint32_t m_Index;
    };
    Iterator begin() const; ///< the entries of a map or the items of a list, in the file's order
    Iterator end() const;

private:
    friend class UnityTree;
    UnityNode(const UnityTree* tree, std::uint32_t index) : m_Tree(tree), m_Index(index) {}

    const UnityTree* m_Tree = nullptr;
    std::uint32_t m_Index = 0;
};

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

    UnityNode root() const { return UnityNode(this, 0); } ///< a map

private:
    friend class UnityNode;
    friend class UnityTreeReader;

    enum class Kind : std::uint8_t
    {
        Scalar,
        Map,
        List
    };
    static constexpr std::uint32_t k_None = ~std::uint32_t{0};
    struct Node
    {
        std::string_view key;
        std::string_view text;
        std::uint32_t firstChild = k_None;
        std::uint32_t next = k_None;
        std::int32_t line = 0;
        Kind kind = Kind::Scalar;
    };

    std::vector<Node> m_Nodes;
    std::deque<std::string> m_Texts; ///< texts that differ from those in the file
};

} // namespace limn
