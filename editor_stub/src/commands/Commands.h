#pragma once

#include "console/Console.h"
#include "view/RenderOptions.h"

#include <limn/editor_stub/RunLimn.h>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace limn
{

/// Draws the scene into a PNG file.
/// @return BadInput if a validation layer reported errors
/// @throws AssetError, VulkanError, and then writes nothing
ExitCode RunRender(const RenderOptions& options, Console& console);

/// Draws the scene into a PNG file, and again whenever a file that it reaches changes, until SIGINT
/// or SIGTERM. If something is wrong with a file, that is printed and the last good picture stays.
/// `frames`, `statsFile` and `traceFile` of the options have no effect.
/// @return ExitCode::Done
/// @throws AssetError if the scene file or the output's folder is missing when it starts
/// @throws VulkanError
ExitCode RunWatch(const RenderOptions& options, Console& console);

/// The arguments of `limn inspect`.
struct InspectOptions
{
    /// The path of a scene, a profile, or a renderer, pipeline or material of Unity's, or the name
    /// of a volume component, a feature's type or a shader.
    std::string file;
    bool json = false;
    std::vector<std::string> plugins; ///< modules with features of other people
    std::vector<std::string> roots;
};

struct InspectReport;

/// Returns what RunInspect prints. Notes go to the console.
/// @throws AssetError
InspectReport InspectFile(const InspectOptions& options, Console& console);

/// Prints what the file sets: the parameters of volumes' components and the settings of features,
/// each with its value, default and range. For a component, feature or shader it prints what can be
/// set. Needs no device and compiles nothing.
/// @return ExitCode::Done
/// @throws AssetError
ExitCode RunInspect(const InspectOptions& options, Console& console);

/// The arguments of `limn explain`.
struct ExplainOptions
{
    /// The options of rendering. Their device draws only if a pixel is asked about.
    RenderOptions rendering;
    std::string object; ///< "" for all objects
    std::string pixel;  ///< as ParsePixel takes it; "" if none is asked about
    bool json = false;
    std::string graph; ///< the file for the frame as a picture; "" for none
};

/// Prints what a scene's frame draws and why: volume values, passes, textures, variants, objects;
/// or what becomes of the draws at one pixel.
/// @throws AssetError, also if the scene has no object of that name with a mesh
/// @throws VulkanError only if a pixel is asked about
ExitCode RunExplain(const ExplainOptions& options, Console& console);

/// The arguments of `limn check`.
struct CheckOptions
{
    RenderOptions rendering;
    std::string expectations; ///< the file that states them
    std::string junit;        ///< the file for the results as JUnit XML; "" for none
    bool json = false;
    bool isUpdate = false; ///< writes anew what does not hold
};

/// Compares a scene's frame with what a file expects of it, and prints what differs. Needs no
/// device.
/// @return BadInput if an expectation does not hold
/// @throws AssetError, also for unknown names in the expectations; nothing is then written
ExitCode RunCheck(const CheckOptions& options, Console& console);

/// The arguments of `limn report`.
struct ReportCommandOptions
{
    std::vector<std::string> paths; ///< the scene, or folders of studies
    std::string output;             ///< the study's folder
    bool isQuick = false;
    bool isFull = false; ///< tries every combination of extreme inputs
    bool hasStability = false;
    std::vector<std::string> techniques;
    std::optional<double> budget; ///< milliseconds
    int shard = 1;                ///< 1...shards
    int shards = 1;
    bool isMerge = false;
    bool isCompare = false;
    bool json = false;
};

/// Measures the error and the cost of outline techniques in a scene, and writes a report.
/// @param render  the picture's size, the device, caches, packages and roots
/// @return BadInput if merged parts lack cells, or compared ones differ
/// @throws AssetError, VulkanError; results that were measured before stay in the folder
ExitCode RunReport(RenderOptions render, const ReportCommandOptions& options, Console& console);

/// The arguments of `limn set`.
struct SetOptions
{
    std::string file;               ///< a scene, or a profile or renderer of limn's or Unity's form
    std::vector<std::string> edits; ///< "NAME.path=value"; empty with `undo`
    std::vector<std::string> plugins; ///< modules with features of other people
    bool undo = false;
    bool json = false;
};

/// Changes a profile's parameters, or the settings of a scene's or renderer's features, in place,
/// and prints their old values. It makes all of the changes or none. With `undo` it brings back the
/// text from before the last change of the file, which is kept in the user's cache folder.
/// @throws AssetError as SetScalars and SetFeatureSettings do, and if nothing can be undone
ExitCode RunSet(const SetOptions& options, Console& console);

/// Prints the JSON Schema (draft 2020-12) of one kind of file.
/// @param kind     "scene", "profile" or "material"
/// @param plugins  modules whose features and components the schema has
/// @throws AssetError if a plug-in cannot be used
ExitCode RunSchema(const std::string& kind, std::span<const std::string> plugins, Console& console);

/// The arguments of `limn shader`.
struct ShaderOptions
{
    std::vector<std::string> paths; ///< files, and folders for the .shader files below them;
                                    ///< or .compute files
    std::string emit;               ///< "", "spirv", "glsl", "glsles", "msl" or "hlsl"
    std::string outputFolder;       ///< the folder for emitted code
    /// The keywords that are on; empty = those of a new material.
    std::vector<std::string> keywords;
    int jobs = 0; ///< threads; 0 = one a core
    bool parseOnly = false;
    bool variants = false; ///< counts variants and compiles nothing
    bool print = false;    ///< prints the files as canonical text and nothing else
    bool json = false;
    std::map<std::string, std::string> packages;
    std::vector<std::string> roots;
};

/// Checks ShaderLab files and describes them; compiles the kernels of .compute files.
/// @return BadInput if a file has an error
/// @throws AssetError if a path is missing or something cannot be written
ExitCode RunShader(const ShaderOptions& options, Console& console);

/// The arguments of `limn new`.
struct NewOptions
{
    std::string kind;                  ///< "feature", "scene", "profile" or "material"
    std::string name;                  ///< the name of a feature's classes, or of the file
    std::vector<std::string> contents; ///< a profile's components, or the material's one shader
    std::string folder;                ///< the feature's folder, which is made if it is not there
    std::string style; ///< a feature's style: urp14 or "" for Execute, unity6 for RecordRenderGraph
};

/// Writes the folder of a render feature that builds and draws at once (component, feature, pass,
/// shader, scene, test), or a scene with its profile, a profile or a material. No file is replaced.
/// @return WrongUsage for a name that cannot be a class, and for options of other
/// kinds
/// @throws AssetError if a file cannot be written or is there already, the folder is not empty, or
///     a component or shader is unknown
ExitCode RunNew(const NewOptions& options, Console& console);

/// The arguments of `limn port`.
struct PortOptions
{
    std::vector<std::string> files; ///< C# files; not empty
    std::string folder;             ///< made if it is not there
};

/// Writes the folder of a plug-in with the beginning of a Unity render feature in C++, and reports
/// which parts of the C# limn does not have or know. Reads further files of the Unity project,
/// which declare what the files use.
/// @throws AssetError if a file is no C#, no file has a feature, or the folder cannot be written
ExitCode RunPort(const PortOptions& options, Console& console);

/// Prints what limn finds on this machine.
/// @param device  the wanted device, as VulkanDeviceOptions::device
/// @return MachineLacksIt if no device can be used
ExitCode RunDoctor(const std::string& device, bool wantsJson, Console& console);

/// Prints limn's version, in JSON with those of the libraries.
ExitCode RunVersion(bool wantsJson, Console& console);

} // namespace limn
