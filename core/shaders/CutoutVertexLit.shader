// It lends its pass where UsePass or Fallback names a cutout shader of Unity's built-in pipeline. URP
// draws nothing else of those: the pass casts the shadow of the parts that are not cut out.
Shader "Hidden/Limn/CutoutVertexLit"
{
    SubShader
    {
        Pass
        {
            Name "Caster"
            Tags { "LightMode" = "ShadowCaster" }

            CGPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile_shadowcaster
            #pragma multi_compile_instancing

            #include "UnityCG.cginc"

            sampler2D _MainTex;
            float4 _MainTex_ST;
            fixed4 _Color;
            fixed _Cutoff;

            struct Varyings
            {
                V2F_SHADOW_CASTER;
                float2 uv : TEXCOORD1;
            };

            Varyings Vertex(appdata_base v)
            {
                Varyings output;
                UNITY_SETUP_INSTANCE_ID(v);
                TRANSFER_SHADOW_CASTER_NORMALOFFSET(output)
                output.uv = TRANSFORM_TEX(v.texcoord, _MainTex);
                return output;
            }

            float4 Fragment(Varyings input) : SV_Target
            {
                clip(tex2D(_MainTex, input.uv).a * _Color.a - _Cutoff);
                SHADOW_CASTER_FRAGMENT(input)
            }
            ENDCG
        }
    }
}
