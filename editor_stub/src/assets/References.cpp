#include "assets/References.h"

#include "assets/FileKind.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/ComputeShader.h>
#include <limn/features/Features.h>

namespace limn
{

namespace
{

bool BeginsAsPng(const std::filesystem::path& path)
{
    constexpr std::string_view k_Signature = "\x89PNG\r\n\x1A\n";
    std::array<char, k_Signature.size()> begin{};
    std::error_code error; // of a pipe the opening would wait
    return std::filesystem::is_regular_file(path, error) &&
           std::ifstream(path, std::ios::binary).read(begin.data(), begin.size()) &&
           std::string_view(begin.data(), begin.size()) == k_Signature;
}

} // namespace

References::References(AssetContext& assets, std::vector<std::filesystem::path> folders,
                       AssetDiagnostics& diagnostics, ReferenceScope scope)
    : m_Assets(assets), m_Folders(std::move(folders)), m_Diagnostics(diagnostics), m_Scope(scope)
{
    for (const std::filesystem::path& folder : m_Folders)
    {
        m_OwnRoots.Add(folder);
    }
}

std::filesystem::path References::Resolve(const std::string& text) const
{
    for (const std::filesystem::path& folder : m_Folders)
    {
        std::error_code ignored;
        if (std::filesystem::exists(folder / text, ignored))
        {
            return folder / text;
        }
    }
    return m_Folders.empty() ? std::filesystem::path(text) : m_Folders.front() / text;
}

bool References::isAllowed(const std::filesystem::path& path, const YamlNode& node,
                           std::string_view subject)
{
    const bool isInside = m_Scope == ReferenceScope::Anywhere || m_OwnRoots.Contains(path) ||
                          m_Assets.roots().Contains(path);
    if (!isInside)
    {
        const std::string which = node.isScalar() ? "'" + node.scalar() + "'" : "the file";
        m_Diagnostics.Error(node.location(),
                            std::string(subject) + ": " + which + " " + k_OutsideRoots);
    }
    return isInside;
}

std::shared_ptr<const Shader> References::ReadShader(const YamlNode& node,
                                                     const std::string& subject)
{
    if (std::filesystem::path(node.scalar()).extension() == ".shader")
    {
        return Read(node, subject,
                    [this](const std::filesystem::path& path)
                    { return m_Assets.LoadShader(path); });
    }
    const std::optional<std::string> name = ReadString(node, subject, m_Diagnostics);
    std::shared_ptr<const Shader> shader = name ? m_Assets.FindShader(*name) : nullptr;
    if (name && !shader)
    {
        m_Diagnostics.Error(node.location(), subject + ": unknown shader " +
                                                 UnknownName(*name, ShippedShaders().names()) +
                                                 " (a file's path ends in '.shader')");
    }
    return shader;
}

std::shared_ptr<const Texture2D> References::ReadPicture(const YamlNode& node,
                                                         const std::string& subject)
{
    return Read(node, subject,
                [this](const std::filesystem::path& path)
                {
                    return decodesPictures || !BeginsAsPng(path)
                               ? m_Assets.LoadTexture(path)
                               : std::dynamic_pointer_cast<const Texture2D>(
                                     DefaultTexture("white"));
                });
}

std::shared_ptr<const ComputeShader> References::ReadComputeShader(const YamlNode& node,
                                                                   const std::string& subject)
{
    return Read(node, subject,
                [this](const std::filesystem::path& path)
                {
                    m_Assets.Reach(path);
                    return std::shared_ptr<const ComputeShader>(
                        ComputeShader::Load(path, m_Assets.compiler()));
                });
}

void References::Report(const YamlNode& node, std::string_view subject, const AssetError& error)
{
    const std::string which = node.isScalar() ? "'" + node.scalar() + "'" : "the file";
    m_Diagnostics.Error(node.location(), std::string(subject) + ": " + which +
                                             " cannot be used; see the errors of that file");
    m_Failures.push_back({node.location(), error.diagnostics()});
}

bool References::isThere(const std::filesystem::path& path, const std::string& text,
                         const YamlNode& node, std::string_view subject)
{
    std::error_code ignored;
    const std::string nearest = std::filesystem::exists(path, ignored) ? "" : NearestFile(path);
    if (!nearest.empty())
    {
        m_Diagnostics.Error(
            node.location(),
            std::string(subject) + ": there is no file '" + text + "'; did you mean '" +
                (std::filesystem::path(text).parent_path() / nearest).generic_string() + "'?");
    }
    return nearest.empty();
}

void References::ThrowIfErrors() const
{
    std::vector<Diagnostic> all;
    try
    {
        m_Diagnostics.ThrowIfErrors();
        return;
    }
    catch (const AssetError& error)
    {
        for (const Diagnostic& diagnostic : error.diagnostics())
        {
            all.push_back(diagnostic);
            for (const Failure& failure : m_Failures)
            {
                const bool isHere = failure.location == diagnostic.location;
                // A file that is referred to twice has its errors listed once.
                const bool isNew =
                    isHere && std::ranges::find(all, failure.errors.front()) == all.end();
                if (isNew)
                {
                    all.insert(all.end(), failure.errors.begin(), failure.errors.end());
                }
            }
        }
    }
    throw AssetError(std::move(all));
}

} // namespace limn
