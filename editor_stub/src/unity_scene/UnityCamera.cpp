#include "unity_scene/UnitySceneLoader.h"

#include <algorithm>

namespace limn
{

namespace
{

/// Returns the enabled camera that the picture is of: a base camera tagged MainCamera, or else
/// the one of the least depth.
const UnityGameObject* FindCamera(UnitySceneLoader& loader)
{
    const UnityGameObject* found = nullptr;
    bool isMain = false;
    float least = 0.0f;
    int others = -1;
    for (const UnityGameObject* object : loader.hierarchy.objects())
    {
        const UnityInstance* camera = object->Find(UnityClass::Camera);
        if (camera == nullptr || !object->isActive)
        {
            continue;
        }
        const UnityReader reader = loader.ReaderOf(*object, *camera);
        bool isEnabled = true;
        float depth = 0.0f;
        reader.Read("m_Enabled", isEnabled);
        reader.Read("m_Depth", depth);
        int type = 0;
        if (const UnityInstance* data = object->FindScript(k_CameraData))
        {
            loader.ReaderOf(*object, *data).Read("m_CameraType", type);
        }
        if (!isEnabled || type != 0 || !reader.Reference("m_TargetTexture").isNull())
        {
            continue;
        }
        ++others;
        std::string tag;
        UnityReader(*object->object, object->path, loader.notes).Read("m_TagString", tag);
        const bool isTagged = tag == "MainCamera";
        if (found == nullptr || (isTagged && !isMain) || (isTagged == isMain && depth < least))
        {
            found = object;
            isMain = isTagged;
            least = depth;
        }
    }
    for (int i = 0; i < others; ++i)
    {
        loader.notes.Count("cameras besides the main one");
    }
    return found;
}

/// @param renderer  set to the index of the renderer that the camera asks for, if it does
void ReadView(UnitySceneLoader& loader, const UnityGameObject& object, Camera& camera,
              int& renderer)
{
    const UnityReader reader = loader.ReaderOf(object, *object.Find(UnityClass::Camera));
    camera.transform = object.drawn->transform;
    int clear = 1;
    reader.Read("m_ClearFlags", clear);
    camera.clearFlags = clear == 1   ? CameraClearFlags::Skybox
                        : clear == 2 ? CameraClearFlags::SolidColor
                                     : CameraClearFlags::Depth;
    reader.Read("m_BackGroundColor", camera.backgroundColor);
    reader.Read("orthographic", camera.orthographic);
    reader.ReadIn("orthographic size", 1e-3f, 1e9f, camera.orthographicSize);
    reader.ReadIn("field of view", 0.01f, 179.0f, camera.fieldOfView);
    reader.ReadIn("far clip plane", 0.02f, 1e9f, camera.farClipPlane);
    camera.nearClipPlane = std::min(camera.nearClipPlane, camera.farClipPlane * 0.5f);
    reader.ReadIn("near clip plane", camera.orthographic ? -1e9f : 1e-4f,
                  camera.farClipPlane * 0.999f, camera.nearClipPlane);
    reader.Read("m_CullingMask", camera.cullingMask);
    reader.Read("m_HDR", camera.allowHDR);
    reader.Read("m_AllowMSAA", camera.allowMSAA);
    camera.renderPostProcessing = false;
    if (const UnityInstance* data = object.FindScript(k_CameraData))
    {
        const UnityReader own = loader.ReaderOf(object, *data);
        own.Read("m_RenderPostProcessing", camera.renderPostProcessing);
        own.Read("m_VolumeLayerMask", camera.volumeLayerMask);
        own.Read("m_ClearDepth", camera.clearDepth);
        own.Read("m_RendererIndex", renderer);
        int antialiasing = 0;
        own.Read("m_Antialiasing", antialiasing);
        if (antialiasing == static_cast<int>(AntialiasingMode::FastApproximateAntialiasing))
        {
            camera.antialiasing = AntialiasingMode::FastApproximateAntialiasing;
        }
        else if (antialiasing != 0)
        {
            loader.notes.Count("antialiasing of cameras in post-processing (SMAA or TAA)");
        }
    }
}

void ReadStack(UnitySceneLoader& loader, const UnityReader& data, Camera& camera)
{
    const std::size_t count = data.Count("m_Cameras");
    for (std::size_t i = 0; i < count; ++i)
    {
        const UnityTarget target =
            data.Reference("m_Cameras.Array.data[" + std::to_string(i) + "]");
        const UnityGameObject* object = loader.hierarchy.Find(target.object);
        if (object != nullptr && object->isActive && object->Find(UnityClass::Camera) != nullptr)
        {
            auto overlay = std::make_shared<Camera>();
            int unused = 0;
            ReadView(loader, *object, *overlay, unused);
            overlay->renderType = CameraRenderType::Overlay;
            camera.cameraStack.push_back(std::move(overlay));
        }
    }
}

} // namespace

int ReadUnityCamera(UnitySceneLoader& loader)
{
    const UnityGameObject* object = FindCamera(loader);
    if (object == nullptr)
    {
        throw AssetError(loader.path.generic_string(), {},
                         "no camera draws a picture: none is active and enabled and draws onto "
                         "the screen; switch one on in Unity, or name another scene with --scene");
    }
    Camera& camera = loader.asset.camera;
    int renderer = -1;
    ReadView(loader, *object, camera, renderer);
    if (const UnityInstance* data = object->FindScript(k_CameraData))
    {
        ReadStack(loader, loader.ReaderOf(*object, *data), camera);
    }
    return renderer;
}

} // namespace limn
