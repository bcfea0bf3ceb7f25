#include "port/Same.h"

namespace limn::test
{

// Never called: that they compile is the test.
void SameLines::Materials()
{
    SAME("Color", sizeof(Color));
    SAME("Color.HSVToRGB", Color::HSVToRGB(0.5f, 1.0f, 1.0f));
    SAME("Color.Lerp", Color::Lerp(Color::red, Color::blue, 0.5f));
    SAME("Color.LerpUnclamped", Color::LerpUnclamped(Color::red, Color::blue, 0.5f));
    SAME("Color.RGBToHSV", Color::RGBToHSV(color, number, number, number));
    SAME("Color.a", color.a = 1.0f);
    SAME("Color.b", color.b = 1.0f);
    SAME("Color.black", Color::black);
    SAME("Color.blue", Color::blue);
    SAME("Color.clear", Color::clear);
    SAME("Color.cyan", Color::cyan);
    SAME("Color.g", color.g = 1.0f);
    SAME("Color.gray", Color::gray);
    SAME("Color.green", Color::green);
    SAME("Color.grey", Color::grey);
    SAME("Color.magenta", Color::magenta);
    SAME("Color.r", color.r = 1.0f);
    SAME("Color.red", Color::red);
    SAME("Color.white", Color::white);
    SAME("Color.yellow", Color::yellow);
    SAME("Color32", sizeof(Color32));
    SAME("Color32.a", color32.a = 255);
    SAME("Color32.b", color32.b = 255);
    SAME("Color32.g", color32.g = 255);
    SAME("Color32.r", color32.r = 255);
    SAME("ComputeShader.DisableKeyword", compute->DisableKeyword("WET"));
    SAME("ComputeShader.EnableKeyword", compute->EnableKeyword("WET"));
    SAME("ComputeShader.FindKernel", compute->FindKernel("Main"));
    SAME("ComputeShader.GetKernelThreadGroupSizes",
         compute->GetKernelThreadGroupSizes(0, size, size, size));
    SAME("ComputeShader.HasKernel", compute->HasKernel("Main"));
    SAME("ComputeShader.IsKeywordEnabled", compute->IsKeywordEnabled("WET"));
    SAME("ComputeShader.IsSupported", compute->IsSupported(0));
    SAME("ComputeShader.SetBool", compute->SetBool("_On", true));
    SAME("ComputeShader.SetBuffer", compute->SetBuffer(0, "_Points", buffer));
    SAME("ComputeShader.SetConstantBuffer", compute->SetConstantBuffer("Params", buffer, 0, 16));
    SAME("ComputeShader.SetFloat", compute->SetFloat("_Width", 1.0f));
    SAME("ComputeShader.SetFloats", compute->SetFloats("_Size", floats));
    SAME("ComputeShader.SetInt", compute->SetInt("_Count", 1));
    SAME("ComputeShader.SetInts", compute->SetInts("_Size", ints));
    SAME("ComputeShader.SetKeyword", compute->SetKeyword("WET", true));
    SAME("ComputeShader.SetMatrix", compute->SetMatrix("_M", matrix));
    SAME("ComputeShader.SetMatrixArray", compute->SetMatrixArray("_M", matrices));
    SAME("ComputeShader.SetTexture", compute->SetTexture(0, "_Source", a));
    SAME("ComputeShader.SetVector", compute->SetVector("_V", Vector4(1, 2, 3, 4)));
    SAME("ComputeShader.SetVector", compute->SetVector("_V", Vector2(1, 2)));
    SAME("ComputeShader.SetVectorArray", compute->SetVectorArray("_V", vectors));
    SAME("Debug", Debug::Log("x"));
    SAME("Debug.Assert", Debug::Assert(true, "text"));
    SAME("Debug.Log", Debug::Log("text"));
    SAME("Debug.LogError", Debug::LogError("text"));
    SAME("Debug.LogErrorFormat", Debug::LogErrorFormat("{0}", "x"));
    SAME("Debug.LogException", Debug::LogException(std::runtime_error("x")));
    SAME("Debug.LogFormat", Debug::LogFormat("{0} of {1}", 1, 2));
    SAME("Debug.LogWarning", Debug::LogWarning(1.5f));
    SAME("Debug.LogWarningFormat", Debug::LogWarningFormat("{0:F2}", 1.5f));
    SAME("Random", sizeof(Random));
    SAME("Random.InitState", Random::InitState(7));
    SAME("Random.Range", Random::Range(-1.0f, 1.0f));
    SAME("GlobalKeyword", sizeof(GlobalKeyword));
    SAME("GlobalKeyword.Create", GlobalKeyword::Create("WET"));
    SAME("ComputeBuffer.Dispose", computeBuffer->Dispose());
    SAME("ComputeBuffer.IsValid", computeBuffer->IsValid());
    SAME("ComputeBuffer.Release", computeBuffer->Release());
    SAME("ComputeBuffer.SetCounterValue", computeBuffer->SetCounterValue(0));
    SAME("ComputeBuffer.SetData", computeBuffer->SetData(floats));
    SAME("GraphicsBuffer.Dispose", buffer->Dispose());
    SAME("GraphicsBuffer.IsValid", buffer->IsValid());
    SAME("GraphicsBuffer.Release", buffer->Release());
    SAME("GraphicsBuffer.SetCounterValue", buffer->SetCounterValue(0));
    SAME("GraphicsBuffer.SetData", buffer->SetData(floats));
    SAME("GraphicsBuffer.Target", GraphicsBuffer::Target());
    SAME("GraphicsBuffer.Target", GraphicsBuffer::Target::Structured);
    SAME("GraphicsFormatUtility", GraphicsFormatUtility::IsSRGBFormat(GraphicsFormat::R8_UNorm));
    SAME("GraphicsFormatUtility.ComputeMipmapSize",
         GraphicsFormatUtility::ComputeMipmapSize(64, 64, format));
    SAME("GraphicsFormatUtility.GetAlphaComponentCount",
         GraphicsFormatUtility::GetAlphaComponentCount(format));
    SAME("GraphicsFormatUtility.GetBlockHeight", GraphicsFormatUtility::GetBlockHeight(format));
    SAME("GraphicsFormatUtility.GetBlockSize", GraphicsFormatUtility::GetBlockSize(format));
    SAME("GraphicsFormatUtility.GetBlockWidth", GraphicsFormatUtility::GetBlockWidth(format));
    SAME("GraphicsFormatUtility.GetColorComponentCount",
         GraphicsFormatUtility::GetColorComponentCount(format));
    SAME("GraphicsFormatUtility.GetComponentCount",
         GraphicsFormatUtility::GetComponentCount(format));
    SAME("GraphicsFormatUtility.GetDepthBits", GraphicsFormatUtility::GetDepthBits(format));
    SAME("GraphicsFormatUtility.GetFormatString", GraphicsFormatUtility::GetFormatString(format));
    SAME("GraphicsFormatUtility.GetGraphicsFormat",
         GraphicsFormatUtility::GetGraphicsFormat(RenderTextureFormat::ARGB32, true));
    SAME("GraphicsFormatUtility.GetGraphicsFormat",
         GraphicsFormatUtility::GetGraphicsFormat(TextureFormat::RGBA32, true));
    SAME("GraphicsFormatUtility.GetGraphicsFormat",
         GraphicsFormatUtility::GetGraphicsFormat(RenderTextureFormat::ARGB32,
                                                  RenderTextureReadWrite::sRGB));
    SAME("GraphicsFormatUtility.GetLinearFormat", GraphicsFormatUtility::GetLinearFormat(format));
    SAME("GraphicsFormatUtility.GetRenderTextureFormat",
         GraphicsFormatUtility::GetRenderTextureFormat(format));
    SAME("GraphicsFormatUtility.GetSRGBFormat", GraphicsFormatUtility::GetSRGBFormat(format));
    SAME("GraphicsFormatUtility.HasAlphaChannel", GraphicsFormatUtility::HasAlphaChannel(format));
    SAME("GraphicsFormatUtility.IsCompressedFormat",
         GraphicsFormatUtility::IsCompressedFormat(format));
    SAME("GraphicsFormatUtility.IsDepthFormat", GraphicsFormatUtility::IsDepthFormat(format));
    SAME("GraphicsFormatUtility.IsDepthStencilFormat",
         GraphicsFormatUtility::IsDepthStencilFormat(format));
    SAME("GraphicsFormatUtility.IsFloatFormat", GraphicsFormatUtility::IsFloatFormat(format));
    SAME("GraphicsFormatUtility.IsHalfFormat", GraphicsFormatUtility::IsHalfFormat(format));
    SAME("GraphicsFormatUtility.IsIEEE754Format", GraphicsFormatUtility::IsIEEE754Format(format));
    SAME("GraphicsFormatUtility.IsIntegerFormat", GraphicsFormatUtility::IsIntegerFormat(format));
    SAME("GraphicsFormatUtility.IsNormFormat", GraphicsFormatUtility::IsNormFormat(format));
    SAME("GraphicsFormatUtility.IsPackedFormat", GraphicsFormatUtility::IsPackedFormat(format));
    SAME("GraphicsFormatUtility.IsSIntFormat", GraphicsFormatUtility::IsSIntFormat(format));
    SAME("GraphicsFormatUtility.IsSNormFormat", GraphicsFormatUtility::IsSNormFormat(format));
    SAME("GraphicsFormatUtility.IsSRGBFormat", GraphicsFormatUtility::IsSRGBFormat(format));
    SAME("GraphicsFormatUtility.IsSignedFormat", GraphicsFormatUtility::IsSignedFormat(format));
    SAME("GraphicsFormatUtility.IsStencilFormat", GraphicsFormatUtility::IsStencilFormat(format));
    SAME("GraphicsFormatUtility.IsUIntFormat", GraphicsFormatUtility::IsUIntFormat(format));
    SAME("GraphicsFormatUtility.IsUNormFormat", GraphicsFormatUtility::IsUNormFormat(format));
    SAME("List", sizeof(List<float>));
    SAME("List.Add", numbers.Add(1.0f));
    SAME("List.AddRange", numbers.AddRange(floats));
    SAME("List.Clear", numbers.Clear());
    SAME("List.Contains", numbers.Contains(1.0f));
    SAME("List.IndexOf", numbers.IndexOf(1.0f));
    SAME("List.Insert", numbers.Insert(0, 1.0f));
    SAME("List.Remove", numbers.Remove(1.0f));
    SAME("List.RemoveAt", numbers.RemoveAt(0));
    SAME("Material.CopyMatchingPropertiesFromMaterial",
         material->CopyMatchingPropertiesFromMaterial(*material));
    SAME("Material.CopyPropertiesFromMaterial", material->CopyPropertiesFromMaterial(*material));
    SAME("Material.DisableKeyword", material->DisableKeyword("WET"));
    SAME("Material.EnableKeyword", material->EnableKeyword("WET"));
    SAME("Material.FindPass", material->FindPass("Blur"));
    SAME("Material.GetColorArray", material->GetColorArray("_C"));
    SAME("Material.GetFloatArray", material->GetFloatArray("_W"));
    SAME("Material.GetMatrixArray", material->GetMatrixArray("_M"));
    SAME("Material.GetPassName", material->GetPassName(0));
    SAME("Material.GetPropertyNames", material->GetPropertyNames(MaterialPropertyType::Float));
    SAME("Material.GetShaderPassEnabled", material->GetShaderPassEnabled("ShadowCaster"));
    SAME("Material.GetTag", material->GetTag("RenderType", false));
    SAME("Material.GetTexture", material->GetTexture("_MainTex"));
    SAME("Material.GetTextureOffset", material->GetTextureOffset("_MainTex"));
    SAME("Material.GetTexturePropertyNameIDs", material->GetTexturePropertyNameIDs());
    SAME("Material.GetTexturePropertyNames", material->GetTexturePropertyNames());
    SAME("Material.GetTextureScale", material->GetTextureScale("_MainTex"));
    SAME("Material.GetVectorArray", material->GetVectorArray("_V"));
    SAME("Material.HasColor", material->HasColor("_C"));
    SAME("Material.HasFloat", material->HasFloat("_W"));
    SAME("Material.HasInt", material->HasInt("_W"));
    SAME("Material.HasInteger", material->HasInteger("_W"));
    SAME("Material.HasProperty", material->HasProperty("_W"));
    SAME("Material.HasTexture", material->HasTexture("_MainTex"));
    SAME("Material.HasVector", material->HasVector("_V"));
    SAME("Material.IsKeywordEnabled", material->IsKeywordEnabled("WET"));
    SAME("Material.Lerp", material->Lerp(*material, *material, 0.5f));
    SAME("Material.SetBuffer", material->SetBuffer("_Points", buffer));
    SAME("Material.SetColor", material->SetColor("_C", Color::red));
    SAME("Material.SetColorArray", material->SetColorArray("_C", colors));
    SAME("Material.SetConstantBuffer", material->SetConstantBuffer("Params", buffer, 0, 16));
    SAME("Material.SetFloat", material->SetFloat(id, 1.0f));
    SAME("Material.SetFloat", settings.material->SetFloat("_Width", 2));
    SAME("Material.SetFloatArray", material->SetFloatArray("_W", floats));
    SAME("Material.SetInt", material->SetInt("_Count", 1));
    SAME("Material.SetInteger", material->SetInteger("_Count", 1));
    SAME("Material.SetKeyword", material->SetKeyword(localKeyword, true));
    SAME("Material.SetMatrix", material->SetMatrix("_M", matrix));
    SAME("Material.SetMatrixArray", material->SetMatrixArray("_M", matrices));
    SAME("Material.SetOverrideTag", material->SetOverrideTag("RenderType", "Opaque"));
    SAME("Material.SetShaderPassEnabled", material->SetShaderPassEnabled("ShadowCaster", false));
    SAME("Material.SetTextureOffset", material->SetTextureOffset("_MainTex", Vector2(0, 0)));
    SAME("Material.SetTextureScale", material->SetTextureScale("_MainTex", Vector2(1, 1)));
    SAME("Material.SetVector", material->SetVector("_V", Vector4(1, 2, 3, 4)));
    SAME("Material.SetVector", material->SetVector("_V", Vector2(1, 2)));
    SAME("Material.SetVector", material->SetVector("_V", Vector3(1, 2, 3)));
    SAME("Material.SetVectorArray", material->SetVectorArray("_V", vectors));
    SAME("Material.enableInstancing", material->enableInstancing = true);
    SAME("MaterialPropertyBlock", sizeof(MaterialPropertyBlock));
    SAME("MaterialPropertyBlock.Clear", block.Clear());
    SAME("MaterialPropertyBlock.GetColor", block.GetColor("_X"));
    SAME("MaterialPropertyBlock.GetFloat", block.GetFloat("_X"));
    SAME("MaterialPropertyBlock.GetFloatArray", block.GetFloatArray("_X"));
    SAME("MaterialPropertyBlock.GetInt", block.GetInt("_X"));
    SAME("MaterialPropertyBlock.GetInteger", block.GetInteger("_X"));
    SAME("MaterialPropertyBlock.GetMatrix", block.GetMatrix("_X"));
    SAME("MaterialPropertyBlock.GetMatrixArray", block.GetMatrixArray("_X"));
    SAME("MaterialPropertyBlock.GetTexture", block.GetTexture("_X"));
    SAME("MaterialPropertyBlock.GetVector", block.GetVector("_X"));
    SAME("MaterialPropertyBlock.GetVectorArray", block.GetVectorArray("_X"));
    SAME("MaterialPropertyBlock.HasBuffer", block.HasBuffer("_X"));
    SAME("MaterialPropertyBlock.HasColor", block.HasColor("_X"));
    SAME("MaterialPropertyBlock.HasConstantBuffer", block.HasConstantBuffer("_X"));
    SAME("MaterialPropertyBlock.HasFloat", block.HasFloat("_X"));
    SAME("MaterialPropertyBlock.HasInt", block.HasInt("_X"));
    SAME("MaterialPropertyBlock.HasInteger", block.HasInteger("_X"));
    SAME("MaterialPropertyBlock.HasMatrix", block.HasMatrix("_X"));
    SAME("MaterialPropertyBlock.HasProperty", block.HasProperty("_X"));
    SAME("MaterialPropertyBlock.HasTexture", block.HasTexture("_X"));
    SAME("MaterialPropertyBlock.HasVector", block.HasVector("_X"));
    SAME("MaterialPropertyBlock.SetBuffer", block.SetBuffer("_Points", buffer));
    SAME("MaterialPropertyBlock.SetColor", block.SetColor("_C", Color::red));
    SAME("MaterialPropertyBlock.SetConstantBuffer",
         block.SetConstantBuffer("Params", buffer, 0, 16));
    SAME("MaterialPropertyBlock.SetFloat", block.SetFloat(id, 1.0f));
    SAME("MaterialPropertyBlock.SetFloatArray", block.SetFloatArray("_W", floats));
    SAME("MaterialPropertyBlock.SetInt", block.SetInt("_Count", 1));
    SAME("MaterialPropertyBlock.SetInteger", block.SetInteger("_Count", 1));
    SAME("MaterialPropertyBlock.SetMatrix", block.SetMatrix("_M", matrix));
    SAME("MaterialPropertyBlock.SetMatrixArray", block.SetMatrixArray("_M", matrices));
    SAME("MaterialPropertyBlock.SetVector", block.SetVector("_V", Vector4(1, 2, 3, 4)));
    SAME("MaterialPropertyBlock.SetVector", block.SetVector("_V", Vector2(1, 2)));
    SAME("MaterialPropertyBlock.SetVectorArray", block.SetVectorArray("_V", vectors));
    SAME("Mathf", Mathf::PI);
    SAME("Mathf.Abs", Mathf::Abs(0.5f));
    SAME("Mathf.Acos", Mathf::Acos(0.5f));
    SAME("Mathf.Approximately", Mathf::Approximately(0.5f, 2.0f));
    SAME("Mathf.Asin", Mathf::Asin(0.5f));
    SAME("Mathf.Atan", Mathf::Atan(0.5f));
    SAME("Mathf.Atan2", Mathf::Atan2(0.5f, 2.0f));
    SAME("Mathf.Ceil", Mathf::Ceil(0.5f));
    SAME("Mathf.Clamp", Mathf::Clamp(0.5f, 0.0f, 2.0f));
    SAME("Mathf.Clamp01", Mathf::Clamp01(0.5f));
    SAME("Mathf.Cos", Mathf::Cos(0.5f));
    SAME("Mathf.Deg2Rad", Mathf::Deg2Rad);
    SAME("Mathf.Epsilon", Mathf::Epsilon);
    SAME("Mathf.Exp", Mathf::Exp(0.5f));
    SAME("Mathf.Floor", Mathf::Floor(0.5f));
    SAME("Mathf.Infinity", Mathf::Infinity);
    SAME("Mathf.InverseLerp", Mathf::InverseLerp(0.5f, 0.0f, 2.0f));
    SAME("Mathf.IsPowerOfTwo", Mathf::IsPowerOfTwo(5));
    SAME("Mathf.Lerp", Mathf::Lerp(0.5f, 0.0f, 2.0f));
    SAME("Mathf.LerpUnclamped", Mathf::LerpUnclamped(0.5f, 0.0f, 2.0f));
    SAME("Mathf.Log", Mathf::Log(0.5f));
    SAME("Mathf.Log10", Mathf::Log10(0.5f));
    SAME("Mathf.Max", Mathf::Max(0.5f, 2.0f));
    SAME("Mathf.Min", Mathf::Min(0.5f, 2.0f));
    SAME("Mathf.MoveTowards", Mathf::MoveTowards(0.5f, 0.0f, 2.0f));
    SAME("Mathf.NegativeInfinity", Mathf::NegativeInfinity);
    SAME("Mathf.NextPowerOfTwo", Mathf::NextPowerOfTwo(5));
    SAME("Mathf.PI", Mathf::PI);
    SAME("Mathf.PingPong", Mathf::PingPong(0.5f, 2.0f));
    SAME("Mathf.Pow", Mathf::Pow(0.5f, 2.0f));
    SAME("Mathf.Rad2Deg", Mathf::Rad2Deg);
    SAME("Mathf.Repeat", Mathf::Repeat(0.5f, 2.0f));
    SAME("Mathf.Round", Mathf::Round(0.5f));
    SAME("Mathf.Sign", Mathf::Sign(0.5f));
    SAME("Mathf.Sin", Mathf::Sin(0.5f));
    SAME("Mathf.SmoothStep", Mathf::SmoothStep(0.5f, 0.0f, 2.0f));
    SAME("Mathf.Sqrt", Mathf::Sqrt(0.5f));
    SAME("Mathf.Tan", Mathf::Tan(0.5f));
    SAME("Mesh.GetBaseVertex", mesh->GetBaseVertex(0));
    SAME("Mesh.GetIndexCount", mesh->GetIndexCount(0));
    SAME("Mesh.GetIndexStart", mesh->GetIndexStart(0));
    SAME("Renderer.GetPropertyBlock", renderer.GetPropertyBlock(block));
    SAME("Renderer.GetSharedMaterials", renderer.GetSharedMaterials(constMaterials));
    SAME("Renderer.HasPropertyBlock", renderer.HasPropertyBlock());
    SAME("Renderer.SetPropertyBlock", renderer.SetPropertyBlock(block));
    SAME("Renderer.SetSharedMaterials", renderer.SetSharedMaterials(constMaterials));
    SAME("Renderer.enabled", renderer.enabled = true);
    SAME("Renderer.renderingLayerMask", renderer.renderingLayerMask);
    SAME("Renderer.shadowCastingMode", renderer.shadowCastingMode = ShadowCastingMode::On);
    SAME("Renderer.sharedMaterials", renderer.sharedMaterials);
    SAME("Shader.DisableKeyword", Shader::DisableKeyword("WET"));
    SAME("Shader.EnableKeyword", Shader::EnableKeyword("WET"));
    SAME("Shader.FindPropertyIndex", shader->FindPropertyIndex("_Width"));
    SAME("Shader.GetGlobalColor", Shader::GetGlobalColor("_X"));
    SAME("Shader.GetGlobalFloat", Shader::GetGlobalFloat("_X"));
    SAME("Shader.GetGlobalFloatArray", Shader::GetGlobalFloatArray("_X"));
    SAME("Shader.GetGlobalInt", Shader::GetGlobalInt("_X"));
    SAME("Shader.GetGlobalInteger", Shader::GetGlobalInteger("_X"));
    SAME("Shader.GetGlobalMatrix", Shader::GetGlobalMatrix("_X"));
    SAME("Shader.GetGlobalMatrixArray", Shader::GetGlobalMatrixArray("_X"));
    SAME("Shader.GetGlobalTexture", Shader::GetGlobalTexture("_X"));
    SAME("Shader.GetGlobalVector", Shader::GetGlobalVector("_X"));
    SAME("Shader.GetGlobalVectorArray", Shader::GetGlobalVectorArray("_X"));
    SAME("Shader.IsKeywordEnabled", Shader::IsKeywordEnabled("WET"));
    SAME("Shader.SetGlobalBuffer", Shader::SetGlobalBuffer("_Points", buffer));
    SAME("Shader.SetGlobalConstantBuffer",
         Shader::SetGlobalConstantBuffer("Params", buffer, 0, 16));
    SAME("Shader.SetKeyword", Shader::SetKeyword(globalKeyword, true));
    SAME("SystemInfo", SystemInfo::SupportsRenderTextureFormat(RenderTextureFormat::R8));
    SAME("SystemInfo.GetCompatibleFormat",
         SystemInfo::GetCompatibleFormat(GraphicsFormat::R16G16_SNorm, FormatUsage::Render));
    SAME(
        "SystemInfo.GetCompatibleFormat",
        SystemInfo::GetCompatibleFormat(GraphicsFormat::R16G16_SNorm, GraphicsFormatUsage::Render));
    SAME("SystemInfo.GetGraphicsFormat", SystemInfo::GetGraphicsFormat(DefaultFormat::HDR));
    SAME("SystemInfo.IsFormatSupported",
         SystemInfo::IsFormatSupported(GraphicsFormat::R16G16_SNorm, FormatUsage::Render));
    SAME("SystemInfo.IsFormatSupported",
         SystemInfo::IsFormatSupported(GraphicsFormat::R16G16_SNorm, GraphicsFormatUsage::Render));
    SAME("SystemInfo.SupportsBlendingOnRenderTextureFormat",
         SystemInfo::SupportsBlendingOnRenderTextureFormat(RenderTextureFormat::RFloat));
    SAME("SystemInfo.SupportsRandomWriteOnRenderTextureFormat",
         SystemInfo::SupportsRandomWriteOnRenderTextureFormat(RenderTextureFormat::RFloat));
    SAME("SystemInfo.SupportsRenderTextureFormat",
         SystemInfo::SupportsRenderTextureFormat(RenderTextureFormat::RHalf));
    SAME("SystemInfo.SupportsTextureFormat",
         SystemInfo::SupportsTextureFormat(TextureFormat::RGBA32));
}

} // namespace limn::test
