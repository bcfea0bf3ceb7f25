#pragma once

#include <array>
#include <limn/core/Inspector.h>
#include <span>

namespace limn
{

// What scene files may say, for the reader and for the schema.

inline constexpr ValueRange k_PictureSizes{1.0, 16384.0}; ///< pixels, of a side
inline constexpr ValueRange k_RenderQueues{-1.0, 5000.0}; ///< -1: the shader's own
inline constexpr ValueRange k_LayerIndices{0.0, 31.0};
inline constexpr ValueRange k_LayerBits{0.0, 4294967295.0};
inline constexpr EnumEntry k_ClearFlags[] = {
    {"Skybox", 1}, {"SolidColor", 2}, {"Depth", 3}, {"Nothing", 4}};

inline constexpr EnumEntry k_TransparencySortModes[] = {
    {"Default", 0}, {"Perspective", 1}, {"Orthographic", 2}, {"CustomAxis", 3}};

/// Unity: UnityEngine.Rendering.Universal.MsaaQuality.
inline constexpr EnumEntry k_MsaaQualities[] = {
    {"Disabled", 1}, {"_2x", 2}, {"_4x", 4}, {"_8x", 8}};

/// Unity: UnityEngine.Rendering.Universal.HDRColorBufferPrecision, and what scene files call it.
inline constexpr EnumEntry k_HdrPrecisions[] = {{"_32Bits", 0}, {"_64Bits", 1}};
inline constexpr int k_LeastHdrBits = 32;
inline constexpr EnumEntry k_HdrBits[] = {{"_32Bits", k_LeastHdrBits}, {"_64Bits", 64}};

/// Unity: UnityEngine.Rendering.Universal.LightRenderingMode.
inline constexpr int k_NoAdditionalLights = 0;
inline constexpr int k_PerVertexLights = 2;
inline constexpr EnumEntry k_LightRenderingModes[] = {
    {"Disabled", k_NoAdditionalLights}, {"PerPixel", 1}, {"PerVertex", k_PerVertexLights}};

/// Unity: UnityEngine.LightType.
inline constexpr EnumEntry k_LightTypes[] = {{"Spot", 0}, {"Directional", 1}, {"Point", 2}};

/// Unity: UnityEngine.LightShadows, SoftShadowQuality and ShadowCastingMode.
inline constexpr EnumEntry k_LightShadows[] = {{"None", 0}, {"Hard", 1}, {"Soft", 2}};
inline constexpr EnumEntry k_LightShadowQualities[] = {
    {"UsePipelineSettings", 0}, {"Low", 1}, {"Medium", 2}, {"High", 3}};
inline constexpr EnumEntry k_ShadowResolutionTiers[] = {
    {"Custom", -1}, {"Low", 0}, {"Medium", 1}, {"High", 2}};
inline constexpr EnumEntry k_ShadowCastingModes[] = {
    {"Off", 0}, {"On", 1}, {"TwoSided", 2}, {"ShadowsOnly", 3}};

/// Unity: UnityEngine.Rendering.AmbientMode, UnityEngine.FogMode and
/// UnityEngine.Rendering.DefaultReflectionMode. Custom light cannot be written in a file.
inline constexpr EnumEntry k_AmbientModes[] = {{"Skybox", 0}, {"Trilight", 1}, {"Flat", 3}};
inline constexpr EnumEntry k_FogModes[] = {
    {"Linear", 1}, {"Exponential", 2}, {"ExponentialSquared", 3}};
inline constexpr EnumEntry k_DefaultReflectionModes[] = {{"Skybox", 0}, {"Custom", 1}};

/// What stands behind a key.
enum class SceneValue
{
    Bool,
    Number,
    Integer,
    Text,
    Texts,
    Color,
    Vector, ///< three numbers
    Scale,  ///< three numbers or one
    Size,   ///< of the picture
    Layer,
    Layers, ///< a set of them
    LayerNames,
    ClearFlags,
    TransparencySortMode,
    MsaaQuality,
    HdrPrecision,
    Mesh,
    ColliderType,
    Axis,
    Colliders,
    Camera,
    CameraStack,
    Light,
    LightType,
    Lights,
    LightShadows,
    LightShadowQuality,
    ShadowResolutionTier,
    ShadowCastingMode,
    Shadows,
    RenderSettings,
    AmbientMode,
    FogMode,
    DefaultReflectionMode,
    Renderer,
    Features,
    Volumes,
    Materials,
    Objects
};

struct SceneKey
{
    std::string_view name;
    SceneValue value;
    std::string_view description = "";
    ValueRange range = {}; ///< of a number, or of each of a vector
    bool isRequired = false;
};
using SceneKeys = std::span<const SceneKey>;

/// A shape that a volume's collider can be.
struct ColliderShape
{
    std::string_view type;
    SceneKeys keys;
};

/// The keys of each map, in the order in which messages and editors list them.
namespace scene_keys
{

using enum SceneValue;

constexpr SceneKey Required(SceneKey key)
{
    key.isRequired = true;
    return key;
}

inline constexpr double k_MaxDistance = 1e9; ///< metres
inline constexpr ValueRange k_Lengths{0.0, k_MaxDistance};
inline constexpr ValueRange k_Places{-k_MaxDistance, k_MaxDistance}; ///< of the camera
inline constexpr ValueRange k_RenderScales{0.1, 2.0};
inline constexpr ValueRange k_LightLimits{0.0, 8.0};
inline constexpr ValueRange k_PipelineVersions{7.0, 17.0};
inline constexpr ValueRange k_ClipPlanes{-k_MaxDistance, k_MaxDistance};

inline constexpr SceneKey k_Position{"position", Vector};
inline constexpr SceneKey k_Rotation{"rotation", Vector,
                                     "Euler angles in degrees, applied z, x, y"};
inline constexpr SceneKey k_Scale{"scale", Scale};

inline constexpr SceneKey k_Scene[] = {
    {"size", Size, "Width and height in pixels"},
    {"msaaSampleCount", MsaaQuality, "Samples a pixel"},
    {"supportsHDR", Bool, "Cameras with allowHDR draw into an HDR colour; on unless it is set"},
    {"hdrColorBufferPrecision", HdrPrecision,
     "Bits a pixel of an HDR colour: 32 of them hold no alpha, and fewer steps; 64 unless it is "
     "set"},
    {"renderScale", Number, "The size that cameras draw in, as a share of the picture's",
     k_RenderScales},
    {"maxAdditionalLightsCount", Integer, "How many of `lights` light an object: the brightest",
     k_LightLimits},
    {"renderPipelineAsset", Text,
     "Unity's, for its m_MSAA, m_SupportsHDR, m_HDRColorBufferPrecision, m_RenderScale, "
     "m_AdditionalLightsPerObjectLimit and shadows in place of these keys"},
    {"pipelineVersion", Integer,
     "The major version of URP that the features were written for; below 12 the camera's colour "
     "brings its depth along. Unless it is set, that of the Unity project which "
     "renderPipelineAsset or the renderer lies in; else 14",
     k_PipelineVersions},
    {"layers", LayerNames},
    {"renderingLayers", LayerNames},
    Required({"camera", Camera}),
    {"light", Light, "The main one, infinitely far away"},
    {"shadows", Shadows, "Those of the lights that throw any"},
    {"lights", Lights, "Those besides the main one"},
    {"ambientLight", Color, "From all sides; in ambientMode Trilight from above"},
    {"renderSettings", RenderSettings, "Further light from all around, what is mirrored, fog"},
    {"skybox", Text, "One of the materials, which a camera with clearFlags Skybox sees behind all"},
    {"plugins", Texts, "Modules with features of your own, *.so; their code runs"},
    {"renderer", Renderer,
     "A map with `features`, or the path of Unity's renderer: a UniversalRendererData .asset"},
    {"volumes", Volumes},
    {"materials", Materials},
    {"objects", Objects}};

inline constexpr ValueRange k_Intensities{0.0, 8.0};

inline constexpr SceneKey k_RenderSettings[] = {
    {"ambientMode", AmbientMode, "The same light from all sides, three colours by height, the sky"},
    {"ambientEquatorColor", Color, "Of Trilight, from the sides"},
    {"ambientGroundColor", Color, "Of Trilight, from below"},
    {"ambientIntensity", Number, "Multiplies the light of the sky", k_Intensities},
    {"fog", Bool},
    {"fogMode", FogMode},
    {"fogColor", Color},
    {"fogDensity", Number, "1/metre; of the exponential modes", {0.0, 1e6}},
    {"fogStartDistance", Number, "Metres; of Linear", k_Places},
    {"fogEndDistance", Number, "Metres; of Linear: nothing but fog is seen from there", k_Places},
    {"defaultReflectionMode", DefaultReflectionMode,
     "Skybox: surfaces mirror the sky; nothing unless it is set"},
    {"defaultReflectionResolution",
     Integer,
     "Texels along an edge of the mirrored sky's cube, a power of two",
     {1.0, 2048.0}},
    {"reflectionIntensity", Number, "Multiplies what is mirrored", k_Intensities}};

inline constexpr SceneKey k_CameraPosition{"position", Vector, "", k_Places};
inline constexpr SceneKey k_LookAt{"lookAt", Vector, "A point to look at, in place of a rotation",
                                   k_Places};
inline constexpr SceneKey k_Orthographic{"orthographic", Bool};
inline constexpr SceneKey k_OrthographicSize{
    "orthographicSize", Number, "Half the picture's height in metres", {1e-4, k_MaxDistance}};
// Unity's inspector offers up to 179 degrees; 0 would make a picture of nothing.
inline constexpr SceneKey k_FieldOfView{
    "fieldOfView", Number, "Vertical, in degrees", {0.01, 179.0}};
inline constexpr SceneKey k_NearClipPlane{"nearClipPlane", Number, "", k_ClipPlanes};
inline constexpr SceneKey k_FarClipPlane{"farClipPlane", Number, "", k_ClipPlanes};
inline constexpr SceneKey k_CullingMask{"cullingMask", Layers};
inline constexpr SceneKey k_VolumeLayerMask{"volumeLayerMask", Layers};
inline constexpr SceneKey k_VolumeTrigger{"volumeTrigger", Vector};
inline constexpr SceneKey k_TransparencySortMode{
    "transparencySortMode", TransparencySortMode,
    "What objects' distances are, by which they are sorted; Default is as the lens has it"};
inline constexpr SceneKey k_TransparencySortAxis{
    "transparencySortAxis", Vector, "Of CustomAxis: away from the viewer, in the world", k_Places};

inline constexpr SceneKey k_Camera[] = {
    k_CameraPosition,
    k_Rotation,
    k_LookAt,
    k_Orthographic,
    k_OrthographicSize,
    k_FieldOfView,
    k_NearClipPlane,
    k_FarClipPlane,
    {"clearFlags", ClearFlags},
    {"backgroundColor", Color},
    {"renderPostProcessing", Bool, "What features ask before they add effects"},
    {"allowHDR", Bool},
    {"allowMSAA", Bool, "Several samples a pixel, if the scene's msaaSampleCount says so"},
    k_CullingMask,
    k_VolumeLayerMask,
    k_VolumeTrigger,
    k_TransparencySortMode,
    k_TransparencySortAxis,
    {"cameraStack", CameraStack, "Overlay cameras, which draw onto the picture in this order"}};

inline constexpr SceneKey k_OverlayCamera[] = {
    k_CameraPosition,
    k_Rotation,
    k_LookAt,
    k_Orthographic,
    k_OrthographicSize,
    k_FieldOfView,
    k_NearClipPlane,
    k_FarClipPlane,
    {"clearDepth", Bool, "What was drawn before hides nothing of it; on unless it is set"},
    {"renderPostProcessing", Bool,
     "Effects over all that is drawn so far; off unless it is set, other than the camera's own"},
    k_CullingMask,
    k_VolumeLayerMask,
    k_VolumeTrigger,
    k_TransparencySortMode,
    k_TransparencySortAxis};

inline constexpr SceneKey k_ShadowKind{"shadows", LightShadows};
inline constexpr SceneKey k_ShadowStrength{
    "shadowStrength", Number, "The share of its light that shadows take", {0.0, 1.0}};
inline constexpr SceneKey k_SoftShadowQuality{"softShadowQuality", LightShadowQuality};
inline constexpr SceneKey k_UsePipelineSettings{"usePipelineSettings", Bool,
                                                "For the biases, in place of those that follow"};
inline constexpr SceneKey k_ShadowBias{
    "shadowBias", Number, "Texels of the shadow map, along the light", {0.0, 10.0}};
inline constexpr SceneKey k_ShadowNormalBias{
    "shadowNormalBias", Number, "Texels of the shadow map, along the normal", {0.0, 10.0}};

inline constexpr SceneKey k_Light[] = {k_Rotation,
                                       {"color", Color},
                                       {"intensity", Number, "", {0.0, 1e6}},
                                       k_ShadowKind,
                                       k_ShadowStrength,
                                       k_SoftShadowQuality,
                                       k_UsePipelineSettings,
                                       k_ShadowBias,
                                       k_ShadowNormalBias};

inline constexpr SceneKey k_AdditionalLight[] = {
    {"type", LightType},
    k_Position,
    k_Rotation,
    {"color", Color},
    {"intensity", Number, "", {0.0, 1e6}},
    {"range", Number, "Metres from which on it lights nothing", k_Lengths},
    {"spotAngle", Number, "Where a spot's light ends, degrees across", {1.0, 179.0}},
    {"innerSpotAngle", Number, "Up to where a spot's light is full, degrees across", {0.0, 179.0}},
    k_ShadowKind,
    k_ShadowStrength,
    k_SoftShadowQuality,
    {"shadowNearPlane", Number, "Metres to where its shadow map's depth begins", {0.01, 10.0}},
    {"additionalLightsShadowResolutionTier", ShadowResolutionTier},
    {"shadowResolution", Integer, "Of tier Custom: texels of the shadow map", {16.0, 8192.0}},
    k_UsePipelineSettings,
    k_ShadowBias,
    k_ShadowNormalBias};

/// A renderer has one of these.
inline constexpr SceneKey k_Renderer[] = {
    {"rendererData", Text,
     "The path of a UniversalRendererData .asset of Unity's; `renderer: X.asset` says the same"},
    {"features", Features, "In the order in which they add their passes"}};

inline constexpr SceneKey k_Volume[] = {
    {"name", Text},
    {"enabled", Bool},
    {"isGlobal", Bool},
    {"priority", Number, "The higher one wins"},
    {"weight", Number, "", {0.0, 1.0}},
    {"blendDistance", Number, "Metres", k_Lengths},
    {"layer", Layer},
    Required({"profile", Text, "A *.profile.yaml or a Unity .asset file"}),
    k_Position,
    k_Rotation,
    k_Scale,
    {"colliders", Colliders}};

inline constexpr SceneKey k_Type{"type", ColliderType};
inline constexpr SceneKey k_Enabled{"enabled", Bool};
inline constexpr SceneKey k_Center{"center", Vector};
inline constexpr SceneKey k_Radius{"radius", Number, "Metres", k_Lengths};
inline constexpr SceneKey k_Height{"height", Number, "Metres", k_Lengths};

inline constexpr SceneKey k_Box[] = {k_Type, k_Enabled, k_Center, {"size", Vector}};
inline constexpr SceneKey k_Sphere[] = {k_Type, k_Enabled, k_Center, k_Radius};
inline constexpr SceneKey k_Capsule[] = {k_Type,   k_Enabled, k_Center,
                                         k_Radius, k_Height,  {"direction", Axis}};
inline constexpr SceneKey k_MeshCollider[] = {k_Type, k_Enabled, Required({"mesh", Mesh})};

/// The first is what a collider without a type is.
inline constexpr std::array<ColliderShape, 4> k_ColliderShapes{
    {{"box", k_Box}, {"sphere", k_Sphere}, {"capsule", k_Capsule}, {"mesh", k_MeshCollider}}};

inline constexpr SceneKey k_Object[] = {
    Required({"name", Text}),
    {"active", Bool},
    {"layer", Layer},
    {"renderingLayerMask", Layers},
    {"material", Text},
    {"materials", Texts},
    {"shadowCastingMode", ShadowCastingMode},
    {"bakeOutlineNormals", Bool, "Gives the mesh what TranslucentOutlineHull goes by"},
    k_Position,
    k_Rotation,
    k_Scale,
    {"turn", Vector, "Euler degrees a second on top of the rotation"},
    {"mesh", Mesh},
    {"children", Objects}};

} // namespace scene_keys

} // namespace limn
