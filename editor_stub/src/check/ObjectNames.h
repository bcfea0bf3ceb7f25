#pragma once

#include "explain/Explanation.h"

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// For each renderer of a scene whether it is in the set.
using RendererSet = std::vector<bool>;

/// The names that expectations call a scene's renderers by. A name stands for every object of that
/// name and all that hangs below it; "Sofa/Back" is a Back below a Sofa, "/Sofa" a Sofa that hangs
/// below nothing, and "Leg/#2" the second of several objects of one path. In a list "not NAME"
/// takes away what a name before it gave.
class ObjectNames
{
public:
    /// @param objects  in the scene's order, which is that of the sets
    explicit ObjectNames(const std::vector<ExplainedObject>& objects);
    ObjectNames(const ObjectNames&) = delete;
    ObjectNames& operator=(const ObjectNames&) = delete;
    ~ObjectNames();

    std::size_t count() const { return m_Paths.size(); }

    /// Returns the renderers that one item of a list is about; none for an unknown name.
    std::vector<std::size_t> Find(std::string_view item) const;
    /// Returns the renderers that a list stands for.
    RendererSet Evaluate(const std::vector<std::string>& items) const;
    /// "'Lampp'; did you mean 'Lamp'?"
    std::string UnknownSentence(std::string_view item) const;

    /// Changes a list as little as is simple, so that it stands for `wanted`.
    std::vector<std::string> Fix(std::vector<std::string> items, const RendererSet& wanted) const;

    /// Names for a message, each with the number of renderers where it stands for a part of an
    /// object only: "Sofa (12 of 13 renderers)".
    /// @param others  never part of what a name stands for
    std::vector<std::string> Describe(const RendererSet& members, const RendererSet& others) const;

private:
    struct Node;
    class Fixer;

    bool IsTakenAway(std::string_view item) const; ///< "not NAME"
    std::vector<std::size_t> FindName(std::string_view name) const;
    std::string Spell(const Node& node) const;
    void Describe(const Node& node, const RendererSet& members, const RendererSet& others,
                  std::vector<std::string>& names) const;

    std::unique_ptr<Node> m_Root;
    std::vector<std::string> m_Paths; ///< "/Room/Sofa/Back/", of each renderer
    /// The renderers on whose path each name is, in their order.
    std::map<std::string, std::vector<std::size_t>, std::less<>> m_PlacesOf;
    bool m_HasSlashes = false; ///< within the name of an object
};

} // namespace limn
