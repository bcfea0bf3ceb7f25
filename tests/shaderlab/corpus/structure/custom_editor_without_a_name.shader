Shader "T"
{
    CustomEditor
    Fallback "F"
}
