Shader "T"
{
    Category
    {
        SubShader { }
        Fallback "F"
        CustomEditor "E"
        Dependency "A" = "B"
    }
}
