#pragma once

#include "CachedCompiler.h"

#include <limn/core/Camera.h>
#include <limn/core/Culling.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/core/RenderTexture.h>
#include <limn/core/Scene.h>
#include <limn/shaderlab/ShaderCompiler.h>
#include <memory>
#include <string>
#include <vector>

namespace limn::test
{

/// One compiler for all tests of the program; it keeps what it compiles as long as they run.
inline std::shared_ptr<ShaderCompiler> Compiler()
{
    static const auto compiler = std::make_shared<ShaderCompiler>(CachedCompiler());
    return compiler;
}

inline std::shared_ptr<const Shader> ShaderOf(const std::string& text)
{
    return Shader::FromText(text, "test.shader", Compiler());
}

/// A shader with one pass for each LightMode, none of which can be compiled: for filtering.
inline std::shared_ptr<const Shader> ShaderWithModes(const std::vector<std::string>& lightModes,
                                                     const std::string& queue = "Geometry")
{
    std::string passes;
    for (const std::string& mode : lightModes)
    {
        passes += "Pass { Tags { \"LightMode\" = \"" + mode + "\" } Lighting On }\n";
    }
    return ShaderOf("Shader \"Test/Modes\" { SubShader { Tags { \"Queue\" = \"" + queue + "\" }\n" +
                    passes + "} }");
}

/// A pass's program that needs no library.
/// @param declarations  HLSL before the functions
/// @param result        the fragment function's float4
inline std::string Program(const std::string& declarations = "",
                           const std::string& result = "float4(1, 1, 1, 1)")
{
    return "HLSLPROGRAM\n#pragma vertex Vert\n#pragma fragment Frag\n" + declarations +
           "\nfloat4 Vert(float4 position : POSITION) : SV_POSITION { return position; }\n"
           "float4 Frag() : SV_Target { return " +
           result + "; }\nENDHLSL\n";
}

/// A shader with a single pass of LightMode UniversalForward.
/// @param state  ShaderLab commands of the pass
inline std::shared_ptr<const Shader> ShaderWithProgram(const std::string& properties,
                                                       const std::string& declarations = "",
                                                       const std::string& result = "1",
                                                       const std::string& state = "")
{
    return ShaderOf("Shader \"Test/Program\" { Properties { " + properties +
                    " } SubShader { Pass { Tags { \"LightMode\" = \"UniversalForward\" }\n" +
                    state + "\n" + Program(declarations, result) + "} } }");
}

inline std::shared_ptr<const Mesh> Cube()
{
    static const std::shared_ptr<const Mesh> cube = CreatePrimitive(PrimitiveType::Cube);
    return cube;
}

/// A cube of side 1 at `position` with these materials.
inline GameObject& AddCube(Scene& scene, const std::string& name, const glm::vec3& position,
                           std::vector<std::shared_ptr<const Material>> materials)
{
    GameObject& object = scene.Add(name);
    object.transform.localPosition = position;
    object.renderer = MeshRenderer{Cube(), std::move(materials)};
    return object;
}

/// A target of its own contents; `transient` ones need not be kept behind the frame.
inline std::shared_ptr<const RenderTexture>
Target(const std::string& name, int width = 8, int height = 4, bool transient = false,
       GraphicsFormat format = GraphicsFormat::R8G8B8A8_UNorm)
{
    return std::make_shared<const RenderTexture>(
        name, RenderTextureDescriptor(width, height, format), SamplerState{}, transient);
}

inline std::shared_ptr<const RenderTexture> DepthTarget(const std::string& name, int width = 8,
                                                        int height = 4, bool transient = false)
{
    return std::make_shared<const RenderTexture>(
        name, RenderTextureDescriptor(width, height, GraphicsFormat::None, 32), SamplerState{},
        transient);
}

} // namespace limn::test
