#include <limn/features/Plugin.h>
#include <sstream>
#include <string_view>

namespace limn
{

namespace
{

std::string ToHex(std::uint64_t number)
{
    std::ostringstream text;
    text << std::hex << number;
    return text.str();
}

} // namespace

std::string PluginProblem(const Plugin& plugin)
{
    const std::string_view version = plugin.version;
    if (version != LIMN_VERSION_TEXT)
    {
        return "it was built for limn " + std::string(version) +
               ", but this is limn " LIMN_VERSION_TEXT "; build it again with this one";
    }
    const std::string_view library = plugin.standardLibrary;
    if (library != LIMN_STANDARD_LIBRARY)
    {
        return "it was built with " + std::string(library) +
               ", but limn with " LIMN_STANDARD_LIBRARY "; build it as limn was built";
    }
    return plugin.layout == PluginLayout()
               ? ""
               : "it was built with other headers of limn " LIMN_VERSION_TEXT
                 ", or with another compiler (" +
                     ToHex(plugin.layout) + "; of this limn it is " + ToHex(PluginLayout()) +
                     "); build it again with this one";
}

} // namespace limn
