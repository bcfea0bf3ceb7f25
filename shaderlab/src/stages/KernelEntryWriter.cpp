#include "stages/KernelEntryWriter.h"

#include "stages/EntryPointWriter.h"
#include <limn/base/Text.h>

#include <algorithm>

namespace limn
{

std::string_view ThreadsOf(const HlslFunction& kernel)
{
    const auto isThreads = [](std::string_view attribute)
    {
        return Trim(attribute.substr(1)).starts_with("numthreads");
    };
    const auto found = std::ranges::find_if(kernel.attributes, isThreads);
    return found == kernel.attributes.end() ? std::string_view() : *found;
}

std::string WriteKernelEntry(const HlslFunction& kernel, const std::string& prologue)
{
    std::string parameters;
    std::string arguments;
    for (std::size_t i = 0; i < kernel.parameters.size(); ++i)
    {
        const HlslVariable& parameter = kernel.parameters[i];
        const std::string comma = i == 0 ? "" : ", ";
        parameters += comma + std::string(parameter.type) + " " + ArgumentName(i);
        if (!parameter.semantic.empty()) // else it is a struct whose members have some
        {
            parameters += " : " + std::string(parameter.semantic);
        }
        arguments += comma + ArgumentName(i);
    }
    return "\n#line 1 \"" + std::string(k_EntryFile) + "\"\n" + std::string(ThreadsOf(kernel)) +
           "\nvoid " + std::string(k_EntryName) + "(" + parameters + ")\n{\n" + prologue +
           AuthorFunctionName(kernel.name) + "(" + arguments + ");\n}\n";
}

} // namespace limn
