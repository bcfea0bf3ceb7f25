Shader "T"
{
    SubShader
    {
        Pass
        {
            PackageRequirements { "com.unity.a" }
            Name "X"
        }
    }
}
