#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace limn::test
{

/// A file of tests/shaderlab/corpus and what is written beside it about reading it.
struct CorpusFile
{
    std::string name; ///< "state/cull_off"
    std::string text;
    std::optional<std::string> document;  ///< NAME.expected.shader, canonical ShaderLab
    std::vector<std::string> diagnostics; ///< NAME.diagnostics: "line:column: error: …"

    bool hasErrors() const;
};

/// The folder of the corpus.
std::filesystem::path CorpusFolder();

/// All files of the corpus in the order of their names.
const std::vector<CorpusFile>& CorpusFiles();

} // namespace limn::test
