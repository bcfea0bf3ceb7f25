Shader "T"
{
    SubShader
    {
        Pass
        {
            /* Cull Off } */ ZWrite /* Cull */ Off
            /* over
               lines } */
        }
    }
}
