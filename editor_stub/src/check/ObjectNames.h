#pragma once

#include "explain/Explanation.h"

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// A set of renderers: one flag for each renderer of a scene, true if it is in the set.
using RendererSet = std::vector<bool>;

/// The names by which expectations call a scene's renderers. A name stands for every object of that
/// name and everything below it. "Sofa/Back" is a Back below a Sofa, "/Sofa" is a Sofa without a
/// parent, and "Leg/#2" is the second of several objects of one path. In a list, "not NAME" takes
/// away what a name before it gave.
class ObjectNames
{
public:
    /// @param objects  the objects in the scene's order, which is also the order of the sets
    explicit ObjectNames(const std::vector<ExplainedObject>& objects);
    ObjectNames(const ObjectNames&) = delete;
    ObjectNames& operator=(const ObjectNames&) = delete;
    ~ObjectNames();

    /// Returns the renderers that one item of a list is about, or none for an unknown name.
    std::vector<std::size_t> Find(std::string_view item) const;
    /// Returns the renderers that a list stands for.
    RendererSet Evaluate(const std::vector<std::string>& items) const;
    /// Returns the words about an unknown name: "'Lampp'; did you mean 'Lamp'?"
    std::string UnknownSentence(std::string_view item) const;

    /// Returns the list, changed as little as is simple, so that it stands for `wanted`.
    std::vector<std::string> Fix(std::vector<std::string> items, const RendererSet& wanted) const;

    /// Returns names for a message. A name that stands for only a part of an object has the number
    /// of renderers behind it: "Sofa (12 of 13 renderers)".
    /// @param others  renderers that are never part of what a name stands for
    std::vector<std::string> Describe(const RendererSet& members, const RendererSet& others) const;

private:
    struct Node;
    class Fixer;

    bool IsTakenAway(std::string_view item) const; ///< if it is "not NAME"
    std::vector<std::size_t> FindName(std::string_view name) const;
    std::string Spell(const Node& node) const;
    void Describe(const Node& node, const RendererSet& members, const RendererSet& others,
                  std::vector<std::string>& names) const;

    std::unique_ptr<Node> m_Root;
    std::vector<std::string> m_Paths; ///< the path of each renderer: "/Room/Sofa/Back/"
    /// The renderers whose path has a name, by that name, in their order.
    std::map<std::string, std::vector<std::size_t>, std::less<>> m_PlacesOf;
    bool m_HasSlashes = false; ///< true if the name of an object has a slash
};

} // namespace limn
