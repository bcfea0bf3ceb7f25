#pragma once

#include "unity_scene/UnityHierarchy.h"
#include "unity_scene/UnityMaterials.h"

#include <limn/editor_stub/SceneFile.h>

namespace limn
{

/// The state that the readers of a Unity scene's parts share.
struct UnitySceneLoader
{
    const std::filesystem::path& path;
    AssetContext& assets;
    UnityNotes& notes;
    UnityDatabase& database;
    UnityMaterials& materials;
    const UnityHierarchy& hierarchy;
    SceneAsset& asset; ///< the scene that is being made
    /// The pictures of Unity's own shapes that the scene's sprites have so far, by guid.
    std::map<std::string, std::shared_ptr<const Texture2D>> defaultSprites = {};
    int defaultRenderer = 0; ///< the index of the renderer for cameras that ask for none

    UnityReader ReaderOf(const UnityGameObject& object, const UnityInstance& component) const
    {
        return {component, object.path + "/" + NameOf(component.classID), notes};
    }
    /// Returns the fields of an asset of ProjectSettings, or null if there is none.
    UnityNode ProjectSettings(const char* name) const;
};

// The scripts of URP (7 to 17), by the guids of their .meta files.
inline constexpr std::string_view k_CameraData = "a79441f348de89743a2939f4d699eac1";
inline constexpr std::string_view k_LightData = "474bcb49853aa07438625e644c072ee6";
inline constexpr std::string_view k_Volume = "172515602e62fb746b5d573b38a5fe58";

/// Makes the scene's objects, without renderers.
void AddUnityObjects(UnitySceneLoader& loader);

/// Makes the renderers. Those of LODs that the camera does not see are switched off.
/// @param lodBias  the LOD bias of the quality level
void AddUnityRenderers(UnitySceneLoader& loader, float lodBias);

/// Makes the renderer of an object's sprite: a quad in the sprite's size, with its picture.
void AddUnitySprite(UnitySceneLoader& loader, const UnityGameObject& object,
                    const UnityInstance& renderer);

/// Reads the camera that draws the picture, with its stack. It has to be read before materials are,
/// so that these find the textures that other cameras draw into.
/// @return the index of the renderer that the camera asks for; -1 for the pipeline's first one
/// @throws AssetError  if the scene has no enabled camera
int ReadUnityCamera(UnitySceneLoader& loader);

/// Reads the cameras that draw into a texture which a material reads.
/// @param renderer  what ReadUnityCamera has returned
void ReadUnityTextureCameras(UnitySceneLoader& loader, int renderer);

/// Reads the pipeline asset of the project's quality level, and one of the pipeline's renderers.
/// @param renderer  the renderer's index; -1 for the pipeline's first one
/// @return the LOD bias of the quality level
float ReadUnityPipeline(UnitySceneLoader& loader, int renderer);

/// Returns the linear colour of a black body, whose largest component is 1. Temperatures are
/// clamped to 1667 to 25000 K. The formula is from Kim et al., "Design of Advanced Color
/// Temperature Control System" (2002).
glm::vec3 BlackBodyColor(float kelvin);

/// @param sun  the light that the scene's settings call the sun; null for the brightest
void ReadUnityLights(UnitySceneLoader& loader, const UnityInstance* sun);

void ReadUnityVolumes(UnitySceneLoader& loader);

/// Reads an object of class 104, RenderSettings: ambient light, reflections, fog and the sky.
/// Settings that limn cannot read become notes. Until the sky is drawn, the scene is lit by the
/// average of the sky that Unity has baked, or by that of Unity's default sky.
/// @param settings  keeps the values that the object does not have
void ReadUnityRenderSettings(const UnityReader& reader, UnityMaterials& materials,
                             RenderSettings& settings);

} // namespace limn
