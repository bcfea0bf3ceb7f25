#include "unity/UnityScene.h"

#include "unity/RenderPipelineAsset.h"
#include "unity/UnityHierarchy.h"
#include "unity/UnityMaterials.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limn/base/ReadFile.h>
#include <limn/editor_stub/UnityRendererData.h>

namespace limn
{

namespace
{

// Scripts of URP (7 to 17), by the guids of their .meta files.
constexpr std::string_view k_CameraData = "a79441f348de89743a2939f4d699eac1";
constexpr std::string_view k_LightData = "474bcb49853aa07438625e644c072ee6";
constexpr std::string_view k_Volume = "172515602e62fb746b5d573b38a5fe58";

/// Kinds of things that a scene may have and limn does not draw.
constexpr std::pair<int, const char*> k_NotDrawn[] = {{96, "trails"},
                                                      {120, "lines"},
                                                      {198, "particle systems"},
                                                      {212, "sprites"},
                                                      {215, "reflection probes"},
                                                      {218, "terrains"},
                                                      {220, "light probe groups"},
                                                      {223, "canvases of a user interface"},
                                                      {2083052967, "visual effects"},
                                                      {102, "text meshes"}};

float Luminance(const Color& color)
{
    return 0.2126f * color.r + 0.7152f * color.g + 0.0722f * color.b;
}

/// Reads what a scene's objects and components say into a SceneAsset.
class UnitySceneReader
{
public:
    UnitySceneReader(const std::filesystem::path& path, AssetContext& assets)
        : m_Path(path),
          m_Assets(assets),
          m_Database(UnityProjectAround(path), assets, m_Notes),
          m_Materials(m_Database, assets, m_Notes)
    {
        m_Asset.path = path;
    }

    SceneAsset Read()
    {
        const std::shared_ptr<const UnityFile> file = m_Database.LoadFile(m_Path);
        if (!file)
        {
            const std::vector<Diagnostic> notes = m_Notes.Finish(m_Path.generic_string());
            throw AssetError(m_Path.generic_string(), {},
                             notes.empty() ? "the scene cannot be read" : notes.back().message);
        }
        const UnityExpansion expansion(file, [this](const std::string& guid)
                                       { return m_Materials.LoadPrefab(guid); });
        m_Notes.Add(expansion.notes());
        const UnityHierarchy hierarchy(expansion, m_Notes);
        m_Hierarchy = &hierarchy;
        ReadLayers();
        AddObjects(hierarchy);
        ReadCamera(hierarchy);
        ReadPipeline();
        ChooseLods(hierarchy);
        AddRenderers(hierarchy);
        ReadSettings(expansion);
        ReadLights(hierarchy);
        ReadVolumes(hierarchy);
        CountOthers(hierarchy);
        m_Asset.notes = m_Notes.Finish(m_Path.generic_string());
        return std::move(m_Asset);
    }

private:
    static std::string SubjectOf(const UnityGameObject& object, const UnityInstance& component)
    {
        return object.path + "/" + NameOf(component.classID);
    }

    UnityReader ReaderOf(const UnityGameObject& object, const UnityInstance& component)
    {
        return {component, SubjectOf(object, component), m_Notes};
    }

    /// An asset of ProjectSettings; null where there is none.
    UnityNode ProjectSettings(const char* name)
    {
        const auto file = m_Database.LoadFile(m_Database.root() / "ProjectSettings" / name);
        return file && !file->headers().empty() ? file->Fields(file->headers().front())
                                                : UnityNode();
    }

    void ReadLayers()
    {
        int layer = 0;
        for (const UnityNode name : ProjectSettings("TagManager.asset")["layers"])
        {
            if (!name.text().empty() && layer < 32)
            {
                m_Asset.layers.SetName(layer, std::string(name.text()));
            }
            ++layer;
        }
    }

    void AddObjects(const UnityHierarchy& hierarchy)
    {
        for (UnityGameObject* object : hierarchy.objects())
        {
            const UnityReader reader(*object->object, object->path, m_Notes);
            std::string name;
            reader.Read("m_Name", name);
            GameObject& drawn = m_Asset.scene.Add(std::move(name));
            object->drawn = &drawn;
            reader.Read("m_Layer", drawn.layer);
            if (drawn.layer < 0 || drawn.layer > 31)
            {
                reader.Note("m_Layer", "it is none of 0 to 31, so it is 0");
                drawn.layer = 0;
            }
            drawn.activeSelf = object->isActive;
            const UnityReader transform = ReaderOf(*object, *object->transform);
            transform.Read("m_LocalPosition", drawn.transform.localPosition);
            transform.Read("m_LocalRotation", drawn.transform.localRotation);
            transform.Read("m_LocalScale", drawn.transform.localScale);
            drawn.transform.parent =
                object->parent != nullptr ? &object->parent->drawn->transform : nullptr;
        }
    }

    void AddRenderers(const UnityHierarchy& hierarchy)
    {
        for (const UnityGameObject* object : hierarchy.objects())
        {
            AddRenderer(*object);
        }
    }

    /// Finds the renderers that a LOD group does not show at the camera's distance.
    void ChooseLods(const UnityHierarchy& hierarchy)
    {
        for (const UnityGameObject* object : hierarchy.objects())
        {
            const UnityInstance* group = object->Find(UnityClass::LODGroup);
            if (group == nullptr || !object->isActive)
            {
                continue;
            }
            const UnityReader reader = ReaderOf(*object, *group);
            bool isEnabled = true;
            reader.Read("m_Enabled", isEnabled);
            const float height = HeightOnScreen(*object, reader);
            const std::size_t count = isEnabled ? reader.Count("m_LODs") : 0;
            bool isShown = false; // one of the LODs so far
            std::set<const UnityInstance*> shown;
            std::set<const UnityInstance*> hidden;
            for (std::size_t i = 0; i < count; ++i)
            {
                const std::string lod = "m_LODs.Array.data[" + std::to_string(i) + "].";
                float least = 0.0f;
                reader.Read(lod + "screenRelativeHeight", least);
                const bool isThis = !isShown && height >= least;
                isShown = isShown || isThis;
                const std::size_t renderers = reader.Count(lod + "renderers");
                for (std::size_t r = 0; r < renderers; ++r)
                {
                    (isThis ? shown : hidden)
                        .insert(reader
                                    .Reference(lod + "renderers.Array.data[" + std::to_string(r) +
                                               "].renderer")
                                    .object);
                }
            }
            std::ranges::set_difference(hidden, shown, std::inserter(m_Hidden, m_Hidden.end()));
        }
    }

    /// The part of the picture's height that a LOD group takes, as Unity reckons it.
    float HeightOnScreen(const UnityGameObject& object, const UnityReader& group)
    {
        glm::vec3 point(0.0f);
        float size = 1.0f;
        group.Read("m_LocalReferencePoint", point);
        group.Read("m_Size", size);
        const glm::dmat4 world = object.drawn->transform.worldMatrix();
        double scale = 0.0;
        for (int axis = 0; axis < 3; ++axis)
        {
            scale = std::max(scale, glm::length(glm::dvec3(world[axis])));
        }
        const Camera& camera = m_Asset.camera;
        const double whole = static_cast<double>(size) * scale * static_cast<double>(m_LodBias);
        if (camera.orthographic)
        {
            return static_cast<float>(whole / (2.0 * static_cast<double>(camera.orthographicSize)));
        }
        const glm::dvec3 place(world * glm::dvec4(glm::dvec3(point), 1.0));
        const double distance = glm::length(place - glm::dvec3(camera.transform.position()));
        const double tangent =
            std::tan(glm::radians(static_cast<double>(camera.fieldOfView)) * 0.5);
        return static_cast<float>(whole / std::max(2.0 * distance * tangent, 1e-9));
    }

    void AddRenderer(const UnityGameObject& object)
    {
        const UnityInstance* filter = object.Find(UnityClass::MeshFilter);
        const UnityInstance* renderer = object.Find(UnityClass::MeshRenderer);
        const UnityInstance* skinned = object.Find(UnityClass::SkinnedMeshRenderer);
        if (skinned != nullptr)
        {
            filter = renderer = skinned; // at its rest pose
        }
        if (renderer == nullptr || filter == nullptr)
        {
            return;
        }
        const UnityReader reader = ReaderOf(object, *renderer);
        MeshRenderer made;
        reader.Read("m_Enabled", made.enabled);
        const UnityReader mesh = ReaderOf(object, *filter);
        const UnityTarget target = mesh.Reference("m_Mesh");
        if (target.isNull())
        {
            return;
        }
        if (object.isActive && made.enabled)
        {
            made.mesh = m_Materials.LoadMesh(target, mesh);
        }
        made.enabled = made.enabled && m_Hidden.count(renderer) == 0;
        reader.ReadEnum("m_CastShadows", ShadowCastingMode::ShadowsOnly, made.shadowCastingMode);
        reader.Read("m_RenderingLayerMask", made.renderingLayerMask);
        if (made.mesh)
        {
            AddMaterials(reader, made);
        }
        object.drawn->renderer = std::move(made);
    }

    void AddMaterials(const UnityReader& reader, MeshRenderer& renderer)
    {
        const std::size_t count = reader.Count("m_Materials");
        for (std::size_t i = 0; i < count; ++i)
        {
            const std::string path = "m_Materials.Array.data[" + std::to_string(i) + "]";
            renderer.sharedMaterials.push_back(
                m_Materials.Load(reader.Reference(path).asset, reader, path));
        }
    }

    /// Returns the enabled camera that the picture is of: a base camera tagged MainCamera, or else
    /// the one of the least depth.
    const UnityGameObject* FindCamera(const UnityHierarchy& hierarchy)
    {
        const UnityGameObject* found = nullptr;
        bool isMain = false;
        float least = 0.0f;
        int others = -1;
        for (const UnityGameObject* object : hierarchy.objects())
        {
            const UnityInstance* camera = object->Find(UnityClass::Camera);
            if (camera == nullptr || !object->isActive)
            {
                continue;
            }
            const UnityReader reader = ReaderOf(*object, *camera);
            bool isEnabled = true;
            float depth = 0.0f;
            reader.Read("m_Enabled", isEnabled);
            reader.Read("m_Depth", depth);
            int type = 0;
            if (const UnityInstance* data = object->FindScript(k_CameraData))
            {
                ReaderOf(*object, *data).Read("m_CameraType", type);
            }
            if (!isEnabled || type != 0 || !reader.Reference("m_TargetTexture").isNull())
            {
                continue;
            }
            ++others;
            std::string tag;
            UnityReader(*object->object, object->path, m_Notes).Read("m_TagString", tag);
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
            m_Notes.Count("cameras besides the main one");
        }
        return found;
    }

    void ReadCamera(const UnityHierarchy& hierarchy)
    {
        const UnityGameObject* object = FindCamera(hierarchy);
        if (object == nullptr)
        {
            throw AssetError(m_Path.generic_string(), {},
                             "no camera draws a picture: none is active and enabled and draws onto "
                             "the screen; switch one on in Unity");
        }
        Camera& camera = m_Asset.camera;
        ReadView(*object, camera);
        if (const UnityInstance* data = object->FindScript(k_CameraData))
        {
            ReadStack(ReaderOf(*object, *data), camera);
        }
    }

    void ReadView(const UnityGameObject& object, Camera& camera)
    {
        const UnityReader reader = ReaderOf(object, *object.Find(UnityClass::Camera));
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
            const UnityReader own = ReaderOf(object, *data);
            own.Read("m_RenderPostProcessing", camera.renderPostProcessing);
            own.Read("m_VolumeLayerMask", camera.volumeLayerMask);
            own.Read("m_ClearDepth", camera.clearDepth);
            own.Read("m_RendererIndex", m_RendererIndex);
            int antialiasing = 0;
            own.Read("m_Antialiasing", antialiasing);
            if (antialiasing != 0)
            {
                m_Notes.Count("antialiasing of cameras in post-processing (FXAA, SMAA or TAA)");
            }
        }
    }

    void ReadStack(const UnityReader& data, Camera& camera)
    {
        const std::size_t count = data.Count("m_Cameras");
        for (std::size_t i = 0; i < count; ++i)
        {
            const UnityTarget target =
                data.Reference("m_Cameras.Array.data[" + std::to_string(i) + "]");
            const UnityGameObject* object = m_Hierarchy->Find(target.object);
            if (object != nullptr && object->isActive &&
                object->Find(UnityClass::Camera) != nullptr)
            {
                auto overlay = std::make_shared<Camera>();
                const int renderer = m_RendererIndex;
                ReadView(*object, *overlay);
                m_RendererIndex = renderer;
                overlay->renderType = CameraRenderType::Overlay;
                camera.cameraStack.push_back(std::move(overlay));
            }
        }
    }

    /// The asset of the quality level that the editor shows, or else of GraphicsSettings.
    const std::filesystem::path* FindPipeline()
    {
        const UnityNode quality = ProjectSettings("QualitySettings.asset");
        int current = 0;
        const std::string_view text = quality["m_CurrentQuality"].text();
        std::from_chars(text.data(), text.data() + text.size(), current);
        int level = 0;
        for (const UnityNode entry : quality["m_QualitySettings"])
        {
            if (level++ == current)
            {
                const std::string_view bias = entry["lodBias"].text();
                std::from_chars(bias.data(), bias.data() + bias.size(), m_LodBias);
                const UnityReference asset = ReadUnityReference(entry["customRenderPipeline"]);
                if (const auto* path = asset.isNull() ? nullptr : m_Database.Find(asset.guid))
                {
                    return path;
                }
            }
        }
        const UnityReference asset =
            ReadUnityReference(ProjectSettings("GraphicsSettings.asset")["m_CustomRenderPipeline"]);
        return asset.isNull() ? nullptr : m_Database.Find(asset.guid);
    }

    void ReadPipeline()
    {
        const std::filesystem::path* path = FindPipeline();
        if (path == nullptr)
        {
            m_Notes.Add(m_Path.generic_string(), 0,
                        "the project has no asset of the Universal Render Pipeline, so limn's own "
                        "settings are used");
            return;
        }
        try
        {
            const UnityRenderPipeline pipeline = LoadUnityRenderPipeline(*path, m_Assets);
            m_Asset.msaaSampleCount = pipeline.msaaSampleCount;
            m_Asset.supportsHDR = pipeline.supportsHDR;
            m_Asset.hdrColorBufferPrecision = pipeline.hdrColorBufferPrecision;
            m_Asset.renderScale = pipeline.renderScale;
            m_Asset.maxAdditionalLightsCount = pipeline.maxAdditionalLightsCount;
            m_Asset.shadows = pipeline.shadows;
            m_Asset.pipelineVersion = pipeline.pipelineVersion.value_or(m_Asset.pipelineVersion);
            ReadRenderer(*path);
        }
        catch (const AssetError& error)
        {
            Add(error);
        }
    }

    void ReadRenderer(const std::filesystem::path& pipeline)
    {
        const auto file = m_Database.LoadFile(pipeline);
        const UnityHeader* header = file ? FindClass(*file, UnityClass::MonoBehaviour) : nullptr;
        const UnityNode fields = header != nullptr ? file->Fields(*header) : UnityNode();
        int index = m_RendererIndex;
        if (index < 0)
        {
            const std::string_view text = fields["m_DefaultRendererIndex"].text();
            index = 0;
            std::from_chars(text.data(), text.data() + text.size(), index);
        }
        int at = 0;
        for (const UnityNode entry : fields["m_RendererDataList"])
        {
            const UnityReference renderer = ReadUnityReference(entry);
            const auto* path = at++ == index ? m_Database.Find(renderer.guid) : nullptr;
            if (path != nullptr)
            {
                UnityRendererDataLoadResult result = LoadUnityRendererData(*path, m_Assets);
                m_Asset.renderer = std::move(result.renderer);
                for (const Diagnostic& note : result.notes)
                {
                    m_Notes.Add(note.file, note.location.line, note.message);
                }
            }
        }
    }

    void ReadSettings(const UnityExpansion& expansion)
    {
        for (const UnityInstance* object : expansion.objects())
        {
            if (object->classID != UnityClass::RenderSettings)
            {
                continue;
            }
            const UnityReader reader(*object, "RenderSettings", m_Notes);
            int mode = 0;
            reader.Read("m_AmbientMode", mode);
            if (mode == 0)
            {
                // The average of the default sky, linear, which Unity bakes into new scenes.
                m_Asset.scene.ambientLight = Color{0.18028f, 0.22571f, 0.30692f, 1.0f}.gamma();
                reader.Read("m_IndirectSpecularColor", m_Asset.scene.ambientLight);
                m_Asset.scene.ambientLight = m_Asset.scene.ambientLight.gamma();
            }
            else
            {
                reader.Read("m_AmbientSkyColor", m_Asset.scene.ambientLight);
            }
            const UnityTarget skybox = reader.Reference("m_SkyboxMaterial");
            if (!skybox.asset.isNull())
            {
                m_Asset.scene.skybox = m_Materials.Load(skybox.asset, reader, "m_SkyboxMaterial");
            }
            m_Sun = reader.Reference("m_Sun").object;
            bool hasFog = false;
            reader.Read("m_Fog", hasFog);
            if (hasFog)
            {
                reader.Note("m_Fog", "the fog is left out; limn does not draw it");
            }
        }
    }

    void ReadLights(const UnityHierarchy& hierarchy)
    {
        std::optional<Light> main;
        m_Asset.scene.mainLight.intensity = 0.0f;
        for (const UnityGameObject* object : hierarchy.objects())
        {
            const UnityInstance* component = object->Find(UnityClass::Light);
            if (component == nullptr || !object->isActive)
            {
                continue;
            }
            Light light;
            if (!ReadLight(*object, *component, light))
            {
                continue;
            }
            const bool isBrighter = light.type == LightType::Directional &&
                                    (!main || component == m_Sun ||
                                     (!m_IsSun && Luminance(light.color) * light.intensity >
                                                      Luminance(main->color) * main->intensity));
            if (!isBrighter)
            {
                m_Asset.scene.additionalLights.push_back(std::move(light));
                continue;
            }
            if (main)
            {
                m_Asset.scene.additionalLights.push_back(std::move(*main));
            }
            m_IsSun = component == m_Sun;
            main = std::move(light);
        }
        if (main)
        {
            SetMainLight(*main);
        }
    }

    /// @return whether it shines in a picture
    bool ReadLight(const UnityGameObject& object, const UnityInstance& component, Light& light)
    {
        const UnityReader reader = ReaderOf(object, component);
        bool isEnabled = true;
        int type = 1;
        reader.Read("m_Enabled", isEnabled);
        reader.Read("m_Type", type);
        int baked = 4;
        reader.Read("m_Lightmapping", baked);
        if (isEnabled && (type > 2 || baked == 2))
        {
            m_Notes.Count("baked and area lights");
        }
        if (!isEnabled || type < 0 || type > 2 || baked == 2)
        {
            return false;
        }
        light.type = static_cast<LightType>(type);
        light.transform.localPosition = object.drawn->transform.position();
        light.transform.localRotation = object.drawn->transform.rotation();
        reader.Read("m_Color", light.color);
        reader.ReadIn("m_Intensity", 0.0f, 1e9f, light.intensity);
        reader.ReadIn("m_Range", 1e-3f, 1e9f, light.range);
        reader.ReadIn("m_SpotAngle", 1.0f, 179.0f, light.spotAngle);
        light.innerSpotAngle = std::min(light.innerSpotAngle, light.spotAngle);
        reader.ReadIn("m_InnerSpotAngle", 0.0f, light.spotAngle, light.innerSpotAngle);
        reader.ReadEnum("m_Shadows.m_Type", LightShadows::Soft, light.shadows);
        reader.ReadIn("m_Shadows.m_Strength", 0.0f, 1.0f, light.shadowStrength);
        reader.ReadIn("m_Shadows.m_Bias", 0.0f, 10.0f, light.shadowBias);
        reader.ReadIn("m_Shadows.m_NormalBias", 0.0f, 10.0f, light.shadowNormalBias);
        reader.ReadIn("m_Shadows.m_NearPlane", 0.01f, 1e9f, light.shadowNearPlane);
        if (!reader.Reference("m_Cookie").isNull())
        {
            m_Notes.Count("cookies of lights");
        }
        if (const UnityInstance* data = object.FindScript(k_LightData))
        {
            ReaderOf(object, *data).Read("m_UsePipelineSettings", light.usePipelineSettings);
        }
        return true;
    }

    void SetMainLight(const Light& light)
    {
        DirectionalLight& main = m_Asset.scene.mainLight;
        main.direction = light.transform.localRotation * glm::vec3(0.0f, 0.0f, 1.0f);
        main.color = light.color;
        main.intensity = light.intensity;
        main.shadows = light.shadows;
        main.shadowStrength = light.shadowStrength;
        main.usePipelineSettings = light.usePipelineSettings;
        main.shadowBias = light.shadowBias;
        main.shadowNormalBias = light.shadowNormalBias;
    }

    void ReadVolumes(const UnityHierarchy& hierarchy)
    {
        for (const UnityGameObject* object : hierarchy.objects())
        {
            const UnityInstance* component = object->FindScript(k_Volume);
            if (component == nullptr || !object->isActive)
            {
                continue;
            }
            const UnityReader reader = ReaderOf(*object, *component);
            Volume& volume = m_Asset.volumes.emplace_back();
            volume.name = object->drawn->name;
            volume.layer = object->drawn->layer;
            reader.Read("m_Enabled", volume.enabled);
            reader.Read(reader.Has("m_IsGlobal") ? "m_IsGlobal" : "isGlobal", volume.isGlobal);
            reader.Read("priority", volume.priority);
            reader.ReadIn("blendDistance", 0.0f, 1e9f, volume.blendDistance);
            reader.Read("weight", volume.weight);
            volume.position = object->drawn->transform.position();
            volume.rotation = object->drawn->transform.rotation();
            AddColliders(*object, volume);
            ReadProfile(reader, volume);
        }
    }

    void AddColliders(const UnityGameObject& object, Volume& volume)
    {
        for (const UnityInstance* component : object.components)
        {
            const UnityReader reader = ReaderOf(object, *component);
            if (component->classID == UnityClass::BoxCollider)
            {
                BoxCollider box;
                reader.Read("m_Enabled", box.enabled);
                reader.Read("m_Center", box.center);
                reader.Read("m_Size", box.size);
                volume.colliders.emplace_back(box);
            }
            else if (component->classID == UnityClass::SphereCollider)
            {
                SphereCollider sphere;
                reader.Read("m_Enabled", sphere.enabled);
                reader.Read("m_Center", sphere.center);
                reader.Read("m_Radius", sphere.radius);
                volume.colliders.emplace_back(sphere);
            }
            else if (component->classID == UnityClass::CapsuleCollider)
            {
                CapsuleCollider capsule;
                reader.Read("m_Enabled", capsule.enabled);
                reader.Read("m_Center", capsule.center);
                reader.Read("m_Radius", capsule.radius);
                reader.Read("m_Height", capsule.height);
                reader.ReadEnum("m_Direction", 2, capsule.direction);
                volume.colliders.emplace_back(capsule);
            }
        }
        const glm::dmat4 world = object.drawn->transform.worldMatrix();
        for (int axis = 0; axis < 3; ++axis)
        {
            volume.scale[axis] = static_cast<float>(glm::length(glm::dvec3(world[axis])));
        }
    }

    void ReadProfile(const UnityReader& reader, Volume& volume)
    {
        const UnityTarget target = reader.Reference("sharedProfile");
        const auto* path = target.asset.isNull() ? nullptr : m_Database.Find(target.asset.guid);
        if (path == nullptr)
        {
            if (!target.asset.isNull())
            {
                reader.Note("sharedProfile", "no file of the project has its guid " +
                                                 target.asset.guid +
                                                 ", so the volume does nothing");
            }
            return;
        }
        try
        {
            const VolumeProfileLoadResult& result = m_Assets.LoadProfile(*path, m_Asset.layers);
            volume.sharedProfile = result.profile;
            for (const Diagnostic& note : result.notes)
            {
                m_Notes.Add(note.file, note.location.line, note.message);
            }
        }
        catch (const AssetError& error)
        {
            Add(error);
        }
    }

    void CountOthers(const UnityHierarchy& hierarchy)
    {
        for (const UnityGameObject* object : hierarchy.objects())
        {
            for (const UnityInstance* component : object->components)
            {
                for (const auto& [number, what] : k_NotDrawn)
                {
                    if (static_cast<int>(component->classID) == number && object->isActive)
                    {
                        m_Notes.Count(what);
                    }
                }
            }
        }
    }

    void Add(const AssetError& error)
    {
        for (const Diagnostic& problem : error.diagnostics())
        {
            m_Notes.Add(problem.file, problem.location.line, problem.message);
        }
    }

    std::filesystem::path m_Path;
    AssetContext& m_Assets;
    UnityNotes m_Notes;
    UnityDatabase m_Database;
    UnityMaterials m_Materials;
    const UnityHierarchy* m_Hierarchy = nullptr;
    SceneAsset m_Asset;
    int m_RendererIndex = -1;
    float m_LodBias = 1.0f;
    std::set<const UnityInstance*> m_Hidden; ///< renderers of LODs that are not shown
    const UnityInstance* m_Sun = nullptr;
    bool m_IsSun = false; ///< the main light is the sun
};

} // namespace

std::filesystem::path FindFirstUnityScene(const std::filesystem::path& project)
{
    std::error_code unused;
    if (!std::filesystem::is_directory(project / "Assets", unused))
    {
        throw AssetError(project.generic_string(), {},
                         "this folder is no Unity project, which has a folder Assets; name a scene "
                         "file or the project's folder");
    }
    const FileContent build =
        TryReadFile(project / "ProjectSettings" / "EditorBuildSettings.asset");
    if (build.isRead() && IsUnityAsset(build.bytes))
    {
        const UnityFile file(build.bytes, (project / "ProjectSettings").generic_string());
        for (const UnityNode scene : file.Fields(file.headers().front())["m_Scenes"])
        {
            const std::filesystem::path path = project / std::string(scene["path"].text());
            std::error_code ignored;
            if (scene["enabled"].text() == "1" && std::filesystem::is_regular_file(path, ignored))
            {
                return path;
            }
        }
    }
    std::vector<std::filesystem::path> scenes;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(
             project / "Assets", std::filesystem::directory_options::skip_permission_denied,
             ignored))
    {
        if (entry.path().extension() == ".unity")
        {
            scenes.push_back(entry.path());
        }
    }
    if (scenes.size() == 1)
    {
        return scenes.front();
    }
    std::string paths;
    std::ranges::sort(scenes);
    for (const std::filesystem::path& scene : scenes)
    {
        paths += "\n  " + scene.lexically_relative(project).generic_string();
    }
    throw AssetError(project.generic_string(), {},
                     scenes.empty() ? "the project has no scene: there is no .unity file in Assets"
                                    : "the project's build settings name no scene that is there; "
                                      "name one of these .unity files:" +
                                          paths);
}

SceneAsset LoadUnityScene(const std::filesystem::path& path, AssetContext& assets)
{
    if (UnityProjectAround(path).empty())
    {
        throw AssetError(path.generic_string(), {},
                         "a .unity file is read within its project; no folder above it has an "
                         "Assets folder");
    }
    assets.Reach(path);
    assets.AddRootsAround(path);
    return UnitySceneReader(path, assets).Read();
}

} // namespace limn
