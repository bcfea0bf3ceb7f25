// It lends its pass where UsePass or Fallback names an opaque shader of Unity's built-in pipeline. URP
// draws nothing else of those: the pass casts the shadow of the mesh.
Shader "Hidden/Limn/VertexLit"
{
    SubShader
    {
        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }

            CGPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile_shadowcaster
            #pragma multi_compile_instancing

            #include "UnityCG.cginc"

            struct Varyings
            {
                V2F_SHADOW_CASTER;
            };

            Varyings Vertex(appdata_base v)
            {
                Varyings output;
                UNITY_SETUP_INSTANCE_ID(v);
                TRANSFER_SHADOW_CASTER_NORMALOFFSET(output)
                return output;
            }

            float4 Fragment(Varyings input) : SV_Target
            {
                SHADOW_CASTER_FRAGMENT(input)
            }
            ENDCG
        }
    }
}
