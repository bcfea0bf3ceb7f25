#include <limn/features/Plugin.h>
#include <string_view>

namespace limn
{

std::string PluginProblem(const Plugin& plugin)
{
    const std::string_view version = plugin.version;
    if (version != LIMN_VERSION_TEXT)
    {
        return "it was built for limn " + std::string(version) +
               ", this is limn " LIMN_VERSION_TEXT "; build it again with this one";
    }
    const std::string_view library = plugin.standardLibrary;
    if (library != LIMN_STANDARD_LIBRARY)
    {
        return "it was built with " + std::string(library) +
               ", limn with " LIMN_STANDARD_LIBRARY "; build it as limn was built";
    }
    return plugin.layout == PluginLayout()
               ? ""
               : "it was built with other headers of limn, or another compiler, so that objects of "
                 "the two differ in size; build it again with this limn";
}

} // namespace limn
