Shader "Hidden/My Shaders/Toon (2)"
{
}
