Shader "T"
{
    CustomEditor "UnityEditor.Toon"
}
