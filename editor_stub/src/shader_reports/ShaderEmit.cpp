#include "shader_reports/ShaderEmit.h"

#include "console/CacheFolder.h"
#include <limn/base/Case.h>
#include <limn/base/WriteFile.h>

#include <cctype>
#include <spirv_hlsl.hpp>
#include <spirv_msl.hpp>

namespace limn
{

namespace
{

/// Returns options with which the text has plain `min` and `max`, as a person would write them:
/// what they give for NaN is left to the language that is emitted.
spirv_cross::CompilerGLSL::Options PlainOptions()
{
    spirv_cross::CompilerGLSL::Options options;
    options.relax_nan_checks = true;
    return options;
}

std::string ToGlsl(std::vector<std::uint32_t> spirv)
{
    spirv_cross::CompilerGLSL compiler(std::move(spirv));
    spirv_cross::CompilerGLSL::Options options = PlainOptions();
    options.version = 450;
    options.vulkan_semantics = true;
    compiler.set_common_options(options);
    return compiler.compile();
}

/// The least version that has what the code needs: 3.0, structured buffers 3.1, geometry 3.2.
std::uint32_t EsVersion(const spirv_cross::CompilerGLSL& compiler)
{
    const bool isGeometry = compiler.get_execution_model() == spv::ExecutionModelGeometry;
    return isGeometry ? 320 : compiler.get_shader_resources().storage_buffers.empty() ? 300 : 310;
}

std::string ToGlslEs(std::vector<std::uint32_t> spirv)
{
    spirv_cross::CompilerGLSL compiler(std::move(spirv));
    spirv_cross::CompilerGLSL::Options options = PlainOptions();
    options.es = true;
    options.version = EsVersion(compiler);
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
    compiler.set_common_options(PlainOptions());
    compiler.set_hlsl_options(options);
    return compiler.compile();
}

std::string ToMsl(std::vector<std::uint32_t> spirv)
{
    spirv_cross::CompilerMSL compiler(std::move(spirv));
    compiler.set_common_options(PlainOptions());
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

using EmittedFiles = std::vector<std::pair<std::filesystem::path, std::string>>;

/// One file a stage.
void Translate(const CheckedPass& checked, const ShaderCheck& check, const std::string& language,
               const std::filesystem::path& stem, EmittedFiles& files)
{
    const ShaderProgram& pass = *checked.compiled;
    const std::string refusal = "the pass cannot be written as " + language + ": ";
    if (!pass.geometrySpirv.empty() && (language == "msl" || language == "hlsl"))
    {
        throw AssetError(check.file.string(), checked.pass->location,
                         refusal + (language == "msl"
                                        ? "Metal has no geometry functions"
                                        : "SPIRV-Cross writes no geometry functions in HLSL"));
    }
    for (const auto& [stage, spirv] :
         {std::pair("vert", &pass.vertexSpirv), std::pair("geom", &pass.geometrySpirv),
          std::pair("frag", &pass.fragmentSpirv)})
    {
        if (spirv->empty())
        {
            continue;
        }
        try
        {
            files.emplace_back(stem.string() + "." + stage + "." +
                                   (language == "spirv" ? "spv" : language),
                               Translate(*spirv, language));
        }
        catch (const spirv_cross::CompilerError& error)
        {
            throw AssetError(check.file.string(), checked.pass->location, refusal + error.what());
        }
    }
}

} // namespace

std::string EmittedStems::Take(const std::string& shaderName)
{
    const std::string stem = FileStem(shaderName);
    std::string free = stem;
    for (int i = 2; !m_Taken.insert(ToLower(free)).second; ++i)
    {
        free = stem + "-" + std::to_string(i);
    }
    return free;
}

std::vector<std::filesystem::path> EmitShader(const ShaderCheck& check, const std::string& language,
                                              const std::filesystem::path& folder,
                                              const std::string& stem)
{
    // Everything is translated before the first file is written: all of them or none.
    EmittedFiles files;
    for (const CheckedSubShader& subShader : check.subShaders)
    {
        for (std::size_t i = 0; subShader.isUsed && i < subShader.passes.size(); ++i)
        {
            if (subShader.passes[i].compiled)
            {
                Translate(subShader.passes[i], check, language,
                          folder / (stem + "." + std::to_string(i)), files);
            }
        }
    }
    const std::string problem = MakeFolder(folder);
    if (!problem.empty())
    {
        throw AssetError(folder.string(), {}, "the folder cannot be made: " + problem);
    }
    std::vector<std::filesystem::path> paths;
    for (const auto& [path, content] : files)
    {
        WriteFile(path, content);
        paths.push_back(path);
    }
    return paths;
}

} // namespace limn
