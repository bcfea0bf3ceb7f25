Shader "T"
{
    Category
    {
        Cull Off
        ZWrite Off
        Category
        {
            ZWrite On
            ZTest Always
            SubShader { Pass { } }
        }
        SubShader { Pass { } }
    }
}
