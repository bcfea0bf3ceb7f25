#pragma once

#include <filesystem>
#include <limn/volume/ProfileContext.h>
#include <limn/volume/VolumeComponentRegistry.h>
#include <limn/volume/VolumeProfile.h>
#include <memory>
#include <string>
#include <vector>

namespace limn
{

struct VolumeProfileLoadResult
{
    std::shared_ptr<VolumeProfile> profile;
    std::vector<Diagnostic> notes; ///< the parts of a Unity asset that were ignored, Severity::Note
};

/// Loads a profile from a file that a person wrote,
///
///     ScreenSpaceOutline:      # a component
///       active: true           # may be left out
///       outlineWidth: 4        # or m_OutlineWidth; naming a parameter overrides it
///
/// or from a VolumeProfile asset as Unity saves it, which is recognised by its content, not by its
/// name. A Unity asset may hold components and parameters that limn does not know; they become
/// notes.
///
/// References of overridden parameters are loaded if the context does that.
/// @param context  resolves names of layers and loads references; used only in this call
/// @throws AssetError with every problem of the file: broken YAML, unknown component or parameter
///     (not in Unity's form), a value of the wrong type or outside its range, a name given twice, a
///     reference that cannot be loaded
VolumeProfileLoadResult LoadVolumeProfile(const std::filesystem::path& path,
                                          const VolumeComponentRegistry& registry,
                                          const ProfileContext& context = {});

/// Loads a profile like LoadVolumeProfile, from a text that is the content of `file`.
VolumeProfileLoadResult ParseVolumeProfile(std::string_view text, const std::string& file,
                                           const VolumeComponentRegistry& registry,
                                           const ProfileContext& context = {});

/// The two forms of a profile's YAML.
enum class YamlForm
{
    Limn, ///< component, parameter, value; only overridden parameters
    Unity ///< a VolumeProfile asset; every parameter with m_OverrideState and m_Value
};

/// Returns the text of a profile file, which LoadVolumeProfile reads back to the same overrides and
/// values. limn's form has no name of the profile, because the file's name is its name. Unity's
/// gives every component a fileID that depends on its type alone, and refers to no script, since
/// only Unity knows its guid.
/// @throws ContractError if the registry lacks the type of a component
std::string WriteVolumeProfile(const VolumeProfile& profile,
                               const VolumeComponentRegistry& registry, YamlForm form);

} // namespace limn
