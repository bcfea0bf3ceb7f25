Shader "T"
{
    SubShader
    {
        PackageRequirements { "com.unity.a" "com.unity.b" : "1.2" "unity" : "2021.3" }
        Pass
        {
        }
    }
}
