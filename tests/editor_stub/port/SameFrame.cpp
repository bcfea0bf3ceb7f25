#include "port/Same.h"

namespace limn::test
{

// Never called: that they compile is the test.
void SameLines::Frame()
{
    SAME("AntialiasingMode", sizeof(AntialiasingMode));
    SAME("AntialiasingMode.FastApproximateAntialiasing",
         AntialiasingMode::FastApproximateAntialiasing);
    SAME("AntialiasingMode.None", AntialiasingMode::None);
    SAME("AsyncGPUReadbackRequest", sizeof(AsyncGPUReadbackRequest));
    SAME("AsyncGPUReadbackRequest.Update", request.Update());
    SAME("AsyncGPUReadbackRequest.WaitForCompletion", request.WaitForCompletion());
    SAME("BlendState.alphaToMask", BlendState().alphaToMask);
    SAME("BlendState.defaultValue", BlendState::defaultValue);
    SAME("BlendState.separateMRTBlendStates", BlendState().separateMRTBlendStates);
    SAME("BlitMaterialParameters", sizeof(RenderGraphUtils::BlitMaterialParameters));
    SAME("BufferDesc", sizeof(BufferDesc));
    SAME("BufferDesc.count", bufferDesc.count);
    SAME("BufferDesc.name", bufferDesc.name);
    SAME("BufferDesc.stride", bufferDesc.stride);
    SAME("BufferDesc.target", bufferDesc.target);
    SAME("BufferHandle", sizeof(BufferHandle));
    SAME("BufferHandle.IsValid", bufferHandle.IsValid());
    SAME("BufferHandle.nullHandle", BufferHandle::nullHandle);
    SAME("Camera", sizeof(Camera));
    SAME("Camera.CalculateObliqueMatrix", camera.CalculateObliqueMatrix(Vector4(0, 1, 0, 0), 1.5f));
    SAME("Camera.allowHDR", camera.allowHDR);
    SAME("Camera.allowMSAA", camera.allowMSAA);
    SAME("Camera.backgroundColor", camera.backgroundColor);
    SAME("Camera.cameraType", camera.cameraType);
    SAME("Camera.cameraType", (camera.cameraType & CameraType::Game) != 0);
    SAME("Camera.cameraType",
         (camera.cameraType & (CameraType::Game | CameraType::SceneView)) == CameraType::Game);
    SAME("Camera.clearFlags", camera.clearFlags);
    SAME("Camera.cullingMask", camera.cullingMask);
    SAME("Camera.depth", camera.depth);
    SAME("Camera.farClipPlane", camera.farClipPlane);
    SAME("Camera.fieldOfView", camera.fieldOfView);
    SAME("Camera.nearClipPlane", camera.nearClipPlane);
    SAME("Camera.opaqueSortMode", camera.opaqueSortMode);
    SAME("Camera.orthographic", camera.orthographic);
    SAME("Camera.orthographicSize", camera.orthographicSize);
    SAME("Camera.targetTexture", camera.targetTexture);
    SAME("Camera.transparencySortAxis", camera.transparencySortAxis);
    SAME("Camera.transparencySortMode", camera.transparencySortMode);
    SAME("CameraData", sizeof(CameraData));
    SAME("CameraData.GetGPUProjectionMatrix", cameraData.GetGPUProjectionMatrix());
    SAME("CameraData.GetProjectionMatrix", cameraData.GetProjectionMatrix());
    SAME("CameraData.GetProjectionMatrixNoJitter", cameraData.GetProjectionMatrixNoJitter());
    SAME("CameraData.GetViewMatrix", cameraData.GetViewMatrix());
    SAME("CameraData.IsCameraProjectionMatrixFlipped",
         cameraData.IsCameraProjectionMatrixFlipped());
    SAME("CameraData.IsHandleYFlipped", cameraData.IsHandleYFlipped(RTHandle()));
    SAME("CameraData.IsRenderTargetProjectionMatrixFlipped",
         cameraData.IsRenderTargetProjectionMatrixFlipped(RTHandle(), RTHandle()));
    SAME("CameraData.aspectRatio", cameraData.aspectRatio);
    SAME("CameraData.backgroundColor", cameraData.backgroundColor);
    SAME("CameraData.camera", cameraData.camera);
    SAME("CameraData.cameraTargetDescriptor", cameraData.cameraTargetDescriptor);
    SAME("CameraData.cameraType", cameraData.cameraType);
    SAME("CameraData.cameraType", (cameraData.cameraType & CameraType::Game) != 0);
    SAME("CameraData.clearDepth", cameraData.clearDepth);
    SAME("CameraData.defaultOpaqueSortFlags", cameraData.defaultOpaqueSortFlags);
    SAME("CameraData.isDefaultViewport", cameraData.isDefaultViewport);
    SAME("CameraData.isHdrEnabled", cameraData.isHdrEnabled);
    SAME("CameraData.maxShadowDistance", cameraData.maxShadowDistance);
    SAME("CameraData.pixelHeight", cameraData.pixelHeight);
    SAME("CameraData.pixelWidth", cameraData.pixelWidth);
    SAME("CameraData.antialiasing",
         cameraData.antialiasing == AntialiasingMode::FastApproximateAntialiasing);
    SAME("CameraData.postProcessEnabled", cameraData.postProcessEnabled);
    SAME("CameraData.renderScale", cameraData.renderScale);
    SAME("CameraData.renderType", cameraData.renderType);
    SAME("CameraData.renderer", cameraData.renderer);
    SAME("CameraData.resolveFinalTarget", cameraData.resolveFinalTarget);
    SAME("CameraData.targetTexture", cameraData.targetTexture);
    SAME("CameraData.volumeLayerMask", cameraData.volumeLayerMask);
    SAME("CameraData.worldSpaceCameraPos", cameraData.worldSpaceCameraPos);
    SAME("ComputeGraphContext", sizeof(ComputeGraphContext));
    SAME("ComputeGraphContext.cmd", computeContext.cmd);
    SAME("ContextContainer.Contains", frameData.Contains<UniversalResourceData>());
    SAME("ContextContainer.Create", frameData.Create<UniversalResourceData>());
    SAME("ContextContainer.Dispose", frameData.Dispose());
    SAME("ContextContainer.Get", frameData.Get<UniversalResourceData>());
    SAME("ContextContainer.GetOrCreate", frameData.GetOrCreate<UniversalResourceData>());
    SAME("ContextItem", sizeof(ContextItem));
    SAME("ContextItem.Reset", resourceData.Reset());
    SAME("CullingResults", sizeof(CullingResults));
    SAME("DepthState", sizeof(DepthState));
    SAME("DepthState.compareFunction", DepthState().compareFunction);
    SAME("DepthState.defaultValue", DepthState::defaultValue);
    SAME("DepthState.writeEnabled", DepthState().writeEnabled);
    SAME("DrawingSettings", sizeof(DrawingSettings));
    SAME("DrawingSettings.GetShaderPassName", drawing.GetShaderPassName(0));
    SAME("DrawingSettings.SetShaderPassName", drawing.SetShaderPassName(0, tag));
    SAME("DrawingSettings.enableDynamicBatching", drawing.enableDynamicBatching);
    SAME("DrawingSettings.enableInstancing", drawing.enableInstancing);
    SAME("DrawingSettings.fallbackMaterial", drawing.fallbackMaterial = material);
    SAME("DrawingSettings.mainLightIndex", drawing.mainLightIndex);
    SAME("DrawingSettings.maxShaderPasses", DrawingSettings::maxShaderPasses);
    SAME("DrawingSettings.overrideMaterial", drawing.overrideMaterial = material);
    SAME("DrawingSettings.overrideMaterialPassIndex", drawing.overrideMaterialPassIndex = 0);
    SAME("DrawingSettings.overrideShader", drawing.overrideShader = shader);
    SAME("DrawingSettings.overrideShaderPassIndex", drawing.overrideShaderPassIndex = 0);
    SAME("DrawingSettings.perObjectData", drawing.perObjectData);
    SAME("DrawingSettings.sortingSettings", drawing.sortingSettings);
    SAME("FilteringSettings.layerMask", filtering.layerMask);
    SAME("FilteringSettings.renderQueueRange", filtering.renderQueueRange);
    SAME("FilteringSettings.renderingLayerMask", filtering.renderingLayerMask);
    SAME("IComputeRenderGraphBuilder", sizeof(ComputeRenderGraphBuilder<PassData>));
    SAME("IComputeRenderGraphBuilder.AllowGlobalStateModification",
         computeBuilder.AllowGlobalStateModification(true));
    SAME("IComputeRenderGraphBuilder.AllowPassCulling", computeBuilder.AllowPassCulling(false));
    SAME("IComputeRenderGraphBuilder.CreateTransientBuffer",
         computeBuilder.CreateTransientBuffer(bufferDesc));
    SAME("IComputeRenderGraphBuilder.CreateTransientTexture",
         computeBuilder.CreateTransientTexture(textureDesc));
    SAME("IComputeRenderGraphBuilder.SetGlobalTextureAfterPass",
         computeBuilder.SetGlobalTextureAfterPass(textureHandle, "_Mask"));
    SAME("IComputeRenderGraphBuilder.SetRenderFunc",
         computeBuilder.SetRenderFunc([](PassData&, ComputeGraphContext&) {}));
    SAME("IComputeRenderGraphBuilder.UseAllGlobalTextures",
         computeBuilder.UseAllGlobalTextures(true));
    SAME("IComputeRenderGraphBuilder.UseBuffer",
         computeBuilder.UseBuffer(bufferHandle, AccessFlags::Write));
    SAME("IComputeRenderGraphBuilder.UseGlobalTexture", computeBuilder.UseGlobalTexture("_Mask"));
    SAME("IComputeRenderGraphBuilder.UseRendererList", computeBuilder.UseRendererList(listHandle));
    SAME("IComputeRenderGraphBuilder.UseTexture", computeBuilder.UseTexture(textureHandle));
    SAME("IPostProcessComponent", sizeof(IPostProcessComponent));
    SAME("IPostProcessComponent.IsActive", bloom.IsActive());
    SAME("IPostProcessComponent.IsTileCompatible", bloom.IsTileCompatible());
    SAME("IRasterRenderGraphBuilder", sizeof(RasterRenderGraphBuilder<PassData>));
    SAME("IRasterRenderGraphBuilder.CreateTransientBuffer",
         rasterBuilder.CreateTransientBuffer(bufferDesc));
    SAME("IRasterRenderGraphBuilder.CreateTransientTexture",
         rasterBuilder.CreateTransientTexture(textureDesc));
    SAME("IRasterRenderGraphBuilder.SetInputAttachment",
         rasterBuilder.SetInputAttachment(textureHandle, 0, AccessFlags::Read));
    SAME("IRasterRenderGraphBuilder.UseBuffer",
         rasterBuilder.UseBuffer(bufferHandle, AccessFlags::Write));
    SAME("IUnsafeRenderGraphBuilder", sizeof(UnsafeRenderGraphBuilder<PassData>));
    SAME("IUnsafeRenderGraphBuilder.CreateTransientBuffer",
         unsafeBuilder.CreateTransientBuffer(bufferDesc));
    SAME("IUnsafeRenderGraphBuilder.CreateTransientTexture",
         unsafeBuilder.CreateTransientTexture(textureDesc));
    SAME("IUnsafeRenderGraphBuilder.SetRenderAttachment",
         unsafeBuilder.SetRenderAttachment(textureHandle, 0));
    SAME("IUnsafeRenderGraphBuilder.SetRenderAttachmentDepth",
         unsafeBuilder.SetRenderAttachmentDepth(textureHandle, AccessFlags::Read));
    SAME("IUnsafeRenderGraphBuilder.UseBuffer",
         unsafeBuilder.UseBuffer(bufferHandle, AccessFlags::Write));
    SAME("ImportResourceParams", sizeof(ImportResourceParams));
    SAME("ImportResourceParams.clearColor", importParams.clearColor);
    SAME("ImportResourceParams.clearOnFirstUse", importParams.clearOnFirstUse);
    SAME("LightData", sizeof(LightData));
    SAME("LightData.additionalLightsCount", renderingData.lightData.additionalLightsCount);
    SAME("LightData.mainLightIndex", renderingData.lightData.mainLightIndex);
    SAME("LightData.maxPerObjectAdditionalLightsCount",
         renderingData.lightData.maxPerObjectAdditionalLightsCount);
    SAME("LightData.shadeAdditionalLightsPerVertex",
         renderingData.lightData.shadeAdditionalLightsPerVertex);
    SAME("LightData.supportsAdditionalLights", renderingData.lightData.supportsAdditionalLights);
    SAME("LightData.supportsLightLayers", renderingData.lightData.supportsLightLayers);
    SAME("ProfilingSampler", sizeof(ProfilingSampler));
    SAME("ProfilingSampler.Begin", sampler.Begin(cmd));
    SAME("ProfilingSampler.End", sampler.End(cmd));
    SAME("RTHandle", sizeof(RTHandle));
    SAME("RTHandle.GetScaledSize", a.GetScaledSize(Vector2Int(8, 4)));
    SAME("RTHandleProperties", sizeof(RTHandleProperties));
    SAME("RTHandleProperties.currentRenderTargetSize",
         RTHandleProperties().currentRenderTargetSize);
    SAME("RTHandleProperties.currentViewportSize", RTHandleProperties().currentViewportSize);
    SAME("RTHandleProperties.previousRenderTargetSize",
         RTHandleProperties().previousRenderTargetSize);
    SAME("RTHandleProperties.previousViewportSize", RTHandleProperties().previousViewportSize);
    SAME("RTHandleProperties.rtHandleScale", RTHandleProperties().rtHandleScale);
    SAME("RTHandles", RTHandles::Alloc(descriptor));
    SAME("RTHandles.Alloc",
         RTHandles::Alloc(descriptor, FilterMode::Bilinear, TextureWrapMode::Clamp, "_Mask"));
    SAME("RTHandles.Alloc", RTHandles::Alloc(Vector2(0.5f, 0.5f), descriptor));
    SAME("RTHandles.Alloc", RTHandles::Alloc("_Name"));
    SAME("RTHandles.Initialize", RTHandles::Initialize(8, 4));
    SAME("RTHandles.Release", RTHandles::Release(a));
    SAME("RTHandles.ResetReferenceSize", RTHandles::ResetReferenceSize(8, 4));
    SAME("RTHandles.SetReferenceSize", RTHandles::SetReferenceSize(8, 4));
    SAME("RasterGraphContext", sizeof(RasterGraphContext));
    SAME("RasterGraphContext.cmd", rasterContext.cmd);
    SAME("RasterState", sizeof(RasterState));
    SAME("RasterState.conservative", RasterState().conservative);
    SAME("RasterState.cullingMode", RasterState().cullingMode);
    SAME("RasterState.defaultValue", RasterState::defaultValue);
    SAME("RasterState.depthClip", RasterState().depthClip);
    SAME("RasterState.offsetFactor", RasterState().offsetFactor);
    SAME("RasterState.offsetUnits", RasterState().offsetUnits);
    SAME("RenderGraph.AddBlitPass",
         renderGraph.AddBlitPass({textureHandle, textureHandle, material, 0}, "Blit"));
    SAME("RenderGraph.AddBlitPass",
         renderGraph.AddBlitPass(textureHandle, textureHandle, Vector2(1, 1), Vector2(0, 0)));
    SAME("RenderGraph.AddComputePass", renderGraph.AddComputePass<PassData>("Compute", passData));
    SAME("RenderGraph.AddCopyPass", renderGraph.AddCopyPass(textureHandle, textureHandle));
    SAME("RenderGraph.CreateBuffer", renderGraph.CreateBuffer(bufferDesc));
    SAME("RenderGraph.CreateRendererList", renderGraph.CreateRendererList(listParams));
    SAME("RenderGraph.CreateRendererList", renderGraph.CreateRendererList(listDesc));
    SAME("RenderGraph.CreateTexture", renderGraph.CreateTexture(textureDesc));
    SAME("RenderGraph.CreateTexture", renderGraph.CreateTexture(textureHandle));
    SAME("RenderGraph.CreateTexture", renderGraph.CreateTexture(textureHandle, "_Copy"));
    SAME("RenderGraph.CreateTexture", renderGraph.CreateTexture(textureHandle, "_Copy", true));
    SAME("RenderGraph.CreateTextureIfInvalid",
         renderGraph.CreateTextureIfInvalid(textureDesc, textureHandle));
    SAME("RenderGraph.GetBufferDesc", renderGraph.GetBufferDesc(bufferHandle));
    SAME("RenderGraph.GetRenderTargetInfo", renderGraph.GetRenderTargetInfo(textureHandle));
    SAME("RenderGraph.GetTextureDesc", renderGraph.GetTextureDesc(textureHandle));
    SAME("RenderGraph.ImportBuffer", renderGraph.ImportBuffer(buffer));
    SAME("RenderGraph.ImportTexture", renderGraph.ImportTexture(a));
    SAME("RenderGraph.ImportTexture", renderGraph.ImportTexture(a, importParams));
    SAME("RenderGraphUtils", RenderGraphUtils::BlitFilterMode::ClampBilinear);
    RenderGraphUtils::BlitMaterialParameters blit(textureHandle, textureHandle, material, 0);
    SAME("RenderGraphUtils.BlitMaterialParameters.source", blit.source = textureHandle);
    SAME("RenderGraphUtils.BlitMaterialParameters.destination", blit.destination = textureHandle);
    SAME("RenderGraphUtils.BlitMaterialParameters.scale", blit.scale = Vector2(1, 1));
    SAME("RenderGraphUtils.BlitMaterialParameters.offset", blit.offset = Vector2(0, 0));
    SAME("RenderGraphUtils.BlitMaterialParameters.material", blit.material = material);
    SAME("RenderGraphUtils.BlitMaterialParameters.shaderPass", blit.shaderPass = 1);
    SAME("RenderGraphUtils.BlitMaterialParameters.sourceTexturePropertyID",
         blit.sourceTexturePropertyID = Shader::PropertyToID("_Source"));
    SAME("RenderGraphUtils.BlitFilterMode", RenderGraphUtils::BlitFilterMode::ClampNearest);
    SAME("RenderGraphUtils.BlitMaterialParameters",
         RenderGraphUtils::BlitMaterialParameters(textureHandle, textureHandle, material, 0));
    SAME("RenderQueueRange", sizeof(RenderQueueRange));
    SAME("RenderQueueRange.all", RenderQueueRange::all);
    SAME("RenderQueueRange.maximumBound", RenderQueueRange::maximumBound);
    SAME("RenderQueueRange.minimumBound", RenderQueueRange::minimumBound);
    SAME("RenderQueueRange.opaque", RenderQueueRange::opaque);
    SAME("RenderQueueRange.transparent", RenderQueueRange::transparent);
    SAME("RenderStateBlock", sizeof(RenderStateBlock));
    SAME("RenderStateBlock.blendState", stateBlock.blendState);
    SAME("RenderStateBlock.depthState", stateBlock.depthState);
    SAME("RenderStateBlock.mask", stateBlock.mask);
    SAME("RenderStateBlock.rasterState", stateBlock.rasterState);
    SAME("RenderStateBlock.stencilReference", stateBlock.stencilReference);
    SAME("RenderStateBlock.stencilState", stateBlock.stencilState);
    SAME("RenderTargetHandle", sizeof(RenderTargetHandle));
    SAME("RenderTargetHandle.CameraTarget", RenderTargetHandle::CameraTarget);
    SAME("RenderTargetHandle.Identifier", handle.Identifier());
    SAME("RenderTargetHandle.Init", handle.Init("_Mask"));
    SAME("RenderTargetHandle.id", handle.id);
    SAME("RenderTargetIdentifier", sizeof(RenderTargetIdentifier));
    SAME("RenderTextureDescriptor", sizeof(RenderTextureDescriptor));
    SAME("RenderTextureDescriptor.autoGenerateMips", descriptor.autoGenerateMips);
    SAME("RenderTextureDescriptor.depthBufferBits", descriptor.depthBufferBits);
    SAME("RenderTextureDescriptor.enableRandomWrite", descriptor.enableRandomWrite);
    SAME("RenderTextureDescriptor.graphicsFormat", descriptor.graphicsFormat);
    SAME("RenderTextureDescriptor.height", descriptor.height);
    SAME("RenderTextureDescriptor.memoryless", descriptor.memoryless);
    SAME("RenderTextureDescriptor.mipCount", descriptor.mipCount);
    SAME("RenderTextureDescriptor.msaaSamples", descriptor.msaaSamples);
    SAME("RenderTextureDescriptor.shadowSamplingMode", descriptor.shadowSamplingMode);
    SAME("RenderTextureDescriptor.useDynamicScale", descriptor.useDynamicScale);
    SAME("RenderTextureDescriptor.useMipMap", descriptor.useMipMap);
    SAME("RenderTextureDescriptor.width", descriptor.width);
    SAME("RendererList", sizeof(RendererList));
    SAME("RendererListDesc", sizeof(RendererListDesc));
    SAME("RendererListDesc.IsValid", listDesc.IsValid());
    SAME("RendererListDesc.layerMask", listDesc.layerMask);
    SAME("RendererListDesc.overrideMaterial", listDesc.overrideMaterial);
    SAME("RendererListDesc.overrideMaterialPassIndex", listDesc.overrideMaterialPassIndex);
    SAME("RendererListDesc.overrideShader", listDesc.overrideShader);
    SAME("RendererListDesc.overrideShaderPassIndex", listDesc.overrideShaderPassIndex);
    SAME("RendererListDesc.renderQueueRange", listDesc.renderQueueRange);
    SAME("RendererListDesc.renderingLayerMask", listDesc.renderingLayerMask);
    SAME("RendererListDesc.sortingCriteria", listDesc.sortingCriteria);
    SAME("RendererListDesc.stateBlock", listDesc.stateBlock);
    SAME("RendererListHandle", sizeof(RendererListHandle));
    SAME("RendererListHandle.IsValid", listHandle.IsValid());
    SAME("RendererListHandle.nullHandle", RendererListHandle::nullHandle);
    SAME("RendererListParams", sizeof(RendererListParams));
    SAME("RendererListParams.drawSettings", listParams.drawSettings);
    SAME("RendererListParams.filteringSettings", listParams.filteringSettings);
    SAME("RenderingData", sizeof(RenderingData));
    SAME("RenderingData.cameraData", renderingData.cameraData);
    SAME("RenderingData.cullResults", renderingData.cullResults);
    SAME("RenderingData.lightData", renderingData.lightData);
    SAME("RenderingData.postProcessingEnabled", renderingData.postProcessingEnabled);
    SAME("RenderingData.shadowData", renderingData.shadowData);
    SAME("ScriptableRenderPass", sizeof(ScriptableRenderPass));
    SAME("ScriptableRenderPass.Blit", pass.Blit(cmd, a, b, material, 0));
    SAME("ScriptableRenderPass.Configure", pass.Configure(cmd, descriptor));
    SAME("ScriptableRenderPass.ConfigureClear", pass.ConfigureClear(ClearFlag::All, Color::clear));
    SAME("ScriptableRenderPass.ConfigureColorStoreActions",
         pass.ConfigureColorStoreActions(storeActions));
    SAME("ScriptableRenderPass.ConfigureInput",
         pass.ConfigureInput(ScriptableRenderPassInput::Depth | ScriptableRenderPassInput::Normal));
    SAME("ScriptableRenderPass.CreateDrawingSettings",
         pass.CreateDrawingSettings(tags, renderingData, SortingCriteria::CommonOpaque));
    SAME("ScriptableRenderPass.Execute", pass.Execute(context, renderingData));
    SAME("ScriptableRenderPass.FrameCleanup", pass.FrameCleanup(cmd));
    SAME("ScriptableRenderPass.OnCameraCleanup", pass.OnCameraCleanup(cmd));
    SAME("ScriptableRenderPass.OnCameraSetup", pass.OnCameraSetup(cmd, renderingData));
    SAME("ScriptableRenderPass.OnFinishCameraStackRendering",
         pass.OnFinishCameraStackRendering(cmd));
    SAME("ScriptableRenderPass.ResetTarget", pass.ResetTarget());
    SAME("ScriptableRenderPass.renderPassEvent",
         pass.renderPassEvent = RenderPassEvent::AfterRenderingOpaques + 1);
    SAME("ScriptableRenderer", sizeof(ScriptableRenderer));
    SAME("ScriptableRenderer.EnqueuePass", cameraData.renderer->EnqueuePass(pass));
    SAME("ScriptableRenderer.SetCameraMatrices",
         ScriptableRenderer::SetCameraMatrices(cmd, cameraData, false));
    SAME("ScriptableRendererFeature", sizeof(ScriptableRendererFeature));
    SAME("ScriptableRendererFeature.AddRenderPasses",
         feature.AddRenderPasses(*cameraData.renderer, renderingData));
    SAME("ScriptableRendererFeature.Create", feature.Create());
    SAME("ScriptableRendererFeature.Dispose", feature.Dispose());
    SAME("ScriptableRendererFeature.SetActive", feature.SetActive(false));
    SAME("ScriptableRendererFeature.SetupRenderPasses",
         feature.SetupRenderPasses(*cameraData.renderer, renderingData));
    SAME("ScriptableRendererFeature.name", feature.name);
    SAME("ShaderTagId", sizeof(ShaderTagId));
    SAME("ShadowData", sizeof(ShadowData));
    SAME("ShadowData.additionalLightsShadowmapHeight",
         renderingData.shadowData.additionalLightsShadowmapHeight);
    SAME("ShadowData.additionalLightsShadowmapWidth",
         renderingData.shadowData.additionalLightsShadowmapWidth);
    SAME("ShadowData.mainLightShadowCascadeBorder",
         renderingData.shadowData.mainLightShadowCascadeBorder);
    SAME("ShadowData.mainLightShadowCascadesCount",
         renderingData.shadowData.mainLightShadowCascadesCount);
    SAME("ShadowData.mainLightShadowCascadesSplit",
         renderingData.shadowData.mainLightShadowCascadesSplit);
    SAME("ShadowData.mainLightShadowmapHeight", renderingData.shadowData.mainLightShadowmapHeight);
    SAME("ShadowData.mainLightShadowmapWidth", renderingData.shadowData.mainLightShadowmapWidth);
    SAME("ShadowData.supportsAdditionalLightShadows",
         renderingData.shadowData.supportsAdditionalLightShadows);
    SAME("ShadowData.supportsMainLightShadows", renderingData.shadowData.supportsMainLightShadows);
    SAME("ShadowData.supportsSoftShadows", renderingData.shadowData.supportsSoftShadows);
    SAME("SortingSettings", sizeof(SortingSettings));
    SAME("SortingSettings.cameraPosition", sorting.cameraPosition);
    SAME("SortingSettings.criteria", sorting.criteria);
    SAME("SortingSettings.customAxis", sorting.customAxis);
    SAME("SortingSettings.distanceMetric", sorting.distanceMetric);
    SAME("StencilState.SetCompareFunction", stencil.SetCompareFunction(CompareFunction::Equal));
    SAME("StencilState.SetFailOperation", stencil.SetFailOperation(StencilOp::Keep));
    SAME("StencilState.SetPassOperation", stencil.SetPassOperation(StencilOp::Keep));
    SAME("StencilState.SetZFailOperation", stencil.SetZFailOperation(StencilOp::Keep));
    SAME("StencilState.defaultValue", StencilState::defaultValue);
    SAME("StencilState.enabled", StencilState().enabled);
    SAME("StencilState.readMask", StencilState().readMask);
    SAME("StencilState.writeMask", StencilState().writeMask);
    SAME("TextureDesc", sizeof(TextureDesc));
    SAME("TextureDesc.anisoLevel", textureDesc.anisoLevel);
    SAME("TextureDesc.autoGenerateMips", textureDesc.autoGenerateMips);
    SAME("TextureDesc.clearBuffer", textureDesc.clearBuffer);
    SAME("TextureDesc.clearColor", textureDesc.clearColor);
    SAME("TextureDesc.depthBufferBits", textureDesc.depthBufferBits);
    SAME("TextureDesc.depthBufferBits", textureDesc.depthBufferBits = 0);
    SAME("TextureDesc.depthBufferBits", textureDesc.depthBufferBits = DepthBits::Depth32);
    SAME("TextureDesc.discardBuffer", textureDesc.discardBuffer);
    SAME("TextureDesc.enableRandomWrite", textureDesc.enableRandomWrite);
    SAME("TextureDesc.fallBackToBlackTexture", textureDesc.fallBackToBlackTexture);
    SAME("TextureDesc.filterMode", textureDesc.filterMode);
    SAME("TextureDesc.format", textureDesc.format);
    SAME("TextureDesc.func", textureDesc.func);
    SAME("TextureDesc.height", textureDesc.height);
    SAME("TextureDesc.memoryless", textureDesc.memoryless);
    SAME("TextureDesc.mipMapBias", textureDesc.mipMapBias);
    SAME("TextureDesc.msaaSamples", textureDesc.msaaSamples);
    SAME("TextureDesc.name", textureDesc.name);
    SAME("TextureDesc.scale", textureDesc.scale);
    SAME("TextureDesc.sizeMode", textureDesc.sizeMode);
    SAME("TextureDesc.useDynamicScale", textureDesc.useDynamicScale);
    SAME("TextureDesc.useMipMap", textureDesc.useMipMap);
    SAME("TextureDesc.width", textureDesc.width);
    SAME("TextureDesc.wrapMode", textureDesc.wrapMode);
    SAME("TextureHandle", sizeof(TextureHandle));
    SAME("TextureHandle.GetDescriptor", textureHandle.GetDescriptor(renderGraph));
    SAME("TextureHandle.IsValid", textureHandle.IsValid());
    SAME("TextureHandle.nullHandle", TextureHandle::nullHandle);
    SAME("UniversalCameraData", sizeof(UniversalCameraData));
    SAME("UniversalCameraData.GetGPUProjectionMatrix",
         universalCameraData.GetGPUProjectionMatrix());
    SAME("UniversalCameraData.GetGPUProjectionMatrixNoJitter",
         universalCameraData.GetGPUProjectionMatrixNoJitter());
    SAME("UniversalCameraData.GetProjectionMatrix", universalCameraData.GetProjectionMatrix());
    SAME("UniversalCameraData.GetViewMatrix", universalCameraData.GetViewMatrix());
    SAME("UniversalCameraData.IsCameraProjectionMatrixFlipped",
         universalCameraData.IsCameraProjectionMatrixFlipped());
    SAME("UniversalCameraData.IsHandleYFlipped", universalCameraData.IsHandleYFlipped(RTHandle()));
    SAME("UniversalCameraData.IsRenderTargetProjectionMatrixFlipped",
         universalCameraData.IsRenderTargetProjectionMatrixFlipped(RTHandle(), RTHandle()));
    SAME("UniversalCameraData.aspectRatio", universalCameraData.aspectRatio);
    SAME("UniversalCameraData.backgroundColor", universalCameraData.backgroundColor);
    SAME("UniversalCameraData.camera", universalCameraData.camera);
    SAME("UniversalCameraData.cameraTargetDescriptor", universalCameraData.cameraTargetDescriptor);
    SAME("UniversalCameraData.cameraType", universalCameraData.cameraType);
    SAME("UniversalCameraData.clearDepth", universalCameraData.clearDepth);
    SAME("UniversalCameraData.defaultOpaqueSortFlags", universalCameraData.defaultOpaqueSortFlags);
    SAME("UniversalCameraData.isDefaultViewport", universalCameraData.isDefaultViewport);
    SAME("UniversalCameraData.isHdrEnabled", universalCameraData.isHdrEnabled);
    SAME("UniversalCameraData.maxShadowDistance", universalCameraData.maxShadowDistance);
    SAME("UniversalCameraData.pixelHeight", universalCameraData.pixelHeight);
    SAME("UniversalCameraData.pixelWidth", universalCameraData.pixelWidth);
    SAME("UniversalCameraData.antialiasing",
         universalCameraData.antialiasing == AntialiasingMode::None);
    SAME("UniversalCameraData.postProcessEnabled", universalCameraData.postProcessEnabled);
    SAME("UniversalCameraData.renderScale", universalCameraData.renderScale);
    SAME("UniversalCameraData.renderType", universalCameraData.renderType);
    SAME("UniversalCameraData.renderer", universalCameraData.renderer);
    SAME("UniversalCameraData.resolveFinalTarget", universalCameraData.resolveFinalTarget);
    SAME("UniversalCameraData.targetTexture", universalCameraData.targetTexture);
    SAME("UniversalCameraData.volumeLayerMask", universalCameraData.volumeLayerMask);
    SAME("UniversalCameraData.worldSpaceCameraPos", universalCameraData.worldSpaceCameraPos);
    SAME("UniversalLightData", sizeof(UniversalLightData));
    SAME("UniversalLightData.Reset", universalLightData.Reset());
    SAME("UniversalLightData.additionalLightsCount", universalLightData.additionalLightsCount);
    SAME("UniversalLightData.mainLightIndex", universalLightData.mainLightIndex);
    SAME("UniversalLightData.maxPerObjectAdditionalLightsCount",
         universalLightData.maxPerObjectAdditionalLightsCount);
    SAME("UniversalLightData.shadeAdditionalLightsPerVertex",
         universalLightData.shadeAdditionalLightsPerVertex);
    SAME("UniversalLightData.supportsAdditionalLights",
         universalLightData.supportsAdditionalLights);
    SAME("UniversalLightData.supportsLightLayers", universalLightData.supportsLightLayers);
    SAME("UniversalRenderingData.Reset", universalRenderingData.Reset());
    SAME("UniversalResourceData", sizeof(UniversalResourceData));
    SAME("UniversalResourceData.Reset", resourceData.Reset());
    SAME("UniversalResourceData.additionalShadowsTexture", resourceData.additionalShadowsTexture);
    SAME("UniversalResourceData.cameraColor", resourceData.cameraColor);
    SAME("UniversalResourceData.cameraDepth", resourceData.cameraDepth);
    SAME("UniversalResourceData.cameraDepthTexture", resourceData.cameraDepthTexture);
    SAME("UniversalResourceData.cameraNormalsTexture", resourceData.cameraNormalsTexture);
    SAME("UniversalResourceData.cameraOpaqueTexture", resourceData.cameraOpaqueTexture);
    SAME("UniversalResourceData.mainShadowsTexture", resourceData.mainShadowsTexture);
    SAME("UniversalShadowData", sizeof(UniversalShadowData));
    SAME("UniversalShadowData.additionalLightsShadowmapHeight",
         universalShadowData.additionalLightsShadowmapHeight);
    SAME("UniversalShadowData.additionalLightsShadowmapWidth",
         universalShadowData.additionalLightsShadowmapWidth);
    SAME("UniversalShadowData.mainLightShadowCascadeBorder",
         universalShadowData.mainLightShadowCascadeBorder);
    SAME("UniversalShadowData.mainLightShadowCascadesCount",
         universalShadowData.mainLightShadowCascadesCount);
    SAME("UniversalShadowData.mainLightShadowCascadesSplit",
         universalShadowData.mainLightShadowCascadesSplit);
    SAME("UniversalShadowData.mainLightShadowmapHeight",
         universalShadowData.mainLightShadowmapHeight);
    SAME("UniversalShadowData.mainLightShadowmapWidth",
         universalShadowData.mainLightShadowmapWidth);
    SAME("UniversalShadowData.supportsAdditionalLightShadows",
         universalShadowData.supportsAdditionalLightShadows);
    SAME("UniversalShadowData.supportsMainLightShadows",
         universalShadowData.supportsMainLightShadows);
    SAME("UniversalShadowData.supportsSoftShadows", universalShadowData.supportsSoftShadows);
    SAME("UnsafeGraphContext", sizeof(UnsafeGraphContext));
    SAME("UnsafeGraphContext.cmd", unsafeContext.cmd);
    SAME("Vector2", sizeof(Vector2));
    SAME("Vector2Int", sizeof(Vector2Int));
    SAME("Vector3", sizeof(Vector3));
    SAME("Vector3Int", sizeof(Vector3Int));
    SAME("Vector4", sizeof(Vector4));
    SAME("Volume", sizeof(Volume));
    SAME("VolumeComponent", sizeof(VolumeComponent));
    SAME("VolumeComponent.AnyPropertiesIsOverridden", component.AnyPropertiesIsOverridden());
    SAME("VolumeComponent.Override", component.Override(component, 1.0f));
    SAME("VolumeComponent.SetAllOverridesTo", component.SetAllOverridesTo(true));
    SAME("VolumeComponent.active", component.active = true);
    SAME("VolumeComponent.displayName", component.displayName = "Glow");
    SAME("VolumeManager.CreateStack", volumes.CreateStack());
    SAME("VolumeManager.GetVolumes", volumes.GetVolumes(LayerMask::Everything()));
    SAME("VolumeManager.IsComponentActiveInMask",
         volumes.IsComponentActiveInMask<Bloom>(LayerMask::Everything()));
    SAME("VolumeManager.Register", volumes.Register(&volume));
    SAME("VolumeManager.Unregister", volumes.Unregister(&volume));
    SAME("VolumeManager.Update", volumes.Update(stack, Vector3(0), LayerMask::Everything()));
    SAME("VolumeParameter.Interp", parameter.Interp(0.0f, 1.0f, 0.5f));
    SAME("VolumeParameter.Override", parameter.Override(1.0f));
    SAME("VolumeParameter.SetValue", parameter.SetValue(1.0f));
    SAME("VolumeProfile", sizeof(VolumeProfile));
}

} // namespace limn::test
