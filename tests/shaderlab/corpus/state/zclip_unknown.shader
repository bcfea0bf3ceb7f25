Shader "T"
{
    SubShader
    {
        Pass
        {
            ZClip Less
        }
    }
}
