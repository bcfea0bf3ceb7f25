#pragma once

// Declares the types that a program's own headers name, and includes nothing: a header with a
// `limn::Scene&` costs as little as this one. Source files include <limn/limn.h>, or the header of
// the type, which has the type's name.

namespace limn
{

// <limn/core/…>
class CommandBuffer;
class ComputeBuffer;
class ComputeShader;
class Cubemap;
class GraphicsBuffer;
class GraphicsDevice;
class Material;
class MaterialPropertyBlock;
class Mesh;
class RTHandle;
class RasterCommandBuffer;
class RecordingDevice;
class RenderGraph;
class RenderTexture;
class ScriptableRenderContext;
class ScriptableRenderPass;
class ScriptableRenderer;
class ScriptableRendererFeature;
class Scene;
class Shader;
class ShaderSource;
class Texture;
class Texture2D;
class TextureHandle;
class Timeline;
class UniversalRenderPipeline;
class UniversalRenderer;
struct Camera;
struct Color;
struct CompiledFrame;
struct DrawingSettings;
struct FilteringSettings;
struct GameObject;
struct Image;
struct Light;
struct MeshRenderer;
struct RenderReport;
struct RenderRequest;
struct RenderResult;
struct RenderTextureDescriptor;
struct RenderingData;
struct Transform;

// <limn/vulkan/…>
class VulkanDevice;
struct VulkanDeviceOptions;

// <limn/volume/…>
class ProfileContext;
class VolumeComponent;
class VolumeComponentRegistry;
class VolumeManager;
class VolumeParameter;
class VolumeProfile;
class VolumeStack;
struct Volume;

// <limn/features/…>; declare the class of a technique in the same way
class FeatureRegistry;
template <typename Feature>
class Outline;

} // namespace limn
