#pragma once

#include "hlsl/Declarations.h"

#include <cstddef>
#include <cstdint>
#include <deque>

namespace limn
{

enum class HlslNodeKind : std::uint8_t
{
    Unknown, ///< not understood, so it stays as it is
    // Expressions; `token` is their operator, name or number.
    Literal,
    Name,
    Call,      ///< f(children)
    Construct, ///< float3(children)
    Method,    ///< child 0 . f(children)
    Member,    ///< child . name
    Index,     ///< child 0 [child 1]
    Prefix,
    Postfix,
    Binary, ///< the comma as well
    Assign,
    Ternary,
    Cast,  ///< (type) child
    Paren, ///< (child)
    List,  ///< { children }
    // Statements.
    Empty, ///< also an omitted part of a `for`
    Block,
    Declaration, ///< children: Declarators; `token` is the first of its type
    Declarator,  ///< `token` is the name; child: the value, where it has one
    Expression,
    If, ///< condition, statement, else
    For,
    While,
    Do, ///< statement, condition
    Switch,
    Label, ///< case child: or default:
    Return,
};

/// A statement or expression of a function, with the tokens of its text.
struct HlslNode
{
    HlslNodeKind kind = HlslNodeKind::Unknown;
    std::uint32_t first = 0;
    std::uint32_t end = 0; ///< one behind its last token
    std::uint32_t token = 0;
    HlslNode* child = nullptr; ///< first
    HlslNode* last = nullptr;  ///< child
    HlslNode* next = nullptr;  ///< its sibling
    HlslNode* parent = nullptr;
    /// The type of an expression or a declarator. Those of a Cast and a Construct are known from
    /// the text, the others from ResolveTypes().
    HlslType type;
    // The declaration of a Name, set by ResolveTypes(); both are null if it is not declared.
    HlslNode* local = nullptr;              ///< Declarator
    const HlslVariable* variable = nullptr; ///< a parameter, member or global
    const HlslFunction* function = nullptr; ///< the author's function that a Call or Method means
    /// A Call of the language's function, although the author has others of its name.
    bool isIntrinsic = false;

    HlslNode* Child(std::size_t index) const
    {
        HlslNode* node = child;
        for (; node && index > 0; --index)
        {
            node = node->next;
        }
        return node;
    }
    void Add(HlslNode* added)
    {
        added->parent = this;
        (last ? last->next : child) = added;
        last = added;
    }
    std::size_t CountChildren() const
    {
        std::size_t count = 0;
        for (const HlslNode* node = child; node; node = node->next)
        {
            ++count;
        }
        return count;
    }
    /// Returns the first argument of a Call or Method, or null if it has none.
    HlslNode* FirstArgument() const { return kind == HlslNodeKind::Method ? child->next : child; }
};

/// Owns nodes, which keep their addresses. It cannot be copied, because the copied nodes would
/// point at the original's.
struct HlslNodes : std::deque<HlslNode>
{
    HlslNodes() = default;
    HlslNodes(HlslNodes&&) = default;
    HlslNodes& operator=(HlslNodes&&) = default;
};

/// Returns the first node of a tree for which `holds` returns true, or null if there is none.
template <typename F>
const HlslNode* FindNode(const HlslNode& root, F&& holds)
{
    if (holds(root))
    {
        return &root;
    }
    const HlslNode* found = nullptr;
    for (const HlslNode* child = root.child; child && !found; child = child->next)
    {
        found = FindNode(*child, holds);
    }
    return found;
}

} // namespace limn
