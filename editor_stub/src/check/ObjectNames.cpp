#include "check/ObjectNames.h"

#include "console/Texts.h"

#include <algorithm>
#include <limn/base/Diagnostic.h>
#include <optional>
#include <set>
#include <span>
#include <unordered_map>

namespace limn
{

namespace
{

std::size_t CountIn(const RendererSet& set, const std::vector<std::size_t>& renderers)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(renderers, [&](std::size_t renderer) { return set[renderer]; }));
}

} // namespace

/// An object, or a place in the hierarchy that several objects of one path share.
struct ObjectNames::Node
{
    std::vector<std::string> path; ///< the names from the top down; empty: the scene
    std::vector<std::unique_ptr<Node>> children;
    std::unordered_map<std::string, Node*> childOf;
    std::vector<std::size_t> own; ///< its renderer; none of several, which have nodes below it
    std::vector<std::size_t> all; ///< and those below it
    int count = 0;                ///< of the renderers of its path
    int numbered = 0;             ///< of these, how many have nodes

    Node& Child(const std::string& name)
    {
        Node*& child = childOf[name];
        if (!child)
        {
            children.push_back(std::make_unique<Node>());
            child = children.back().get();
            child->path = path;
            child->path.push_back(name);
        }
        return *child;
    }

    std::string PathText() const
    {
        return "/" + Joined(path, "", [](const std::string& name) { return name + "/"; });
    }
};

/// Finds the items that a list lacks.
class ObjectNames::Fixer
{
public:
    /// The answer of the items so far about a part of the tree.
    enum class State
    {
        AsListed, ///< what the list says
        In,       ///< a name has just been added
        Out       ///< or taken away
    };
    using Items = std::vector<std::string>;

    Fixer(const ObjectNames& names, const RendererSet& listed, const RendererSet& wanted)
        : m_Names(names), m_Listed(listed), m_Wanted(wanted)
    {
    }

    /// Returns the fewest items, or nearly so, that make all below the node right.
    const Items& Fix(const Node& node, State state)
    {
        const auto key = std::pair(&node, state);
        const auto found = m_Known.find(key);
        return found != m_Known.end() ? found->second
                                      : m_Known.emplace(key, Compute(node, state)).first->second;
    }

private:
    bool IsRight(std::size_t renderer, State state) const
    {
        const bool isIn = state == State::AsListed ? m_Listed[renderer] : state == State::In;
        return isIn == m_Wanted[renderer];
    }
    bool AreRight(const std::vector<std::size_t>& renderers, State state) const
    {
        return std::ranges::all_of(renderers, [&](std::size_t r) { return IsRight(r, state); });
    }

    Items Compute(const Node& node, State state)
    {
        if (AreRight(node.all, state))
        {
            return {};
        }
        std::optional<Items> best;
        const auto offer = [&](Items items)
        {
            if (!best || items.size() < best->size())
            {
                best = std::move(items);
            }
        };
        const bool isAllWrong = std::ranges::none_of(node.all, [&](std::size_t renderer)
                                                     { return IsRight(renderer, state); });
        for (const State next : {State::In, State::Out})
        {
            const bool isUniform = AreRight(node.all, next);
            if (!node.path.empty() && isUniform && isAllWrong)
            {
                return {ItemOf(node, next)};
            }
        }
        if (AreRight(node.own, state))
        {
            offer(FixChildren(node, state));
        }
        for (const State next : {State::In, State::Out})
        {
            if (!node.path.empty() && next != state && AreRight(node.own, next))
            {
                Items items{ItemOf(node, next)};
                std::ranges::copy(FixChildren(node, next), std::back_inserter(items));
                offer(std::move(items));
            }
        }
        return std::move(*best);
    }

    Items FixChildren(const Node& node, State state)
    {
        Items items;
        for (const std::unique_ptr<Node>& child : node.children)
        {
            std::ranges::copy(Fix(*child, state), std::back_inserter(items));
        }
        return items;
    }

    std::string ItemOf(const Node& node, State state) const
    {
        return (state == State::Out ? "not " : "") + m_Names.Spell(node);
    }

    const ObjectNames& m_Names;
    const RendererSet& m_Listed;
    const RendererSet& m_Wanted;
    std::map<std::pair<const Node*, State>, Items> m_Known;
};

ObjectNames::ObjectNames(const std::vector<ExplainedObject>& objects)
    : m_Root(std::make_unique<Node>())
{
    std::vector<Node*> places;
    for (std::size_t i = 0; i < objects.size(); ++i)
    {
        Node* place = m_Root.get();
        place->all.push_back(i);
        std::vector<std::string> path(objects[i].parents.rbegin(), objects[i].parents.rend());
        path.push_back(objects[i].name);
        for (const std::string& name : path)
        {
            m_HasSlashes = m_HasSlashes || name.find('/') != std::string::npos;
            std::vector<std::size_t>& on = m_PlacesOf[name];
            if (on.empty() || on.back() != i)
            {
                on.push_back(i);
            }
            place = &place->Child(name);
            place->all.push_back(i);
        }
        ++place->count;
        places.push_back(place);
    }
    for (std::size_t i = 0; i < objects.size(); ++i)
    {
        Node* place = places[i];
        if (place->count > 1)
        {
            place = &place->Child("#" + std::to_string(++place->numbered));
            place->all.push_back(i);
        }
        place->own.push_back(i);
        m_Paths.push_back(place->PathText());
    }
}

ObjectNames::~ObjectNames() = default;

std::vector<std::size_t> ObjectNames::FindName(std::string_view name) const
{
    std::vector<std::size_t> found;
    const bool isFromTop = name.starts_with('/');
    const std::string words = (isFromTop ? "" : "/") + std::string(name) + "/";
    const auto check = [&](std::size_t renderer)
    {
        const std::string& path = m_Paths[renderer];
        if (isFromTop ? path.starts_with(words) : path.find(words) != std::string::npos)
        {
            found.push_back(renderer);
        }
    };
    std::string_view last = name.substr(0, std::min(name.size(), name.rfind("/#")));
    last.remove_prefix(last.rfind('/') + 1); // of -1 as well
    const auto places = m_PlacesOf.find(last);
    if (!m_HasSlashes && places != m_PlacesOf.end())
    {
        std::ranges::for_each(places->second, check);
        return found;
    }
    for (std::size_t i = 0; i < m_Paths.size() && !name.empty(); ++i)
    {
        check(i);
    }
    return found;
}

bool ObjectNames::IsTakenAway(std::string_view item) const
{
    return item.starts_with("not ") && FindName(item).empty();
}

std::vector<std::size_t> ObjectNames::Find(std::string_view item) const
{
    return FindName(IsTakenAway(item) ? item.substr(4) : item);
}

RendererSet ObjectNames::Evaluate(const std::vector<std::string>& items) const
{
    RendererSet result(m_Paths.size());
    for (const std::string& item : items)
    {
        const bool isIn = !IsTakenAway(item);
        for (const std::size_t renderer : Find(item))
        {
            result[renderer] = isIn;
        }
    }
    return result;
}

std::string ObjectNames::UnknownSentence(std::string_view item) const
{
    const std::string_view name = IsTakenAway(item) ? item.substr(4) : item;
    std::set<std::string> known;
    for (const auto& [each, places] : m_PlacesOf)
    {
        known.insert(each);
    }
    const auto slashes = static_cast<std::size_t>(std::ranges::count(name, '/'));
    for (const std::string& path : m_Paths) // all that have as many names as this one
    {
        const std::vector<std::string> names = SplitText(path.substr(1), '/'); // the last is ""
        for (std::size_t i = 0; slashes > 0 && i + slashes + 1 < names.size(); ++i)
        {
            known.insert(Joined(std::span(names).subspan(i, slashes + 1), "/"));
        }
    }
    if (NearestName(name, {known.begin(), known.end()}).empty())
    {
        known.clear(); // all would fill the screen
        for (const std::unique_ptr<Node>& child : m_Root->children)
        {
            known.insert(child->path.front());
        }
    }
    return UnknownName(name, {known.begin(), known.end()});
}

std::string ObjectNames::Spell(const Node& node) const
{
    std::string name;
    for (std::size_t i = node.path.size(); i-- > 0;)
    {
        name = node.path[i] + (name.empty() ? "" : "/") + name;
        const bool isNumber = i + 1 == node.path.size() && name.starts_with('#');
        if (!isNumber && FindName(name).size() == node.all.size()) // which it finds always
        {
            return name;
        }
    }
    return "/" + name;
}

std::vector<std::string> ObjectNames::Fix(std::vector<std::string> items,
                                          const RendererSet& wanted) const
{
    std::vector<std::string> kept;
    RendererSet listed(m_Paths.size());
    for (std::string& item : items)
    {
        const std::vector<std::size_t> named = Find(item);
        const bool isTakenAway = IsTakenAway(item);
        const std::size_t wantedCount = CountIn(wanted, named);
        if (isTakenAway ? CountIn(listed, named) > 0 && wantedCount == 0
                        : wantedCount > 0 && 2 * wantedCount >= named.size())
        {
            for (const std::size_t renderer : named)
            {
                listed[renderer] = !isTakenAway;
            }
            kept.push_back(std::move(item));
        }
    }
    std::ranges::copy(Fixer(*this, listed, wanted).Fix(*m_Root, Fixer::State::AsListed),
                      std::back_inserter(kept));
    return kept;
}

std::vector<std::string> ObjectNames::Describe(const RendererSet& members,
                                               const RendererSet& others) const
{
    std::vector<std::string> names;
    Describe(*m_Root, members, others, names);
    return names;
}

void ObjectNames::Describe(const Node& node, const RendererSet& members, const RendererSet& others,
                           std::vector<std::string>& names) const
{
    const std::size_t count = CountIn(members, node.all);
    const bool isPure = !node.path.empty() && CountIn(others, node.all) == 0;
    if (count > 0 && isPure && 2 * count > node.all.size())
    {
        names.push_back(Spell(node) + (count == node.all.size()
                                           ? ""
                                           : " (" + std::to_string(count) + " of " +
                                                 std::to_string(node.all.size()) + " renderers)"));
        return;
    }
    if (count > 0)
    {
        for (const std::size_t renderer : node.own)
        {
            if (members[renderer])
            {
                names.push_back(Spell(node) + " itself");
            }
        }
        for (const std::unique_ptr<Node>& child : node.children)
        {
            Describe(*child, members, others, names);
        }
    }
}

} // namespace limn
