#include <limn/core/ComputeShader.h>

#include "material/CompileVariant.h"
#include "material/PropertyValues.h"
#include "support/UniqueId.h"

#include <algorithm>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/Material.h>
#include <limn/shaderlab/InitialKeywords.h>

namespace limn
{

ComputeShader::ComputeShader(ComputeDocument document, std::shared_ptr<ShaderCompiler> compiler)
    : m_Id(NextUniqueId()), m_Document(std::move(document)), m_Compiler(std::move(compiler))
{
    if (!m_Compiler)
    {
        throw ContractError("compute shader '" + name() + "' needs a compiler, but it is null");
    }
    for (PassProgram& kernel : m_Document.kernels)
    {
        kernel = m_Compiler->ReadPragmas(kernel);
    }
    m_KernelValues.resize(m_Document.kernels.size());
    m_Last.resize(m_Document.kernels.size());
}

std::shared_ptr<ComputeShader> ComputeShader::Load(const std::filesystem::path& path,
                                                   std::shared_ptr<ShaderCompiler> compiler)
{
    return std::make_shared<ComputeShader>(LoadCompute(path), std::move(compiler));
}

std::shared_ptr<ComputeShader> ComputeShader::FromText(std::string_view text, std::string file,
                                                       std::shared_ptr<ShaderCompiler> compiler)
{
    return std::make_shared<ComputeShader>(ParseCompute(text, std::move(file)),
                                           std::move(compiler));
}

int ComputeShader::FindKernel(std::string_view name) const
{
    std::vector<std::string_view> known;
    for (std::size_t i = 0; i < m_Document.kernels.size(); ++i)
    {
        known.push_back(m_Document.kernels[i].kernel.name);
        if (known.back() == name)
        {
            return static_cast<int>(i);
        }
    }
    throw ContractError("compute shader '" + this->name() + "' has no kernel " +
                        UnknownName(name, known));
}

bool ComputeShader::HasKernel(std::string_view name) const
{
    return std::ranges::any_of(m_Document.kernels, [&](const PassProgram& kernel)
                               { return kernel.kernel.name == name; });
}

const PassProgram& ComputeShader::KernelAt(int kernelIndex) const
{
    if (kernelIndex < 0 || kernelIndex >= kernelCount())
    {
        throw ContractError("compute shader '" + name() + "' has no kernel " +
                            std::to_string(kernelIndex) + "; it has " +
                            std::to_string(kernelCount()));
    }
    return m_Document.kernels[static_cast<std::size_t>(kernelIndex)];
}

void ComputeShader::GetKernelThreadGroupSizes(int kernelIndex, std::uint32_t& x, std::uint32_t& y,
                                              std::uint32_t& z) const
{
    const auto& size = Compile(kernelIndex)->threadGroupSize;
    x = size[0];
    y = size[1];
    z = size[2];
}

bool ComputeShader::IsSupported(int kernelIndex) const
{
    KernelAt(kernelIndex);
    return std::ranges::count(m_Compiler->options().missingFeatures, "compute") == 0;
}

void ComputeShader::SetConstantBuffer(ShaderPropertyId id,
                                      std::shared_ptr<const GraphicsBuffer> buffer, int offset,
                                      int size)
{
    Set(k_AllKernels, id, ConstantRange(std::move(buffer), offset, size));
}

void ComputeShader::SetTexture(int kernelIndex, ShaderPropertyId id, const RTHandle& texture)
{
    Set(kernelIndex, id, TextureOf(texture, id, "compute shader '" + name() + "': "));
}

void ComputeShader::Set(int kernelIndex, ShaderPropertyId id, ShaderPropertyValue value)
{
    RequireFinite(value, id, "compute shader '" + name() + "': ");
    if (kernelIndex == k_AllKernels)
    {
        m_Values.Set(id, std::move(value));
        return;
    }
    KernelAt(kernelIndex);
    m_KernelValues[static_cast<std::size_t>(kernelIndex)].Set(id, std::move(value));
}

void ComputeShader::SetFromMaterial(int kernelIndex, const Material& material)
{
    KernelAt(kernelIndex);
    for (const ShaderProperty& property : material.shader()->document().properties)
    {
        const ShaderPropertyId id(property.name);
        if (property.type == ShaderPropertyType::Texture && material.Find(id) == nullptr)
        {
            SetTexture(kernelIndex, id,
                       DefaultTexture(property.defaultTexture, property.dimension));
        }
    }
    material.values().ForEach(
        [&](ShaderPropertyId id, const ShaderPropertyValue& value)
        {
            const bool isOfKernel = std::holds_alternative<BufferRange>(value) ||
                                    std::holds_alternative<std::shared_ptr<const Texture>>(value);
            Set(isOfKernel ? kernelIndex : k_AllKernels, id, value);
        });
}

const ShaderPropertyValue* ComputeShader::Find(int kernelIndex, ShaderPropertyId id) const
{
    const ShaderPropertyValue* own = kernelValues(kernelIndex).Find(id);
    return own != nullptr ? own : m_Values.Find(id);
}

const MaterialPropertyBlock& ComputeShader::kernelValues(int kernelIndex) const
{
    KernelAt(kernelIndex);
    return m_KernelValues[static_cast<std::size_t>(kernelIndex)];
}

void ComputeShader::SetKeyword(std::string_view keyword, bool value)
{
    const auto place = std::ranges::lower_bound(m_Keywords, keyword);
    const bool isOn = place != m_Keywords.end() && *place == keyword;
    if (value && !isOn)
    {
        m_Keywords.emplace(place, keyword);
    }
    else if (!value && isOn)
    {
        m_Keywords.erase(place);
    }
}

bool ComputeShader::IsKeywordEnabled(std::string_view keyword) const
{
    return std::ranges::binary_search(m_Keywords, keyword);
}

std::shared_ptr<const ShaderProgram>
ComputeShader::Compile(int kernelIndex, std::span<const std::string> globalKeywords) const
{
    const PassProgram& kernel = KernelAt(kernelIndex);
    LastVariant& last = m_Last[static_cast<std::size_t>(kernelIndex)];
    if (last.compiled && last.keywords == m_Keywords &&
        std::ranges::equal(last.globalKeywords, globalKeywords))
    {
        return last.compiled;
    }
    const Variant variant = SelectVariant(kernel, m_Keywords, globalKeywords);
    std::shared_ptr<const ShaderProgram>& compiled = m_Compiled[{kernelIndex, variant}];
    if (!compiled)
    {
        compiled = CompileVariant(*m_Compiler, kernel, variant);
    }
    last = {m_Keywords, {globalKeywords.begin(), globalKeywords.end()}, compiled};
    return compiled;
}

} // namespace limn
