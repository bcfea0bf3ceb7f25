Shader "T"
{
    Category
    {
        LOD 150
        SubShader { }
        SubShader { LOD 100 }
    }
}
