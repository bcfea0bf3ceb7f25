#pragma once

#include "ShaderTestSupport.h"

#include <limn/shaderlab/InitialKeywords.h>
#include <limn/shaderlab/MissingIncludeError.h>
#include <limn/shaderlab/UnsupportedProgramError.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace limn::test
{

struct Count
{
    int good = 0;
    int all = 0;
};

inline std::ostream& operator<<(std::ostream& stream, const Count& count)
{
    return stream << count.good << " of " << count.all;
}

struct PassCounts
{
    Count tried;
    int refused = 0;        ///< with a reason
    int missingInclude = 0; ///< of a file that is not in the collection
};

inline void CompilePasses(ShaderCompiler& compiler, const ShaderLabDocument& document,
                          PassCounts& passes)
{
    const std::vector<std::string> initial = InitialKeywords(document);
    for (const ShaderLabSubShader& subShader : document.subShaders)
    {
        for (const ShaderLabPass& pass : subShader.passes)
        {
            if (!pass.program)
            {
                continue;
            }
            try
            {
                const PassProgram program = compiler.ReadPragmas(*pass.program);
                compiler.Compile(program, SelectVariant(program, initial));
                ++passes.tried.good;
                ++passes.tried.all;
            }
            catch (const UnsupportedProgramError&)
            {
                ++passes.refused;
            }
            catch (const MissingIncludeError&)
            {
                ++passes.missingInclude;
            }
            catch (const AssetError& error)
            {
                ++passes.tried.all;
                std::cout << error.what() << "\n";
            }
        }
    }
}

/// The folder that an environment variable names; "" where it is not set.
inline std::string FolderOf(const char* variable)
{
    const char* value = std::getenv(variable);
    return value ? value : "";
}

} // namespace limn::test
