Shader "T"
{
    Settings { A { B "}" } C }
    Fallback "F"
}
