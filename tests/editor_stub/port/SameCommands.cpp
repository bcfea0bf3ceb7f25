#include "port/Same.h"

namespace limn::test
{

// Never called: that they compile is the test.
void SameLines::Commands()
{
    SAME("Blitter", Blitter::BlitCameraTexture(cmd, a, b));
    SAME("Blitter.BlitCameraTexture", Blitter::BlitCameraTexture(cmd, a, b, material, 0));
    SAME("Blitter.BlitCameraTexture", Blitter::BlitCameraTexture(cmd, a, b));
    SAME("Blitter.BlitCameraTexture2D", Blitter::BlitCameraTexture2D(cmd, a, b));
    SAME("Blitter.BlitColorAndDepth",
         Blitter::BlitColorAndDepth(cmd, a, b, Vector4(1, 1, 0, 0), 0, true));
    SAME("Blitter.BlitQuad",
         Blitter::BlitQuad(cmd, a, Vector4(1, 1, 0, 0), Vector4(1, 1, 0, 0), 0, true));
    SAME("Blitter.BlitTexture", Blitter::BlitTexture(cmd, a, Vector4(1, 1, 0, 0), material, 0));
    SAME("Blitter.BlitTexture", Blitter::BlitTexture(rasterCmd, a, Vector4(1, 1, 0, 0), 0, false));
    SAME("Blitter.BlitTexture2D", Blitter::BlitTexture2D(cmd, a, Vector4(1, 1, 0, 0), 0, false));
    SAME("CommandBuffer", sizeof(CommandBuffer));
    SAME("CommandBuffer.BeginSample", cmd.BeginSample("Blur"));
    SAME("CommandBuffer.Blit", cmd.Blit(a, b, material, 0));
    SAME("CommandBuffer.Blit", cmd.Blit(identifier, BuiltinRenderTextureType::CameraTarget));
    SAME("CommandBuffer.Clear", cmd.Clear());
    SAME("CommandBuffer.ClearRenderTarget", cmd.ClearRenderTarget(true, true, Color::clear));
    SAME("CommandBuffer.ClearRenderTarget",
         cmd.ClearRenderTarget(RTClearFlags::ColorDepth, Color::black, 1.0f, 0));
    SAME("CommandBuffer.CopyBuffer", cmd.CopyBuffer(buffer, buffer));
    SAME("CommandBuffer.CopyCounterValue", cmd.CopyCounterValue(buffer, buffer, 0));
    SAME("CommandBuffer.DisableKeyword", cmd.DisableKeyword(globalKeyword));
    SAME("CommandBuffer.DisableScissorRect", cmd.DisableScissorRect());
    SAME("CommandBuffer.DisableShaderKeyword", cmd.DisableShaderKeyword("WET"));
    SAME("CommandBuffer.DispatchCompute", cmd.DispatchCompute(compute, 0, 8, 8, 1));
    SAME("CommandBuffer.DrawMesh", cmd.DrawMesh(mesh, matrix, material, 0, 0, block));
    SAME("CommandBuffer.DrawMeshInstancedIndirect",
         cmd.DrawMeshInstancedIndirect(mesh, 0, material, 0, buffer, 0, block));
    SAME("CommandBuffer.DrawMeshInstancedProcedural",
         cmd.DrawMeshInstancedProcedural(mesh, 0, material, 0, 10, block));
    SAME("CommandBuffer.DrawProcedural",
         cmd.DrawProcedural(matrix, material, 0, MeshTopology::Triangles, 3, 1, block));
    SAME(
        "CommandBuffer.DrawProceduralIndirect",
        cmd.DrawProceduralIndirect(matrix, material, 0, MeshTopology::Triangles, buffer, 0, block));
    SAME("CommandBuffer.DrawRendererList", cmd.DrawRendererList(list));
    SAME("CommandBuffer.EnableKeyword", cmd.EnableKeyword(globalKeyword));
    SAME("CommandBuffer.EnableShaderKeyword", cmd.EnableShaderKeyword("WET"));
    SAME("CommandBuffer.EndSample", cmd.EndSample("Blur"));
    SAME("CommandBuffer.GenerateMips", cmd.GenerateMips(a));
    SAME("CommandBuffer.GetTemporaryRT", cmd.GetTemporaryRT(id, descriptor, FilterMode::Bilinear));
    SAME("CommandBuffer.GetTemporaryRT",
         cmd.GetTemporaryRT(id, 64, 64, 0, FilterMode::Bilinear, RenderTextureFormat::ARGBHalf));
    SAME("CommandBuffer.SetBufferCounterValue", cmd.SetBufferCounterValue(buffer, 0));
    SAME("CommandBuffer.SetComputeBufferParam",
         cmd.SetComputeBufferParam(compute, 0, "_Points", buffer));
    SAME("CommandBuffer.SetComputeConstantBufferParam",
         cmd.SetComputeConstantBufferParam(compute, "Params", buffer, 0, 16));
    SAME("CommandBuffer.SetComputeFloatParam", cmd.SetComputeFloatParam(compute, "_Width", 1.0f));
    SAME("CommandBuffer.SetComputeFloatParams",
         cmd.SetComputeFloatParams(compute, "_Size", 1.0f, 2.0f));
    SAME("CommandBuffer.SetComputeIntParam", cmd.SetComputeIntParam(compute, "_Count", 1));
    SAME("CommandBuffer.SetComputeIntParams", cmd.SetComputeIntParams(compute, "_Size", 1, 2));
    SAME("CommandBuffer.SetComputeMatrixArrayParam",
         cmd.SetComputeMatrixArrayParam(compute, "_M", matrices));
    SAME("CommandBuffer.SetComputeMatrixParam", cmd.SetComputeMatrixParam(compute, "_M", matrix));
    SAME("CommandBuffer.SetComputeParamsFromMaterial",
         cmd.SetComputeParamsFromMaterial(compute, 0, material));
    SAME("CommandBuffer.SetComputeTextureParam",
         cmd.SetComputeTextureParam(compute, 0, "_Source", a));
    SAME("CommandBuffer.SetComputeVectorArrayParam",
         cmd.SetComputeVectorArrayParam(compute, "_V", vectors));
    SAME("CommandBuffer.SetComputeVectorParam",
         cmd.SetComputeVectorParam(compute, "_V", Vector4(1, 2, 3, 4)));
    SAME("CommandBuffer.SetComputeVectorParam",
         cmd.SetComputeVectorParam(compute, "_V", Vector2(1, 2)));
    SAME("CommandBuffer.SetGlobalBuffer", cmd.SetGlobalBuffer("_Points", buffer));
    SAME("CommandBuffer.SetGlobalColor", cmd.SetGlobalColor("_Tint", Color::red));
    SAME("CommandBuffer.SetGlobalConstantBuffer",
         cmd.SetGlobalConstantBuffer(buffer, "Params", 0, 16));
    SAME("CommandBuffer.SetGlobalDepthBias", cmd.SetGlobalDepthBias(1.0f, 2.0f));
    SAME("CommandBuffer.SetGlobalFloat", cmd.SetGlobalFloat(id, 1.0f));
    SAME("CommandBuffer.SetGlobalFloat", cmd.SetGlobalFloat("_Width", 1));
    SAME("CommandBuffer.SetGlobalFloatArray", cmd.SetGlobalFloatArray("_W", floats));
    SAME("CommandBuffer.SetGlobalInt", cmd.SetGlobalInt("_Count", 1));
    SAME("CommandBuffer.SetGlobalInteger", cmd.SetGlobalInteger("_Count", 1));
    SAME("CommandBuffer.SetGlobalMatrix", cmd.SetGlobalMatrix("_M", matrix));
    SAME("CommandBuffer.SetGlobalMatrixArray", cmd.SetGlobalMatrixArray("_M", matrices));
    SAME("CommandBuffer.SetGlobalTexture", cmd.SetGlobalTexture("_Mask", a));
    SAME("CommandBuffer.SetGlobalVector", cmd.SetGlobalVector(id, Vector4(1, 2, 3, 4)));
    SAME("CommandBuffer.SetGlobalVector", cmd.SetGlobalVector("_Offset", Vector2(1, 2)));
    SAME("CommandBuffer.SetGlobalVector", cmd.SetGlobalVector("_Offset", Vector3(1, 2, 3)));
    SAME("CommandBuffer.SetGlobalVector", cmd.SetGlobalVector("_Tint", Color::red));
    SAME("CommandBuffer.SetGlobalVectorArray", cmd.SetGlobalVectorArray("_V", vectors));
    SAME("CommandBuffer.SetInvertCulling", cmd.SetInvertCulling(true));
    SAME("CommandBuffer.SetKeyword", cmd.SetKeyword(globalKeyword, true));
    SAME("CommandBuffer.SetProjectionMatrix", cmd.SetProjectionMatrix(matrix));
    SAME("CommandBuffer.SetRenderTarget", cmd.SetRenderTarget(a));
    SAME("CommandBuffer.SetRenderTarget", cmd.SetRenderTarget(a, b));
    SAME("CommandBuffer.SetViewMatrix", cmd.SetViewMatrix(matrix));
    SAME("CommandBuffer.SetViewProjectionMatrices",
         cmd.SetViewProjectionMatrices(cameraData.GetViewMatrix(),
                                       cameraData.GetProjectionMatrix()));
    SAME("CommandBuffer.name", cmd.name = "Blur");
    SAME("CommandBufferHelpers", CommandBufferHelpers::GetNativeCommandBuffer(unsafeCmd));
    SAME("CommandBufferHelpers.GetNativeCommandBuffer",
         CommandBufferHelpers::GetNativeCommandBuffer(unsafeCmd));
    SAME("CommandBufferPool.Release", CommandBufferPool::Release(pooled));
    SAME("ComputeCommandBuffer", sizeof(ComputeCommandBuffer));
    SAME("ComputeCommandBuffer.BeginSample", computeCmd.BeginSample("Blur"));
    SAME("ComputeCommandBuffer.CopyCounterValue", computeCmd.CopyCounterValue(buffer, buffer, 0));
    SAME("ComputeCommandBuffer.DisableKeyword", computeCmd.DisableKeyword(globalKeyword));
    SAME("ComputeCommandBuffer.DispatchCompute", computeCmd.DispatchCompute(compute, 0, 8, 8, 1));
    SAME("ComputeCommandBuffer.EnableKeyword", computeCmd.EnableKeyword(globalKeyword));
    SAME("ComputeCommandBuffer.EndSample", computeCmd.EndSample("Blur"));
    SAME("ComputeCommandBuffer.SetBufferCounterValue", computeCmd.SetBufferCounterValue(buffer, 0));
    SAME("ComputeCommandBuffer.SetComputeBufferParam",
         computeCmd.SetComputeBufferParam(compute, 0, "_Points", buffer));
    SAME("ComputeCommandBuffer.SetComputeConstantBufferParam",
         computeCmd.SetComputeConstantBufferParam(compute, "Params", buffer, 0, 16));
    SAME("ComputeCommandBuffer.SetComputeFloatParam",
         computeCmd.SetComputeFloatParam(compute, "_Width", 1.0f));
    SAME("ComputeCommandBuffer.SetComputeFloatParams",
         computeCmd.SetComputeFloatParams(compute, "_Size", 1.0f, 2.0f));
    SAME("ComputeCommandBuffer.SetComputeIntParam",
         computeCmd.SetComputeIntParam(compute, "_Count", 1));
    SAME("ComputeCommandBuffer.SetComputeIntParams",
         computeCmd.SetComputeIntParams(compute, "_Size", 1, 2));
    SAME("ComputeCommandBuffer.SetComputeMatrixArrayParam",
         computeCmd.SetComputeMatrixArrayParam(compute, "_M", matrices));
    SAME("ComputeCommandBuffer.SetComputeMatrixParam",
         computeCmd.SetComputeMatrixParam(compute, "_M", matrix));
    SAME("ComputeCommandBuffer.SetComputeParamsFromMaterial",
         computeCmd.SetComputeParamsFromMaterial(compute, 0, material));
    SAME("ComputeCommandBuffer.SetComputeTextureParam",
         computeCmd.SetComputeTextureParam(compute, 0, "_Source", a));
    SAME("ComputeCommandBuffer.SetComputeVectorArrayParam",
         computeCmd.SetComputeVectorArrayParam(compute, "_V", vectors));
    SAME("ComputeCommandBuffer.SetComputeVectorParam",
         computeCmd.SetComputeVectorParam(compute, "_V", Vector4(1, 2, 3, 4)));
    SAME("ComputeCommandBuffer.SetComputeVectorParam",
         computeCmd.SetComputeVectorParam(compute, "_V", Vector2(1, 2)));
    SAME("ComputeCommandBuffer.SetGlobalBuffer", computeCmd.SetGlobalBuffer("_Points", buffer));
    SAME("ComputeCommandBuffer.SetGlobalColor", computeCmd.SetGlobalColor("_Tint", Color::red));
    SAME("ComputeCommandBuffer.SetGlobalFloat", computeCmd.SetGlobalFloat(id, 1.0f));
    SAME("ComputeCommandBuffer.SetGlobalFloat", computeCmd.SetGlobalFloat("_Width", 1));
    SAME("ComputeCommandBuffer.SetGlobalInt", computeCmd.SetGlobalInt("_Count", 1));
    SAME("ComputeCommandBuffer.SetGlobalInteger", computeCmd.SetGlobalInteger("_Count", 1));
    SAME("ComputeCommandBuffer.SetGlobalMatrix", computeCmd.SetGlobalMatrix("_M", matrix));
    SAME("ComputeCommandBuffer.SetGlobalTexture", computeCmd.SetGlobalTexture("_Mask", a));
    SAME("ComputeCommandBuffer.SetGlobalVector",
         computeCmd.SetGlobalVector(id, Vector4(1, 2, 3, 4)));
    SAME("ComputeCommandBuffer.SetGlobalVector",
         computeCmd.SetGlobalVector("_Offset", Vector2(1, 2)));
    SAME("ComputeCommandBuffer.SetGlobalVector",
         computeCmd.SetGlobalVector("_Offset", Vector3(1, 2, 3)));
    SAME("ComputeCommandBuffer.SetGlobalVector", computeCmd.SetGlobalVector("_Tint", Color::red));
    SAME("ComputeCommandBuffer.SetKeyword", computeCmd.SetKeyword(globalKeyword, true));
    SAME("CoreUtils", CoreUtils::SetKeyword(cmd, "WET", true));
    SAME("CoreUtils.ArePostProcessesEnabled", CoreUtils::ArePostProcessesEnabled(camera));
    SAME("CoreUtils.ClearRenderTarget",
         CoreUtils::ClearRenderTarget(cmd, ClearFlag::All, Color::clear));
    SAME("CoreUtils.ConvertLinearToActiveColorSpace",
         CoreUtils::ConvertLinearToActiveColorSpace(color));
    SAME("CoreUtils.ConvertSRGBToActiveColorSpace",
         CoreUtils::ConvertSRGBToActiveColorSpace(color));
    SAME("CoreUtils.CreateCubeMesh", CoreUtils::CreateCubeMesh(Vector3(0), Vector3(1)));
    SAME("CoreUtils.DivRoundUp", CoreUtils::DivRoundUp(7, 8));
    SAME("CoreUtils.DrawFullScreen", CoreUtils::DrawFullScreen(cmd, material, block, 0));
    SAME("CoreUtils.DrawRendererList", CoreUtils::DrawRendererList(context, cmd, list));
    SAME("CoreUtils.HasFlag", CoreUtils::HasFlag(ClearFlag::All, ClearFlag::Color));
    SAME("CoreUtils.IsSceneViewFogEnabled", CoreUtils::IsSceneViewFogEnabled(camera));
    SAME("CoreUtils.SafeRelease", CoreUtils::SafeRelease(buffer));
    SAME("CoreUtils.SetKeyword", CoreUtils::SetKeyword(cmd, "WET", true));
    SAME("CoreUtils.SetRenderTarget",
         CoreUtils::SetRenderTarget(cmd, a, b, ClearFlag::Color, Color::clear));
    SAME("CoreUtils.SetViewport", CoreUtils::SetViewport(cmd, a));
    SAME("CoreUtils.Swap", CoreUtils::Swap(a, b));
    SAME("RasterCommandBuffer", sizeof(RasterCommandBuffer));
    SAME("RasterCommandBuffer.BeginSample", rasterCmd.BeginSample("Blur"));
    SAME("RasterCommandBuffer.ClearRenderTarget",
         rasterCmd.ClearRenderTarget(true, true, Color::clear));
    SAME("RasterCommandBuffer.ClearRenderTarget",
         rasterCmd.ClearRenderTarget(RTClearFlags::ColorDepth, Color::black, 1.0f, 0));
    SAME("RasterCommandBuffer.DisableKeyword", rasterCmd.DisableKeyword(globalKeyword));
    SAME("RasterCommandBuffer.DisableScissorRect", rasterCmd.DisableScissorRect());
    SAME("RasterCommandBuffer.DisableShaderKeyword", rasterCmd.DisableShaderKeyword("WET"));
    SAME("RasterCommandBuffer.DrawMesh", rasterCmd.DrawMesh(mesh, matrix, material, 0, 0, block));
    SAME("RasterCommandBuffer.DrawMeshInstancedIndirect",
         rasterCmd.DrawMeshInstancedIndirect(mesh, 0, material, 0, buffer, 0, block));
    SAME("RasterCommandBuffer.DrawMeshInstancedProcedural",
         rasterCmd.DrawMeshInstancedProcedural(mesh, 0, material, 0, 10, block));
    SAME("RasterCommandBuffer.DrawMultipleMeshes",
         rasterCmd.DrawMultipleMeshes(matrices, meshes, subMeshes, 1, material, 0, block));
    SAME("RasterCommandBuffer.DrawProcedural",
         rasterCmd.DrawProcedural(matrix, material, 0, MeshTopology::Triangles, 3, 1, block));
    SAME("RasterCommandBuffer.DrawProceduralIndirect",
         rasterCmd.DrawProceduralIndirect(matrix, material, 0, MeshTopology::Triangles, buffer, 0,
                                          block));
    SAME("RasterCommandBuffer.DrawRendererList", rasterCmd.DrawRendererList(listHandle));
    SAME("RasterCommandBuffer.EnableKeyword", rasterCmd.EnableKeyword(globalKeyword));
    SAME("RasterCommandBuffer.EnableShaderKeyword", rasterCmd.EnableShaderKeyword("WET"));
    SAME("RasterCommandBuffer.EndSample", rasterCmd.EndSample("Blur"));
    SAME("RasterCommandBuffer.SetGlobalBuffer", rasterCmd.SetGlobalBuffer("_Points", buffer));
    SAME("RasterCommandBuffer.SetGlobalColor", rasterCmd.SetGlobalColor("_Tint", Color::red));
    SAME("RasterCommandBuffer.SetGlobalConstantBuffer",
         rasterCmd.SetGlobalConstantBuffer(buffer, "Params", 0, 16));
    SAME("RasterCommandBuffer.SetGlobalDepthBias", rasterCmd.SetGlobalDepthBias(1.0f, 2.0f));
    SAME("RasterCommandBuffer.SetGlobalFloat", rasterCmd.SetGlobalFloat(id, 1.0f));
    SAME("RasterCommandBuffer.SetGlobalFloat", rasterCmd.SetGlobalFloat("_Width", 1));
    SAME("RasterCommandBuffer.SetGlobalFloatArray", rasterCmd.SetGlobalFloatArray("_W", floats));
    SAME("RasterCommandBuffer.SetGlobalInt", rasterCmd.SetGlobalInt("_Count", 1));
    SAME("RasterCommandBuffer.SetGlobalInteger", rasterCmd.SetGlobalInteger("_Count", 1));
    SAME("RasterCommandBuffer.SetGlobalMatrix", rasterCmd.SetGlobalMatrix("_M", matrix));
    SAME("RasterCommandBuffer.SetGlobalMatrixArray",
         rasterCmd.SetGlobalMatrixArray("_M", matrices));
    SAME("RasterCommandBuffer.SetGlobalTexture", rasterCmd.SetGlobalTexture("_Mask", a));
    SAME("RasterCommandBuffer.SetGlobalVector", rasterCmd.SetGlobalVector(id, Vector4(1, 2, 3, 4)));
    SAME("RasterCommandBuffer.SetGlobalVector",
         rasterCmd.SetGlobalVector("_Offset", Vector2(1, 2)));
    SAME("RasterCommandBuffer.SetGlobalVector",
         rasterCmd.SetGlobalVector("_Offset", Vector3(1, 2, 3)));
    SAME("RasterCommandBuffer.SetGlobalVector", rasterCmd.SetGlobalVector("_Tint", Color::red));
    SAME("RasterCommandBuffer.SetGlobalVectorArray", rasterCmd.SetGlobalVectorArray("_V", vectors));
    SAME("RasterCommandBuffer.SetInvertCulling", rasterCmd.SetInvertCulling(true));
    SAME("RasterCommandBuffer.SetKeyword", rasterCmd.SetKeyword(globalKeyword, true));
    SAME("RasterCommandBuffer.SetProjectionMatrix", rasterCmd.SetProjectionMatrix(matrix));
    SAME("RasterCommandBuffer.SetViewMatrix", rasterCmd.SetViewMatrix(matrix));
    SAME("RasterCommandBuffer.SetViewProjectionMatrices",
         rasterCmd.SetViewProjectionMatrices(cameraData.GetViewMatrix(),
                                             cameraData.GetProjectionMatrix()));
    SAME("RenderingUtils", RenderingUtils::SupportsRenderTextureFormat(RenderTextureFormat::R8));
    SAME("RenderingUtils.CreateDrawingSettings",
         RenderingUtils::CreateDrawingSettings(tags, universalRenderingData, universalCameraData,
                                               universalLightData, SortingCriteria::CommonOpaque));
    SAME("RenderingUtils.SetViewAndProjectionMatrices",
         RenderingUtils::SetViewAndProjectionMatrices(cmd, cameraData.GetViewMatrix(),
                                                      cameraData.GetGPUProjectionMatrix(), false));
    SAME("RenderingUtils.SupportsGraphicsFormat",
         RenderingUtils::SupportsGraphicsFormat(GraphicsFormat::R8_UNorm, FormatUsage::Render));
    SAME("RenderingUtils.SupportsRenderTextureFormat",
         RenderingUtils::SupportsRenderTextureFormat(RenderTextureFormat::RHalf));
    SAME("ScriptableRenderContext", sizeof(ScriptableRenderContext));
    SAME("ScriptableRenderContext.CreateRendererList", context.CreateRendererList(listParams));
    SAME("ScriptableRenderContext.DrawRenderers",
         context.DrawRenderers(renderingData.cullResults, drawing, filtering));
    SAME("ScriptableRenderContext.DrawRenderers",
         context.DrawRenderers(renderingData.cullResults, drawing, filtering, stateBlock));
    SAME("ScriptableRenderContext.ExecuteCommandBuffer", context.ExecuteCommandBuffer(cmd));
    SAME("UnsafeCommandBuffer", sizeof(UnsafeCommandBuffer));
    SAME("UnsafeCommandBuffer.BeginSample", unsafeCmd.BeginSample("Blur"));
    SAME("UnsafeCommandBuffer.ClearRenderTarget",
         unsafeCmd.ClearRenderTarget(true, true, Color::clear));
    SAME("UnsafeCommandBuffer.ClearRenderTarget",
         unsafeCmd.ClearRenderTarget(RTClearFlags::ColorDepth, Color::black, 1.0f, 0));
    SAME("UnsafeCommandBuffer.CopyBuffer", unsafeCmd.CopyBuffer(buffer, buffer));
    SAME("UnsafeCommandBuffer.CopyCounterValue", unsafeCmd.CopyCounterValue(buffer, buffer, 0));
    SAME("UnsafeCommandBuffer.CopyTexture", unsafeCmd.CopyTexture(a, b));
    SAME("UnsafeCommandBuffer.DisableKeyword", unsafeCmd.DisableKeyword(globalKeyword));
    SAME("UnsafeCommandBuffer.DisableScissorRect", unsafeCmd.DisableScissorRect());
    SAME("UnsafeCommandBuffer.DisableShaderKeyword", unsafeCmd.DisableShaderKeyword("WET"));
    SAME("UnsafeCommandBuffer.DispatchCompute", unsafeCmd.DispatchCompute(compute, 0, 8, 8, 1));
    SAME("UnsafeCommandBuffer.DrawMesh", unsafeCmd.DrawMesh(mesh, matrix, material, 0, 0, block));
    SAME("UnsafeCommandBuffer.DrawMeshInstancedIndirect",
         unsafeCmd.DrawMeshInstancedIndirect(mesh, 0, material, 0, buffer, 0, block));
    SAME("UnsafeCommandBuffer.DrawMeshInstancedProcedural",
         unsafeCmd.DrawMeshInstancedProcedural(mesh, 0, material, 0, 10, block));
    SAME("UnsafeCommandBuffer.DrawMultipleMeshes",
         unsafeCmd.DrawMultipleMeshes(matrices, meshes, subMeshes, 1, material, 0, block));
    SAME("UnsafeCommandBuffer.DrawProcedural",
         unsafeCmd.DrawProcedural(matrix, material, 0, MeshTopology::Triangles, 3, 1, block));
    SAME("UnsafeCommandBuffer.DrawProceduralIndirect",
         unsafeCmd.DrawProceduralIndirect(matrix, material, 0, MeshTopology::Triangles, buffer, 0,
                                          block));
    SAME("UnsafeCommandBuffer.DrawRendererList", unsafeCmd.DrawRendererList(listHandle));
    SAME("UnsafeCommandBuffer.EnableKeyword", unsafeCmd.EnableKeyword(globalKeyword));
    SAME("UnsafeCommandBuffer.EnableShaderKeyword", unsafeCmd.EnableShaderKeyword("WET"));
    SAME("UnsafeCommandBuffer.EndSample", unsafeCmd.EndSample("Blur"));
    SAME("UnsafeCommandBuffer.GenerateMips", unsafeCmd.GenerateMips(a));
    SAME("UnsafeCommandBuffer.SetBufferCounterValue", unsafeCmd.SetBufferCounterValue(buffer, 0));
    SAME("UnsafeCommandBuffer.SetComputeBufferParam",
         unsafeCmd.SetComputeBufferParam(compute, 0, "_Points", buffer));
    SAME("UnsafeCommandBuffer.SetComputeConstantBufferParam",
         unsafeCmd.SetComputeConstantBufferParam(compute, "Params", buffer, 0, 16));
    SAME("UnsafeCommandBuffer.SetComputeFloatParam",
         unsafeCmd.SetComputeFloatParam(compute, "_Width", 1.0f));
    SAME("UnsafeCommandBuffer.SetComputeFloatParams",
         unsafeCmd.SetComputeFloatParams(compute, "_Size", 1.0f, 2.0f));
    SAME("UnsafeCommandBuffer.SetComputeIntParam",
         unsafeCmd.SetComputeIntParam(compute, "_Count", 1));
    SAME("UnsafeCommandBuffer.SetComputeIntParams",
         unsafeCmd.SetComputeIntParams(compute, "_Size", 1, 2));
    SAME("UnsafeCommandBuffer.SetComputeMatrixArrayParam",
         unsafeCmd.SetComputeMatrixArrayParam(compute, "_M", matrices));
    SAME("UnsafeCommandBuffer.SetComputeMatrixParam",
         unsafeCmd.SetComputeMatrixParam(compute, "_M", matrix));
    SAME("UnsafeCommandBuffer.SetComputeTextureParam",
         unsafeCmd.SetComputeTextureParam(compute, 0, "_Source", a));
    SAME("UnsafeCommandBuffer.SetComputeVectorArrayParam",
         unsafeCmd.SetComputeVectorArrayParam(compute, "_V", vectors));
    SAME("UnsafeCommandBuffer.SetComputeVectorParam",
         unsafeCmd.SetComputeVectorParam(compute, "_V", Vector4(1, 2, 3, 4)));
    SAME("UnsafeCommandBuffer.SetComputeVectorParam",
         unsafeCmd.SetComputeVectorParam(compute, "_V", Vector2(1, 2)));
    SAME("UnsafeCommandBuffer.SetGlobalBuffer", unsafeCmd.SetGlobalBuffer("_Points", buffer));
    SAME("UnsafeCommandBuffer.SetGlobalColor", unsafeCmd.SetGlobalColor("_Tint", Color::red));
    SAME("UnsafeCommandBuffer.SetGlobalConstantBuffer",
         unsafeCmd.SetGlobalConstantBuffer(buffer, "Params", 0, 16));
    SAME("UnsafeCommandBuffer.SetGlobalDepthBias", unsafeCmd.SetGlobalDepthBias(1.0f, 2.0f));
    SAME("UnsafeCommandBuffer.SetGlobalFloat", unsafeCmd.SetGlobalFloat(id, 1.0f));
    SAME("UnsafeCommandBuffer.SetGlobalFloat", unsafeCmd.SetGlobalFloat("_Width", 1));
    SAME("UnsafeCommandBuffer.SetGlobalFloatArray", unsafeCmd.SetGlobalFloatArray("_W", floats));
    SAME("UnsafeCommandBuffer.SetGlobalInt", unsafeCmd.SetGlobalInt("_Count", 1));
    SAME("UnsafeCommandBuffer.SetGlobalInteger", unsafeCmd.SetGlobalInteger("_Count", 1));
    SAME("UnsafeCommandBuffer.SetGlobalMatrix", unsafeCmd.SetGlobalMatrix("_M", matrix));
    SAME("UnsafeCommandBuffer.SetGlobalMatrixArray",
         unsafeCmd.SetGlobalMatrixArray("_M", matrices));
    SAME("UnsafeCommandBuffer.SetGlobalTexture", unsafeCmd.SetGlobalTexture("_Mask", a));
    SAME("UnsafeCommandBuffer.SetGlobalVector", unsafeCmd.SetGlobalVector(id, Vector4(1, 2, 3, 4)));
    SAME("UnsafeCommandBuffer.SetGlobalVector",
         unsafeCmd.SetGlobalVector("_Offset", Vector2(1, 2)));
    SAME("UnsafeCommandBuffer.SetGlobalVector",
         unsafeCmd.SetGlobalVector("_Offset", Vector3(1, 2, 3)));
    SAME("UnsafeCommandBuffer.SetGlobalVector", unsafeCmd.SetGlobalVector("_Tint", Color::red));
    SAME("UnsafeCommandBuffer.SetGlobalVectorArray", unsafeCmd.SetGlobalVectorArray("_V", vectors));
    SAME("UnsafeCommandBuffer.SetInvertCulling", unsafeCmd.SetInvertCulling(true));
    SAME("UnsafeCommandBuffer.SetKeyword", unsafeCmd.SetKeyword(globalKeyword, true));
    SAME("UnsafeCommandBuffer.SetProjectionMatrix", unsafeCmd.SetProjectionMatrix(matrix));
    SAME("UnsafeCommandBuffer.SetRenderTarget", unsafeCmd.SetRenderTarget(a));
    SAME("UnsafeCommandBuffer.SetRenderTarget", unsafeCmd.SetRenderTarget(a, b));
    SAME("UnsafeCommandBuffer.SetViewMatrix", unsafeCmd.SetViewMatrix(matrix));
    SAME("UnsafeCommandBuffer.SetViewProjectionMatrices",
         unsafeCmd.SetViewProjectionMatrices(cameraData.GetViewMatrix(),
                                             cameraData.GetProjectionMatrix()));
}

} // namespace limn::test
