#pragma once

#include <filesystem>
#include <limn/core/GraphicsBuffer.h>
#include <limn/core/MaterialPropertyBlock.h>
#include <limn/shaderlab/ComputeDocument.h>
#include <limn/shaderlab/ShaderCompiler.h>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

class Material;

/// A .compute file with values for its parameters. Kernels are compiled when they are first
/// dispatched. A parameter without a value takes the global value of its name; if there is none, a
/// number is 0, and a texture or buffer is an error. A ComputeShader must not be used by several
/// threads at once. Unity: UnityEngine.ComputeShader (2022.3).
class ComputeShader
{
public:
    /// @throws ContractError if the compiler is null
    ComputeShader(ComputeDocument document, std::shared_ptr<ShaderCompiler> compiler);
    /// @throws AssetError as LoadCompute
    static std::shared_ptr<ComputeShader> Load(const std::filesystem::path& path,
                                               std::shared_ptr<ShaderCompiler> compiler);
    /// @param file  the name of the text in error messages
    static std::shared_ptr<ComputeShader> FromText(std::string_view text, std::string file,
                                                   std::shared_ptr<ShaderCompiler> compiler);

    std::uint64_t id() const { return m_Id; } ///< unique in the process
    const std::string& name() const { return m_Document.name; }
    const ComputeDocument& document() const { return m_Document; }

    /// Returns the kernel's index. @throws ContractError if no kernel has this name
    int FindKernel(std::string_view name) const;
    bool HasKernel(std::string_view name) const;
    int kernelCount() const { return static_cast<int>(m_Document.kernels.size()); }
    /// @throws ContractError if there is no such kernel, as all functions below do that take one
    const std::string& kernelName(int kernelIndex) const
    {
        return KernelAt(kernelIndex).kernel.name;
    }
    /// Returns the threads of a group in the variant that the shader's own keywords choose, and
    /// compiles it.
    /// @throws AssetError if it does not compile
    void GetKernelThreadGroupSizes(int kernelIndex, std::uint32_t& x, std::uint32_t& y,
                                   std::uint32_t& z) const;
    /// Returns whether the device that the compiler compiles for runs kernels. Dispatching a kernel
    /// that it does not run throws UnsupportedProgramError.
    bool IsSupported(int kernelIndex) const;

    // These set values of all kernels. @throws ContractError naming shader and property if a value
    // is not finite or is an array without elements.
    void SetFloat(ShaderPropertyId id, float value) { Set(k_AllKernels, id, value); }
    void SetInt(ShaderPropertyId id, int value) { Set(k_AllKernels, id, value); }
    void SetBool(ShaderPropertyId id, bool value) { Set(k_AllKernels, id, value ? 1 : 0); }
    void SetVector(ShaderPropertyId id, const glm::vec4& value) { Set(k_AllKernels, id, value); }
    void SetVector(ShaderPropertyId id, const detail::MadeVector4 auto& value)
    {
        SetVector(id, detail::ToVector4(value));
    }
    void SetMatrix(ShaderPropertyId id, const glm::mat4& value) { Set(k_AllKernels, id, value); }
    void SetVectorArray(ShaderPropertyId id, std::vector<glm::vec4> values)
    {
        Set(k_AllKernels, id, std::move(values));
    }
    void SetMatrixArray(ShaderPropertyId id, std::vector<glm::mat4> values)
    {
        Set(k_AllKernels, id, std::move(values));
    }
    /// Sets consecutive components in the memory of the constant buffer, where each element of an
    /// array begins at a multiple of 16 bytes: a float2 takes two values; a float[3] takes nine, of
    /// which only the first of each four is used.
    void SetFloats(ShaderPropertyId id, std::vector<float> values)
    {
        Set(k_AllKernels, id, ConsecutiveParams{std::move(values)});
    }
    void SetInts(ShaderPropertyId id, std::vector<int> values)
    {
        Set(k_AllKernels, id, ConsecutiveParams{std::move(values)});
    }
    /// Makes the cbuffer of this name read from the buffer.
    /// @param offset, size  in bytes; the offset must be a multiple of 256; a size of 0 goes to the
    ///     end
    void SetConstantBuffer(ShaderPropertyId id, std::shared_ptr<const GraphicsBuffer> buffer,
                           int offset, int size);

    /// @param texture  null = the global texture of the name
    void SetTexture(int kernelIndex, ShaderPropertyId id, std::shared_ptr<const Texture> texture)
    {
        Set(kernelIndex, id, std::move(texture));
    }
    /// @throws ContractError also for a handle that wraps an identifier
    void SetTexture(int kernelIndex, ShaderPropertyId id, const RTHandle& texture);
    void SetBuffer(int kernelIndex, ShaderPropertyId id,
                   std::shared_ptr<const GraphicsBuffer> buffer)
    {
        Set(kernelIndex, id, BufferRange{std::move(buffer), 0, 0});
    }
    /// Sets all values of a material, including its textures' defaults: numbers for all kernels,
    /// textures and buffers for this one. Keywords stay as they are.
    void SetFromMaterial(int kernelIndex, const Material& material);
    /// Fails to compile, with a hint: Unity runs the kernel at once, while limn's frames run what
    /// command buffers hold.
    template <typename Kernel>
    void Dispatch(Kernel, int, int, int)
    {
        static_assert(sizeof(Kernel) == 0,
                      "ComputeShader::Dispatch: record it with CommandBuffer::DispatchCompute");
    }

    // Keywords choose the variants. A keyword that no kernel has is kept and has no effect.
    void EnableKeyword(std::string_view keyword) { SetKeyword(keyword, true); }
    void DisableKeyword(std::string_view keyword) { SetKeyword(keyword, false); }
    void SetKeyword(std::string_view keyword, bool value);
    bool IsKeywordEnabled(std::string_view keyword) const;
    const std::vector<std::string>& shaderKeywords() const { return m_Keywords; } ///< sorted

    /// Returns the kernel's program in the variant that the keywords choose; it is compiled on the
    /// first call.
    /// @param globalKeywords  the keywords that are on for all shaders, sorted
    /// @throws AssetError with the HLSL errors at their lines
    std::shared_ptr<const ShaderProgram>
    Compile(int kernelIndex, std::span<const std::string> globalKeywords = {}) const;

    static constexpr int k_AllKernels = -1;
    /// @param kernelIndex  k_AllKernels = all kernels that have no value of their own
    void Set(int kernelIndex, ShaderPropertyId id, ShaderPropertyValue value);
    /// Returns the kernel's own value, or else that of all kernels; null if none was set. The
    /// pointer is valid until the next change.
    const ShaderPropertyValue* Find(int kernelIndex, ShaderPropertyId id) const;
    const MaterialPropertyBlock& values() const { return m_Values; }  ///< values of all kernels
    const MaterialPropertyBlock& kernelValues(int kernelIndex) const; ///< values of one kernel

private:
    using Variant = std::vector<std::string>;
    /// The keywords for which a kernel was last compiled, and the result.
    struct LastVariant
    {
        std::vector<std::string> keywords;
        std::vector<std::string> globalKeywords;
        std::shared_ptr<const ShaderProgram> compiled;
    };
    const PassProgram& KernelAt(int kernelIndex) const;

    std::uint64_t m_Id;
    ComputeDocument m_Document;
    std::shared_ptr<ShaderCompiler> m_Compiler;
    MaterialPropertyBlock m_Values;
    std::vector<MaterialPropertyBlock> m_KernelValues; ///< by kernel
    std::vector<std::string> m_Keywords;
    mutable std::map<std::pair<int, Variant>, std::shared_ptr<const ShaderProgram>> m_Compiled;
    mutable std::vector<LastVariant> m_Last; ///< by kernel
};

} // namespace limn
