#pragma once

#include <array>
#include <limn/core/Inspector.h>
#include <span>

namespace limn
{

// The keys and values of scene files, for the reader and for the schema.

inline constexpr ValueRange k_PictureSizes{1.0, 16384.0}; ///< pixels, of a side
inline constexpr ValueRange k_RenderQueues{-1.0, 5000.0}; ///< -1: the shader's own
inline constexpr ValueRange k_LayerIndices{0.0, 31.0};
inline constexpr ValueRange k_LayerBits{0.0, 4294967295.0};
inline constexpr ValueRange k_Shares{0.0, 1.0};
inline constexpr ValueRange k_ShadowBiases{0.0, 10.0};    ///< texels
inline constexpr ValueRange k_ShadowTexels{16.0, 8192.0}; ///< along a side
inline constexpr EnumEntry k_ClearFlags[] = {
    {"Skybox", 1}, {"SolidColor", 2}, {"Depth", 3}, {"Nothing", 4}};

/// Unity: UnityEngine.Rendering.Universal.AntialiasingMode.
inline constexpr EnumEntry k_AntialiasingModes[] = {{"None", 0},
                                                    {"FastApproximateAntialiasing", 1}};

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

/// The kind of value behind a key.
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
    Size,   ///< the picture's size
    Layer,
    Layers, ///< a set of layers
    LayerNames,
    Enum,
    Mesh,
    ColliderType,
    Axis,
    Colliders,
    Camera,
    CameraStack,
    Light,
    Lights,
    Shadows,
    RenderSettings,
    Renderer,
    Features,
    Volumes,
    Materials,
    Objects
};

/// The kind of value behind a key, with the members of an enum.
struct SceneType
{
    constexpr SceneType(SceneValue kind) : value(kind) {}
    template <std::size_t Count>
    constexpr SceneType(const EnumEntry (&members)[Count])
        : value(SceneValue::Enum), entries(members)
    {
    }

    SceneValue value;
    std::span<const EnumEntry> entries;
};

struct SceneKey
{
    std::string_view name;
    SceneType type;
    /// The text for readers and editors. A test requires one for each key.
    std::string_view description = "";
    ValueRange range = {}; ///< the range of a number, or of each number of a vector
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
/// The range of the camera's coordinates and of the distances of fog.
inline constexpr ValueRange k_Places{-k_MaxDistance, k_MaxDistance};
inline constexpr ValueRange k_RenderScales{0.1, 2.0};
inline constexpr ValueRange k_LightLimits{0.0, 8.0};
inline constexpr ValueRange k_PipelineVersions{7.0, 17.0};
inline constexpr ValueRange k_ClipPlanes{-k_MaxDistance, k_MaxDistance};

inline constexpr SceneKey k_Position{"position", Vector,
                                     "The position in metres; x right, y up, z forward"};
inline constexpr SceneKey k_Rotation{"rotation", Vector,
                                     "Euler angles in degrees, applied in the order z, x, y"};
inline constexpr SceneKey k_Scale{"scale", Scale,
                                  "The scale along each axis, or one number for all three"};

inline constexpr SceneKey k_Scene[] = {
    {"size", Size, "Width and height of the picture in pixels; 1280 and 720 unless it is set"},
    {"msaaSampleCount", k_MsaaQualities,
     "The number of samples a pixel: 1, 2, 4 or 8, or these names; 1 unless it is set"},
    {"supportsHDR", Bool,
     "Lets cameras with allowHDR draw into an HDR colour; on unless it is set"},
    {"hdrColorBufferPrecision", k_HdrBits,
     "The bits of a pixel of an HDR colour: 32 hold no alpha and fewer steps; 64 unless it is "
     "set"},
    {"renderScale", Number,
     "The size in which cameras draw, as a share of the picture's size; 1 unless it is set",
     k_RenderScales},
    {"maxAdditionalLightsCount", Integer,
     "The number of `lights` that light an object; limn takes the brightest; 4 unless it is set",
     k_LightLimits},
    {"renderPipelineAsset", Text,
     "The path of Unity's pipeline asset, whose m_MSAA, m_SupportsHDR, "
     "m_HDRColorBufferPrecision, m_RenderScale, m_AdditionalLightsPerObjectLimit and shadows are "
     "used in place of these keys"},
    {"pipelineVersion", Integer,
     "The major version of URP that the features were written for; below 12 the camera's colour "
     "brings its depth along. Unless it is set, limn takes that of the Unity project in which "
     "renderPipelineAsset or the renderer lies, or else 14",
     k_PipelineVersions},
    {"layers", LayerNames, "Names for layers by their index, for example `{6: Furniture}`"},
    {"renderingLayers", LayerNames,
     "Names for rendering layers by their index, for example `{8: Selected}`"},
    Required({"camera", Camera, "The camera that draws the picture"}),
    {"light", Light, "The main light, which is infinitely far away"},
    {"shadows", Shadows, "Settings for the shadows of all lights that throw any"},
    {"lights", Lights, "The lights besides the main one"},
    {"ambientLight", Color,
     "The colour of the light from all sides; in ambientMode Trilight of the light from above"},
    {"renderSettings", RenderSettings, "Light from all around, what surfaces mirror, and fog"},
    {"skybox", Text,
     "The name of a material, which a camera with clearFlags Skybox sees behind everything"},
    {"plugins", Texts, "Modules (*.so) with features of your own; their code runs"},
    {"renderer", Renderer,
     "A map with `features`, or the path of Unity's renderer, a UniversalRendererData .asset"},
    {"volumes", Volumes, "Volumes, which put profiles into the scene"},
    {"materials", Materials, "Materials by their names, which objects use"},
    {"objects", Objects, "The objects to draw"}};

inline constexpr ValueRange k_Intensities{0.0, 8.0};

inline constexpr SceneKey k_RenderSettings[] = {
    {"ambientMode", k_AmbientModes,
     "Flat: one colour from all sides; Trilight: three colours by height; Skybox: the sky's light"},
    {"ambientEquatorColor", Color, "The colour of Trilight from the sides"},
    {"ambientGroundColor", Color, "The colour of Trilight from below"},
    {"ambientIntensity", Number, "A factor for the light of the sky", k_Intensities},
    {"fog", Bool, "Draws fog; off unless it is set"},
    {"fogMode", k_FogModes, "The curve by which fog thickens; ExponentialSquared unless it is set"},
    {"fogColor", Color, "The colour of the fog"},
    {"fogDensity", Number, "The density of the exponential modes, in 1/metre", {0.0, 1e6}},
    {"fogStartDistance", Number, "The distance in metres at which Linear fog begins", k_Places},
    {"fogEndDistance", Number, "The distance in metres from which on Linear fog hides everything",
     k_Places},
    {"defaultReflectionMode", k_DefaultReflectionModes,
     "Skybox: surfaces mirror the sky; they mirror nothing unless it is set"},
    {"defaultReflectionResolution",
     Integer,
     "The texels along an edge of the mirrored sky's cube, a power of two",
     {1.0, 2048.0}},
    {"reflectionIntensity", Number, "A factor for the mirrored light", k_Intensities}};

inline constexpr SceneKey k_CameraPosition{
    "position", Vector, "The position in metres; x right, y up, z forward", k_Places};
inline constexpr SceneKey k_LookAt{"lookAt", Vector, "A point to look at, in place of a rotation",
                                   k_Places};
inline constexpr SceneKey k_Orthographic{"orthographic", Bool,
                                         "Draws without perspective; off unless it is set"};
inline constexpr SceneKey k_OrthographicSize{
    "orthographicSize",
    Number,
    "Half the height of an orthographic picture in metres; 5 unless it is set",
    {1e-4, k_MaxDistance}};
// Unity's inspector offers up to 179 degrees; 0 would make an empty picture.
inline constexpr SceneKey k_FieldOfView{
    "fieldOfView",
    Number,
    "The vertical field of view in degrees; 60 unless it is set",
    {0.01, 179.0}};
inline constexpr SceneKey k_NearClipPlane{
    "nearClipPlane", Number,
    "The distance in metres at which the view begins; 0.3 unless it is set", k_ClipPlanes};
inline constexpr SceneKey k_FarClipPlane{
    "farClipPlane", Number, "The distance in metres at which the view ends; 1000 unless it is set",
    k_ClipPlanes};
inline constexpr SceneKey k_CullingMask{
    "cullingMask", Layers, "The layers whose objects are drawn; Everything unless it is set"};
inline constexpr SceneKey k_VolumeLayerMask{
    "volumeLayerMask", Layers, "The layers whose volumes count; Default unless it is set"};
inline constexpr SceneKey k_VolumeTrigger{
    "volumeTrigger", Vector,
    "The point from which volumes are measured; the camera's position unless it is set"};
inline constexpr SceneKey k_TransparencySortMode{"transparencySortMode", k_TransparencySortModes,
                                                 "The distance by which transparent objects are "
                                                 "sorted; Default follows the camera's projection"};
inline constexpr SceneKey k_TransparencySortAxis{
    "transparencySortAxis", Vector,
    "The axis of CustomAxis, in the world, pointing away from the viewer", k_Places};

inline constexpr SceneKey k_Camera[] = {
    k_CameraPosition,
    k_Rotation,
    k_LookAt,
    k_Orthographic,
    k_OrthographicSize,
    k_FieldOfView,
    k_NearClipPlane,
    k_FarClipPlane,
    {"clearFlags", k_ClearFlags,
     "The background behind all objects: the sky, the backgroundColor, or the picture so far; "
     "SolidColor unless it is set"},
    {"backgroundColor", Color, "The colour behind all objects"},
    {"renderPostProcessing", Bool, "Lets features add effects to the picture; on unless it is set"},
    {"antialiasing", k_AntialiasingModes,
     "Smooths edges behind all effects; needs renderPostProcessing and a "
     "PostProcessRendererFeature"},
    {"allowHDR", Bool, "Draws into an HDR colour if the scene supportsHDR; on unless it is set"},
    {"allowMSAA", Bool, "Draws with the scene's msaaSampleCount; on unless it is set"},
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
    {"clearDepth", Bool,
     "Lets nothing that was drawn before hide what this camera draws; on unless it is set"},
    {"renderPostProcessing", Bool,
     "Adds effects over all that is drawn so far; off unless it is set, unlike the camera's own"},
    k_CullingMask,
    k_VolumeLayerMask,
    k_VolumeTrigger,
    k_TransparencySortMode,
    k_TransparencySortAxis};

inline constexpr SceneKey k_LightColor{"color", Color, "The colour of the light"};
inline constexpr SceneKey k_LightIntensity{
    "intensity", Number, "A factor for the colour; 1 unless it is set", {0.0, 1e6}};
inline constexpr SceneKey k_ShadowKind{
    "shadows", k_LightShadows, "The kind of shadows that the light throws; None unless it is set"};
inline constexpr SceneKey k_ShadowStrength{
    "shadowStrength", Number, "The share of the light that its shadows take", k_Shares};
inline constexpr SceneKey k_SoftShadowQuality{
    "softShadowQuality", k_LightShadowQualities,
    "The width of the rims of the light's soft shadows; UsePipelineSettings takes the scene's"};
inline constexpr SceneKey k_UsePipelineSettings{
    "usePipelineSettings", Bool,
    "Takes the biases of the scene's shadows in place of those that follow; on unless it is set"};
inline constexpr SceneKey k_ShadowBias{
    "shadowBias", Number, "The bias along the light, in texels of the shadow map", k_ShadowBiases};
inline constexpr SceneKey k_ShadowNormalBias{
    "shadowNormalBias", Number, "The bias along the normal, in texels of the shadow map",
    k_ShadowBiases};

inline constexpr SceneKey k_Light[] = {
    k_Rotation,        k_LightColor,        k_LightIntensity,      k_ShadowKind,
    k_ShadowStrength,  k_SoftShadowQuality, k_UsePipelineSettings, k_ShadowBias,
    k_ShadowNormalBias};

inline constexpr SceneKey k_AdditionalLight[] = {
    {"type", k_LightTypes, "The kind of light; Point unless it is set"},
    k_Position,
    k_Rotation,
    k_LightColor,
    k_LightIntensity,
    {"range", Number, "The distance in metres at which the light ends", k_Lengths},
    {"spotAngle", Number, "The angle of a spot's whole cone in degrees", {1.0, 179.0}},
    {"innerSpotAngle",
     Number,
     "The angle in degrees within which a spot's light is full",
     {0.0, 179.0}},
    k_ShadowKind,
    k_ShadowStrength,
    k_SoftShadowQuality,
    {"shadowNearPlane",
     Number,
     "The distance in metres from which on things throw shadows",
     {0.01, 10.0}},
    {"additionalLightsShadowResolutionTier", k_ShadowResolutionTiers,
     "The tier of the scene's shadow resolutions that the light has; High unless it is set"},
    {"shadowResolution", Integer, "The texels along a side of the shadow map of tier Custom",
     k_ShadowTexels},
    k_UsePipelineSettings,
    k_ShadowBias,
    k_ShadowNormalBias};

/// The keys of a renderer, of which it has one.
inline constexpr SceneKey k_Renderer[] = {
    {"rendererData", Text,
     "The path of Unity's UniversalRendererData .asset; `renderer: X.asset` has the same effect"},
    {"features", Features, "The features, in the order in which they add their passes"}};

inline constexpr SceneKey k_Volume[] = {
    {"name", Text, "A name, by which `limn explain` calls the volume"},
    {"enabled", Bool, "Lets the volume count; on unless it is set"},
    {"isGlobal", Bool,
     "Makes the volume count everywhere, not only in its colliders; on unless it "
     "is set"},
    {"priority", Number,
     "The order of volumes: the one with the higher priority wins; 0 unless it "
     "is set"},
    {"weight", Number, "A factor for the volume's effect; 1 unless it is set", k_Shares},
    {"blendDistance", Number,
     "The distance in metres outside the colliders within which the effect fades; 0 unless it is "
     "set",
     k_Lengths},
    {"layer", Layer, "The volume's layer, which the camera's volumeLayerMask must have"},
    Required({"profile", Text, "The path of a *.profile.yaml or a Unity .asset file"}),
    k_Position,
    k_Rotation,
    k_Scale,
    {"colliders", Colliders, "The shapes in which a volume counts that is not global"}};

inline constexpr SceneKey k_Type{"type", ColliderType, "The shape; box unless it is set"};
inline constexpr SceneKey k_Enabled{"enabled", Bool,
                                    "Lets the collider count; on unless it is set"};
inline constexpr SceneKey k_Center{"center", Vector,
                                   "The middle of the shape, relative to the volume"};
inline constexpr SceneKey k_Radius{"radius", Number, "The radius in metres", k_Lengths};
inline constexpr SceneKey k_Height{"height", Number, "The height in metres, with both caps",
                                   k_Lengths};

inline constexpr SceneKey k_Box[] = {
    k_Type, k_Enabled, k_Center, {"size", Vector, "The lengths of the edges in metres"}};
inline constexpr SceneKey k_Sphere[] = {k_Type, k_Enabled, k_Center, k_Radius};
inline constexpr SceneKey k_Capsule[] = {
    k_Type,   k_Enabled, k_Center,
    k_Radius, k_Height,  {"direction", Axis, "The axis along which the capsule lies"}};
inline constexpr SceneKey k_MeshCollider[] = {
    k_Type, k_Enabled,
    Required({"mesh", Mesh, "A convex mesh: a built-in one, or the path of a .gltf or .glb file"})};

/// The shapes of colliders. The first one is the shape of a collider without a type.
inline constexpr std::array<ColliderShape, 4> k_ColliderShapes{
    {{"box", k_Box}, {"sphere", k_Sphere}, {"capsule", k_Capsule}, {"mesh", k_MeshCollider}}};

inline constexpr SceneKey k_Object[] = {
    Required({"name", Text, "The object's name, which `--select` and `--object` take"}),
    {"active", Bool, "Draws the object and its children; on unless it is set"},
    {"layer", Layer,
     "The layer, by name or index; children take it over; Default unless it is set"},
    {"renderingLayerMask", Layers,
     "The rendering layers; children take them over; Default unless it is set"},
    {"material", Text, "The name of the material; children take it over"},
    {"materials", Texts, "A material's name for each sub-mesh, in place of `material`"},
    {"shadowCastingMode", k_ShadowCastingModes,
     "The choice of throwing shadows and of being seen; On unless it is set"},
    {"bakeOutlineNormals", Bool,
     "Bakes smooth normals into the mesh, which hardened hulls such as TranslucentOutlineHull "
     "need"},
    {"position", Vector, "The position in metres, relative to the parent"},
    k_Rotation,
    k_Scale,
    {"turn", Vector, "A rotation in Euler degrees a second on top of `rotation`, for `--time`"},
    {"mesh", Mesh, "A built-in mesh, or the path of a .gltf or .glb file"},
    {"children", Objects, "Objects whose position, rotation and scale are relative to this one"}};

} // namespace scene_keys

} // namespace limn
