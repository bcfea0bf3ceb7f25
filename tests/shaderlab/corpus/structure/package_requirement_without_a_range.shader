Shader "T"
{
    SubShader
    {
        PackageRequirements { "com.unity.a" : }
    }
}
