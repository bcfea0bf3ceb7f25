// The file of a platform: how textures and buffers are declared there.
#define UNITY_UV_STARTS_AT_TOP 1
#define CBUFFER_START(name) cbuffer name {
#define CBUFFER_END };
#define ZERO_INITIALIZE(type, name) name = (type)0;
#define ZERO_INITIALIZE_ARRAY(type, name, size) { for (int i = 0; i < size; i++) { name[i] = (type)0; } }
#define TEXTURE2D(name) Texture2D name
#define TEXTURE2D_HALF(name) Texture2D_half name
#define TEXTURE2D_FLOAT(name) Texture2D_float name
#define TEXTURECUBE_HALF(name) TextureCube_half name
#define TEXTURE2D_ARRAY_FLOAT(name) Texture2DArray_float name
#define SAMPLER(name) SamplerState name
#define SAMPLER_CMP(name) SamplerComparisonState name
#define TEXTURE2D_PARAM(name, samplerName) TEXTURE2D(name), SAMPLER(samplerName)
#define TEXTURE2D_ARGS(name, samplerName) name, samplerName
#define SAMPLE_TEXTURE2D(name, samplerName, uv) name.Sample(samplerName, uv)
#define LOAD_TEXTURE2D(name, position) name.Load(int3(position, 0))
#define GATHER_RED_TEXTURE2D(name, samplerName, uv) name.GatherRed(samplerName, uv)
#define UNITY_LOOP [loop]
#define UNITY_UNROLL [unroll]
#define UNITY_BRANCH [branch]
