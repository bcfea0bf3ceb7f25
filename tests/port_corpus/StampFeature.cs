using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

// URP 14: meshes with property blocks, numbers in a class of constants, helpers in static classes.
public static class StampPasses
{
    public const int Draw = 0;
    public const int Erase = 1;
    public const float MaxAge = 12.5f;
    public const string Tag = "Stamps";
}

internal static class StampIds
{
    internal static readonly int Tint = Shader.PropertyToID("_Tint");
    internal static readonly int Age = Shader.PropertyToID("_Age");
    internal static int Custom;
}

public static class StampExtensions
{
    public static float Fade(this Stamp stamp, float now) => Mathf.Clamp01((now - stamp.born) / StampPasses.MaxAge);

    public static void SetTint(this MaterialPropertyBlock block, int id, Color tint)
    {
        block.SetColor(id, tint);
    }

    public static T Last<T>(this List<T> list) => list[list.Count - 1];
}

[Serializable]
public struct Stamp
{
    public Vector3 position;
    public float size;
    [NonSerialized] public float born;
    public Color tint;
}

public class StampFeature : ScriptableRendererFeature
{
    [Serializable]
    public class Settings
    {
        public Mesh mesh;
        public Material material;
        public List<Stamp> stamps = new List<Stamp>();
        public Stamp first;
        [Range(StampPasses.Draw, 8)] public int layers = StampPasses.Erase;
        public float maxAge = StampPasses.MaxAge;
    }

    public Settings settings = new Settings();
    StampPass pass;

    public override void Create() { pass = new StampPass(settings, StampIds.Age, RenderPassEvent.AfterRenderingOpaques); }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        if (settings.material == null || settings.mesh == null || settings.stamps.Count == 0)
            return;
        renderer.EnqueuePass(pass);
    }

    sealed class StampPass : ScriptableRenderPass
    {
        const int k_Batch = 1023;
        readonly Settings settings;
        readonly int ageId;
        readonly MaterialPropertyBlock block = new MaterialPropertyBlock();
        readonly Matrix4x4[] matrices = new Matrix4x4[k_Batch];
        readonly float[] ages = new float[k_Batch];
        static int s_Count = 0;

        internal StampPass(Settings settings, int ageId, RenderPassEvent passEvent = RenderPassEvent.AfterRenderingOpaques)
        {
            (this.settings, this.ageId) = (settings, ageId);
            renderPassEvent = passEvent;
            profilingSampler = new ProfilingSampler(StampPasses.Tag);
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData data)
        {
            var cmd = CommandBufferPool.Get();
            using (new ProfilingScope(cmd, profilingSampler))
            {
                int count = Mathf.Min(settings.stamps.Count, k_Batch);
                for (int i = 0; i < count; i++)
                {
                    Stamp stamp = settings.stamps[i];
                    matrices[i] = Matrix4x4.TRS(stamp.position, Quaternion.identity, Vector3.one * stamp.size);
                    ages[i] = stamp.Fade(Time.time);
                }
                block.SetFloatArray(ageId, ages);
                block.SetTint(StampIds.Tint, settings.first.tint);
                cmd.DrawMeshInstanced(settings.mesh, 0, settings.material, StampPasses.Draw, matrices, count, block);
                cmd.DrawMesh(settings.mesh, Place(settings.first, out var isVisible), settings.material, 0, StampPasses.Erase, block);
                s_Count += count;
            }
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }

        static Matrix4x4 Place(in Stamp stamp, out bool isVisible)
        {
            isVisible = stamp.size > 0;
            return Matrix4x4.Translate(stamp.position);
        }
    }
}
