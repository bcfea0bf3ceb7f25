#include <limn/features/OutlineRendererFeature.h>

namespace limn
{

std::shared_ptr<const Shader> FindTechniqueShader(const ScriptableRenderer& renderer,
                                                  std::string_view name)
{
    const std::shared_ptr<ShaderCompiler> compiler = renderer.shaderCompiler();
    if (!compiler)
    {
        throw ContractError("the renderer has no shader compiler; UniversalRenderer has one");
    }
    return FindShippedShader(name, compiler);
}

} // namespace limn
