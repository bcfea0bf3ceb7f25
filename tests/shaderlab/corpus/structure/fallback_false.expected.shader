Shader "T"
{
}
