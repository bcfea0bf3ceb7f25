Shader "T"
{
    SubShader
    {
        Tags { "ShaderGraphTargetId" = "X" "SplatCount" = "4" }
    }
}
