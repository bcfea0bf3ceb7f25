using System;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

// URP 14: an RTHandle, Blitter, references to parts of the frame's data, SetupRenderPasses.
internal class SharpenFeature : ScriptableRendererFeature
{
    public Shader m_Shader;
    [Range(0f, 2f)] public float m_Intensity = 0.5f;
    public bool m_SceneView = false;

    Material m_Material;
    SharpenPass m_RenderPass = null;

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        if (ShouldSkip(ref renderingData.cameraData)) return;
        renderer.EnqueuePass(m_RenderPass);
    }

    bool ShouldSkip(ref CameraData cameraData)
    {
        return cameraData.cameraType != CameraType.Game && !m_SceneView;
    }

    public override void SetupRenderPasses(ScriptableRenderer renderer, in RenderingData renderingData)
    {
        if (renderingData.cameraData.cameraType == CameraType.Game)
        {
            m_RenderPass.ConfigureInput(ScriptableRenderPassInput.Color);
            m_RenderPass.SetTarget(renderer.cameraColorTargetHandle, m_Intensity);
        }
    }

    public override void Create()
    {
        m_Material = CoreUtils.CreateEngineMaterial(m_Shader);
        m_RenderPass = new SharpenPass(m_Material);
    }

    protected override void Dispose(bool disposing)
    {
        m_RenderPass?.Dispose();
        CoreUtils.Destroy(m_Material);
    }
}

internal class SharpenPass : ScriptableRenderPass, IDisposable
{
    ProfilingSampler m_ProfilingSampler = new ProfilingSampler("Sharpen");
    Material m_Material;
    RTHandle m_CameraColorTarget;
    RTHandle m_Copy;
    float m_Intensity;

    public SharpenPass(Material material)
    {
        m_Material = material;
        renderPassEvent = RenderPassEvent.BeforeRenderingPostProcessing;
    }

    public void SetTarget(RTHandle colorHandle, float intensity)
    {
        m_CameraColorTarget = colorHandle;
        m_Intensity = intensity;
    }

    public override void OnCameraSetup(CommandBuffer cmd, ref RenderingData renderingData)
    {
        ref CameraData cameraData = ref renderingData.cameraData;
        var desc = cameraData.cameraTargetDescriptor;
        desc.depthBufferBits = (int)DepthBits.None;
        RenderingUtils.ReAllocateIfNeeded(ref m_Copy, desc, FilterMode.Bilinear, TextureWrapMode.Clamp, name: "_SharpenCopy");
        ConfigureTarget(m_CameraColorTarget);
    }

    public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
    {
        ref var cameraData = ref renderingData.cameraData;
        if (cameraData.camera.cameraType != CameraType.Game || m_Material == null) return;
        CommandBuffer cmd = CommandBufferPool.Get();
        using (new ProfilingScope(cmd, m_ProfilingSampler))
        {
            m_Material.SetFloat("_Intensity", m_Intensity);
            Blitter.BlitCameraTexture(cmd, m_CameraColorTarget, m_Copy);
            Blitter.BlitCameraTexture(cmd, m_Copy, m_CameraColorTarget, m_Material, 0);
        }
        context.ExecuteCommandBuffer(cmd);
        cmd.Clear();
        CommandBufferPool.Release(cmd);
    }

    public bool TryGetCopy(out RTHandle copy, ref float intensity)
    {
        copy = m_Copy;
        intensity += m_Intensity;
        return copy != null;
    }

    public void Dispose()
    {
        m_Copy?.Release();
    }
}
