Shader "T"
{
    Dependency "A" "B"
}
