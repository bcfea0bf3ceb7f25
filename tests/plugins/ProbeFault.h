#pragma once

namespace probe
{

/// Where the plug-in of the tests throws.
enum class Fault
{
    None,
    Create,
    AddRenderPasses,
    Culling,
    Setup,
    Execute,
    Nameless,
    Draw,
    File,
    RecordRenderGraph,
    RenderFunction,
    Describe,
    Constructor,
    Blend,
    Registration,
    ComponentConstructor
};

/// Behind this text the module has '0' + the fault that it has for whatever settings: where tests
/// write another letter, it is as if it were built from a changed source.
inline constexpr char k_FaultMark[] = "limn probe fault ";

} // namespace probe
