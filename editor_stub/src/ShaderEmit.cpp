#include "ShaderEmit.h"

#include "CacheFolder.h"
#include <limn/shaderlab/WriteFile.h>

#include <cctype>
#include <spirv_hlsl.hpp>
#include <spirv_msl.hpp>

namespace limn
{

namespace
{

std::string ToGlsl(std::vector<std::uint32_t> spirv)
{
    spirv_cross::CompilerGLSL compiler(std::move(spirv));
    spirv_cross::CompilerGLSL::Options options;
    options.version = 450;
    options.vulkan_semantics = true;
    compiler.set_common_options(options);
    return compiler.compile();
}

/// OpenGL ES 3.0, or 3.1 where a structured buffer needs it.
std::string ToGlslEs(std::vector<std::uint32_t> spirv)
{
    spirv_cross::CompilerGLSL compiler(std::move(spirv));
    spirv_cross::CompilerGLSL::Options options;
    options.es = true;
    options.version = compiler.get_shader_resources().storage_buffers.empty() ? 300 : 310;
    options.emit_push_constant_as_uniform_buffer = true;
    compiler.set_common_options(options);
    compiler.build_combined_image_samplers();
    for (const auto& combined : compiler.get_combined_image_samplers())
    {
        compiler.set_name(combined.combined_id, compiler.get_name(combined.image_id));
    }
    return compiler.compile();
}

std::string ToHlsl(std::vector<std::uint32_t> spirv)
{
    spirv_cross::CompilerHLSL compiler(std::move(spirv));
    spirv_cross::CompilerHLSL::Options options;
    options.shader_model = 50;
    compiler.set_hlsl_options(options);
    return compiler.compile();
}

std::string ToMsl(std::vector<std::uint32_t> spirv)
{
    spirv_cross::CompilerMSL compiler(std::move(spirv));
    spirv_cross::CompilerMSL::Options options;
    options.set_msl_version(2, 1);
    compiler.set_msl_options(options);
    return compiler.compile();
}

std::string Translate(const std::vector<std::uint32_t>& spirv, const std::string& language)
{
    if (language == "spirv")
    {
        return {reinterpret_cast<const char*>(spirv.data()), spirv.size() * sizeof(spirv[0])};
    }
    return language == "glsl"     ? ToGlsl(spirv)
           : language == "glsles" ? ToGlslEs(spirv)
           : language == "msl"    ? ToMsl(spirv)
                                  : ToHlsl(spirv);
}

/// A shader's name without what file names cannot have.
std::string FileStem(const std::string& name)
{
    std::string stem;
    for (const char c : name)
    {
        stem += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' ? c : '_';
    }
    return stem;
}

} // namespace

std::vector<std::filesystem::path> EmitShader(const ShaderCheck& check, const std::string& language,
                                              const std::filesystem::path& folder)
{
    const std::string problem = MakeFolder(folder);
    if (!problem.empty())
    {
        throw AssetError(folder.string(), {}, "the folder cannot be made: " + problem);
    }
    const std::string extension = language == "spirv" ? "spv" : language;
    std::vector<std::filesystem::path> files;
    for (const CheckedSubShader& subShader : check.subShaders)
    {
        if (!subShader.isUsed)
        {
            continue;
        }
        for (std::size_t i = 0; i < subShader.passes.size(); ++i)
        {
            const CompiledPass* pass = subShader.passes[i].compiled.get();
            if (!pass)
            {
                continue;
            }
            const std::string stem = FileStem(check.document->name) + "." + std::to_string(i);
            for (const auto& [stage, spirv] :
                 {std::pair("vert", &pass->vertexSpirv), std::pair("frag", &pass->fragmentSpirv)})
            {
                files.push_back(folder / (stem + "." + stage + "." + extension));
                try
                {
                    WriteFile(files.back(), Translate(*spirv, language));
                }
                catch (const spirv_cross::CompilerError& error)
                {
                    throw AssetError(check.file.string(), subShader.passes[i].pass->location,
                                     "the pass cannot be written as " + language + ": " +
                                         error.what());
                }
            }
        }
    }
    return files;
}

} // namespace limn
