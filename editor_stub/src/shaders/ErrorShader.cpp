#include "shaders/ErrorShader.h"

namespace limn
{

namespace
{

constexpr std::string_view k_Text = R"(Shader "Hidden/Core/FallbackError"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            #pragma vertex Place
            #pragma fragment Magenta
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

            float4 Place(float4 positionOS : POSITION) : SV_POSITION
            {
                return TransformObjectToHClip(positionOS.xyz);
            }

            half4 Magenta() : SV_Target
            {
                return half4(1, 0, 1, 1);
            }
            ENDHLSL
        }
    }
}
)";

} // namespace

std::shared_ptr<const Shader> MakeErrorShader(const std::shared_ptr<ShaderCompiler>& compiler)
{
    return Shader::FromText(k_Text, "FallbackError.shader", compiler);
}

} // namespace limn
