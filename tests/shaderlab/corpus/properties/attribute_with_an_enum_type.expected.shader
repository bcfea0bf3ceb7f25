Shader "T"
{
    Properties
    {
        [Enum(UnityEngine.Rendering.BlendMode)] _A("a", Float) = 1
    }
}
