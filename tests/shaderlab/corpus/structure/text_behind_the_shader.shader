Shader "T"
{
}
}
