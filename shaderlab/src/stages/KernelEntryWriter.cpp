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

bool HasValidThreads(std::string_view attribute, const IntegerNames& constants)
{
    constexpr std::int64_t k_Most[] = {1024, 1024, 64};
    constexpr std::int64_t k_MostInAll = 1024;
    const std::size_t open = attribute.find('(');
    const std::size_t close = attribute.rfind(')');
    if (open == attribute.npos || close == attribute.npos || close < open)
    {
        return false;
    }
    std::string_view rest = attribute.substr(open + 1, close - open - 1);
    std::int64_t inAll = 1;
    for (std::size_t i = 0; i < std::size(k_Most); ++i)
    {
        const bool isLast = i + 1 == std::size(k_Most);
        const std::size_t comma = isLast ? rest.size() : rest.find(',');
        const std::string_view text = rest.substr(0, comma);
        const bool isOne = comma != rest.npos && text.find(',') == text.npos;
        const std::int64_t threads = isOne ? EvaluateInteger(text, constants) : 0;
        if (threads < 1 || threads > k_Most[i])
        {
            return false;
        }
        inAll *= threads;
        rest.remove_prefix(isLast ? 0 : comma + 1);
    }
    return inAll <= k_MostInAll;
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
