#include <deque>
#include <limn/core/ShaderId.h>
#include <mutex>
#include <unordered_map>

namespace limn::detail
{

namespace
{

struct NameTable
{
    std::mutex mutex;
    std::deque<std::string> names{""}; // a deque keeps its strings in place
    std::unordered_map<std::string_view, std::uint32_t> ids{{names.front(), 0u}};
};

NameTable& Table()
{
    static NameTable table;
    return table;
}

} // namespace

std::uint32_t InternName(std::string_view name)
{
    NameTable& table = Table();
    const std::lock_guard lock(table.mutex);
    const auto it = table.ids.find(name);
    if (it != table.ids.end())
    {
        return it->second;
    }
    const auto id = static_cast<std::uint32_t>(table.names.size());
    table.ids.emplace(table.names.emplace_back(name), id);
    return id;
}

const std::string& InternedName(std::uint32_t id)
{
    NameTable& table = Table();
    const std::lock_guard lock(table.mutex);
    return table.names.at(id);
}

} // namespace limn::detail
