#include "ShaderTestSupport.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace limn::test
{

namespace
{

// What Unity's files of these names guard themselves with; shaders ask which files are there by it.
constexpr std::pair<const char*, const char*> k_Guards[] = {
    {"AutoLight.cginc", "AUTOLIGHT_INCLUDED"},
    {"HLSLSupport.cginc", "HLSL_SUPPORT_INCLUDED"},
    {"Lighting.cginc", "LIGHTING_INCLUDED"},
    {"TerrainEngine.cginc", "TERRAIN_ENGINE_INCLUDED"},
    {"TerrainPreview.cginc", "TERRAIN_PREVIEW_INCLUDED"},
    {"TerrainSplatmapCommon.cginc", "TERRAIN_SPLATMAP_COMMON_CGINC_INCLUDED"},
    {"TerrainTool.cginc", "TERRAIN_TOOL_INCLUDED"},
    {"UnityBuiltin3xTreeLibrary.cginc", "UNITY_BUILTIN_3X_TREE_LIBRARY_INCLUDED"},
    {"UnityCG.cginc", "UNITY_CG_INCLUDED"},
    {"UnityCustomRenderTexture.cginc", "UNITY_CUSTOM_TEXTURE_INCLUDED"},
    {"UnityDeferredLibrary.cginc", "UNITY_DEFERRED_LIBRARY_INCLUDED"},
    {"UnityGBuffer.cginc", "UNITY_GBUFFER_INCLUDED"},
    {"UnityGlobalIllumination.cginc", "UNITY_GLOBAL_ILLUMINATION_INCLUDED"},
    {"UnityImageBasedLighting.cginc", "UNITY_IMAGE_BASED_LIGHTING_INCLUDED"},
    {"UnityInstancing.cginc", "UNITY_INSTANCING_INCLUDED"},
    {"UnityLightingCommon.cginc", "UNITY_LIGHTING_COMMON_INCLUDED"},
    {"UnityMetaPass.cginc", "UNITY_META_PASS_INCLUDED"},
    {"UnityPBSLighting.cginc", "UNITY_PBS_LIGHTING_INCLUDED"},
    {"UnityShaderUtilities.cginc", "UNITY_SHADER_UTILITIES_INCLUDED"},
    {"UnityShaderVariables.cginc", "UNITY_SHADER_VARIABLES_INCLUDED"},
    {"UnityShadowLibrary.cginc", "UNITY_BUILTIN_SHADOW_LIBRARY_INCLUDED"},
    {"UnitySprites.cginc", "UNITY_SPRITES_INCLUDED"},
    {"UnityStandardBRDF.cginc", "UNITY_STANDARD_BRDF_INCLUDED"},
    {"UnityStandardConfig.cginc", "UNITY_STANDARD_CONFIG_INCLUDED"},
    {"UnityStandardCore.cginc", "UNITY_STANDARD_CORE_INCLUDED"},
    {"UnityStandardCoreForward.cginc", "UNITY_STANDARD_CORE_FORWARD_INCLUDED"},
    {"UnityStandardCoreForwardSimple.cginc", "UNITY_STANDARD_CORE_FORWARD_SIMPLE_INCLUDED"},
    {"UnityStandardInput.cginc", "UNITY_STANDARD_INPUT_INCLUDED"},
    {"UnityStandardMeta.cginc", "UNITY_STANDARD_META_INCLUDED"},
    {"UnityStandardParticleEditor.cginc", "UNITY_STANDARD_PARTICLE_EDITOR_INCLUDED"},
    {"UnityStandardParticleInstancing.cginc", "UNITY_STANDARD_PARTICLE_INSTANCING_INCLUDED"},
    {"UnityStandardParticleShadow.cginc", "UNITY_STANDARD_PARTICLE_SHADOW_INCLUDED"},
    {"UnityStandardParticles.cginc", "UNITY_STANDARD_PARTICLES_INCLUDED"},
    {"UnityStandardShadow.cginc", "UNITY_STANDARD_SHADOW_INCLUDED"},
    {"UnityStandardUtils.cginc", "UNITY_STANDARD_UTILS_INCLUDED"},
    {"UnityUI.cginc", "UNITY_UI_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/ShaderLibrary/ACES.hlsl", "__ACES__"},
    {"Packages/com.unity.render-pipelines.core/ShaderLibrary/BSDF.hlsl", "UNITY_BSDF_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/ShaderLibrary/Color.hlsl", "UNITY_COLOR_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl", "UNITY_COMMON_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonLighting.hlsl",
     "UNITY_COMMON_LIGHTING_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonMaterial.hlsl",
     "UNITY_COMMON_MATERIAL_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/ShaderLibrary/EntityLighting.hlsl",
     "UNITY_ENTITY_LIGHTING_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/ShaderLibrary/Filtering.hlsl",
     "UNITY_FILTERING_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/ShaderLibrary/FoveatedRendering.hlsl",
     "UNITY_FOVEATED_RENDERING_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/ShaderLibrary/GeometricTools.hlsl",
     "UNITY_GEOMETRICTOOLS_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/ShaderLibrary/GlobalSamplers.hlsl",
     "UNITY_CORE_SAMPLERS_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/ShaderLibrary/ImageBasedLighting.hlsl",
     "UNITY_IMAGE_BASED_LIGHTING_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/ShaderLibrary/Macros.hlsl", "UNITY_MACROS_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/ShaderLibrary/NormalSurfaceGradient.hlsl",
     "UNITY_NORMAL_SURFACE_GRADIENT_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/ShaderLibrary/Packing.hlsl",
     "UNITY_PACKING_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/ShaderLibrary/Random.hlsl", "UNITY_RANDOM_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/ShaderLibrary/SpaceTransforms.hlsl",
     "UNITY_SPACE_TRANSFORMS_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/ShaderLibrary/SphericalHarmonics.hlsl",
     "UNITY_SPHERICAL_HARMONICS_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/ShaderLibrary/TextureXR.hlsl",
     "UNITY_TEXTUREXR_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/ShaderLibrary/UnityInstancing.hlsl",
     "UNITY_INSTANCING_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/ShaderLibrary/VolumeRendering.hlsl",
     "UNITY_VOLUME_RENDERING_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl",
     "UNITY_CORE_BLIT_INCLUDED"},
    {"Packages/com.unity.render-pipelines.core/Runtime/Utilities/BlitColorAndDepth.hlsl",
     "UNITY_CORE_BLIT_COLOR_AND_DEPTH_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/AmbientOcclusion.hlsl",
     "AMBIENT_OCCLUSION_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/BRDF.hlsl",
     "UNIVERSAL_BRDF_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Clustering.hlsl",
     "UNIVERSAL_CLUSTERING_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl",
     "UNIVERSAL_PIPELINE_CORE_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/DBuffer.hlsl",
     "UNIVERSAL_DBUFFER_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareDepthTexture.hlsl",
     "UNITY_DECLARE_DEPTH_TEXTURE_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareNormalsTexture.hlsl",
     "UNITY_DECLARE_NORMALS_TEXTURE_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareOpaqueTexture.hlsl",
     "UNITY_DECLARE_OPAQUE_TEXTURE_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Deprecated.hlsl",
     "UNIVERSAL_DEPRECATED_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/GlobalIllumination.hlsl",
     "UNIVERSAL_GLOBAL_ILLUMINATION_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Input.hlsl",
     "UNIVERSAL_INPUT_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/LODCrossFade.hlsl",
     "UNIVERSAL_PIPELINE_LODCROSSFADE_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/LightCookie/LightCookie.hlsl",
     "UNIVERSAL_LIGHT_COOKIE_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl",
     "UNIVERSAL_LIGHTING_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/MetaInput.hlsl",
     "UNIVERSAL_META_INPUT_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Particles.hlsl",
     "UNIVERSAL_PARTICLES_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/ParticlesInstancing.hlsl",
     "UNIVERSAL_PARTICLESINSTANCING_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/RealtimeLights.hlsl",
     "UNIVERSAL_REALTIME_LIGHTS_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/RenderingLayers.hlsl",
     "UNIVERSAL_RENDERING_LAYERS_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/ShaderGraphFunctions.hlsl",
     "UNITY_GRAPHFUNCTIONS_LW_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/ShaderVariablesFunctions.hlsl",
     "UNITY_SHADER_VARIABLES_FUNCTIONS_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Shadows.hlsl",
     "UNIVERSAL_SHADOWS_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/SurfaceData.hlsl",
     "UNIVERSAL_SURFACE_DATA_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/SurfaceInput.hlsl",
     "UNIVERSAL_INPUT_SURFACE_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/UnityGBuffer.hlsl",
     "UNIVERSAL_GBUFFERUTIL_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/UnityInput.hlsl",
     "UNIVERSAL_SHADER_VARIABLES_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/UniversalMetaPass.hlsl",
     "UNIVERSAL_META_PASS_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Unlit.hlsl",
     "UNIVERSAL_UNLIT_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Debug/Debugging3D.hlsl",
     "UNIVERSAL_DEBUGGING3D_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Debug/DebuggingCommon.hlsl",
     "UNIVERSAL_DEBUGGING_COMMON_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/Shaders/BakedLitForwardPass.hlsl",
     "UNIVERSAL_BAKEDLIT_FORWARD_PASS_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/Shaders/BakedLitInput.hlsl",
     "UNIVERSAL_BAKEDLIT_INPUT_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/Shaders/DepthOnlyPass.hlsl",
     "UNIVERSAL_DEPTH_ONLY_PASS_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/Shaders/LitDepthNormalsPass.hlsl",
     "UNIVERSAL_FORWARD_LIT_DEPTH_NORMALS_PASS_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/Shaders/LitForwardPass.hlsl",
     "UNIVERSAL_FORWARD_LIT_PASS_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/Shaders/LitGBufferPass.hlsl",
     "UNIVERSAL_LIT_GBUFFER_PASS_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/Shaders/LitInput.hlsl",
     "UNIVERSAL_LIT_INPUT_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/Shaders/LitMetaPass.hlsl",
     "UNIVERSAL_LIT_META_PASS_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/Shaders/ShadowCasterPass.hlsl",
     "UNIVERSAL_SHADOW_CASTER_PASS_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/Shaders/SimpleLitForwardPass.hlsl",
     "UNIVERSAL_SIMPLE_LIT_PASS_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/Shaders/SimpleLitGBufferPass.hlsl",
     "UNIVERSAL_SIMPLE_LIT_GBUFFER_PASS_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/Shaders/SimpleLitInput.hlsl",
     "UNIVERSAL_SIMPLE_LIT_INPUT_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/Shaders/UnlitForwardPass.hlsl",
     "URP_UNLIT_FORWARD_PASS_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/Shaders/UnlitInput.hlsl",
     "UNIVERSAL_UNLIT_INPUT_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/Shaders/UnlitMetaPass.hlsl",
     "UNIVERSAL_UNLIT_META_PASS_INCLUDED"},
    {"Packages/com.unity.render-pipelines.universal/Shaders/PostProcessing/Common.hlsl",
     "UNIVERSAL_POSTPROCESSING_COMMON_INCLUDED"},
};

} // namespace

TEST(ShaderLibrary, DefinesTheGuardsOfUnitysFiles)
{
    for (const auto& [file, guard] : k_Guards)
    {
        const std::string name(file);
        const bool isCg = name.ends_with(".cginc");
        // Files that are parts of passes need more than themselves to compile; that they define
        // the name shows behind the #error that it stops at.
        const std::string text = std::string("#include \"") + file + "\"\n#ifdef " + guard +
                                 "\n#error \"the guard is there\"\n#endif\n"
                                 "float4 vert() : SV_Position { return 0; }\n"
                                 "float4 frag() : SV_Target { return 0; }\n";
        bool isThere = false;
        for (const std::string& message :
             CompileMessages(Program(text, isCg ? ProgramLanguage::Cg : ProgramLanguage::Hlsl)))
        {
            isThere = isThere || message.find("the guard is there") != message.npos;
        }
        EXPECT_TRUE(isThere) << file << ": " << guard;
    }
}

} // namespace limn::test
