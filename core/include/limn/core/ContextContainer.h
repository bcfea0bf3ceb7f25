#pragma once

#include <concepts>
#include <memory>
#include <typeindex>
#include <vector>

namespace limn
{

/// Data of a frame that passes hand to each other in a ContextContainer.
/// Unity: UnityEngine.Rendering.ContextItem (core 17).
class ContextItem
{
public:
    ContextItem() = default;
    virtual ~ContextItem() = default;
    ContextItem(const ContextItem&) = delete;
    ContextItem& operator=(const ContextItem&) = delete;

    /// Clears the data of the frame, so that the same object can serve the next one.
    virtual void Reset() = 0;
};

/// Holds one item of each type while a camera is rendered.
/// Unity: UnityEngine.Rendering.ContextContainer (core 17).
class ContextContainer
{
public:
    /// Returns the item of this type, in the state after its last Reset.
    /// @throws ContractError if there is one already
    template <std::derived_from<ContextItem> T>
    T& Create()
    {
        Entry* entry = Find(typeid(T));
        if (entry == nullptr)
        {
            entry = &m_Entries.emplace_back(Entry{typeid(T), std::make_unique<T>(), false});
        }
        Begin(*entry);
        return static_cast<T&>(*entry->item);
    }
    /// @throws ContractError if there is none
    template <std::derived_from<ContextItem> T>
    T& Get()
    {
        return static_cast<T&>(Existing(typeid(T)));
    }
    template <std::derived_from<ContextItem> T>
    T& GetOrCreate()
    {
        return Contains<T>() ? Get<T>() : Create<T>();
    }
    template <std::derived_from<ContextItem> T>
    bool Contains() const
    {
        return Contains(typeid(T));
    }

    /// Resets all items and leaves the container empty.
    void Dispose();

private:
    struct Entry
    {
        std::type_index type;
        std::unique_ptr<ContextItem> item; ///< never null
        bool isThere = false;
    };
    Entry* Find(std::type_index type);
    bool Contains(std::type_index type) const;
    ContextItem& Existing(std::type_index type);
    static void Begin(Entry& entry);

    std::vector<Entry> m_Entries;
};

} // namespace limn
