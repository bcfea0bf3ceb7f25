Shader
{
}
