#pragma once

#include "TemporaryFolder.h"

#include <limn/shaderlab/ShaderCompiler.h>

namespace limn::test
{

/// Keeps what it compiles for all tests of the program, which draw with the same few shaders.
inline ShaderCompilerOptions CachedCompiler()
{
    static const TemporaryFolder cache;
    ShaderCompilerOptions options;
    options.cacheFolder = cache.path();
    return options;
}

} // namespace limn::test
