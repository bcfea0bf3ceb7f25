Shader "T"
{
    SubShader
    {
        PackageRequirements { "com.unity.a" : "[10.2.1,11.0)" "com.unity.b" : "unity=2021.2" }
    }
}
