Shader "T"
{
    SubShader
    {
        Pass
        {
            ZTest [unity_GUIZTestMode]
        }
    }
}
