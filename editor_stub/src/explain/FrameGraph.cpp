#include "explain/ExplainedFrame.h"
#include "explain/TextLines.h"

#include <limn/base/RunProgram.h>

#include <limn/base/Diagnostic.h>
#include <limn/base/WriteFile.h>

#include <algorithm>
#include <system_error>

namespace limn
{

namespace
{

constexpr std::size_t k_LineLength = 46; ///< of a reason, letters

/// Returns the text as a label has it, in which commands of terminals are blanks.
std::string Escape(std::string text)
{
    std::ranges::replace_if(
        text, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    return MarkupText(text);
}

/// Returns the text in lines, which end at blanks.
std::string Wrap(const std::string& text)
{
    std::string result;
    std::size_t length = 0;
    for (std::size_t begin = 0; begin < text.size();)
    {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        const std::string word = text.substr(begin, end - begin);
        const bool breaks = length > 0 && length + word.size() > k_LineLength;
        result += (breaks ? "<BR/>" : length > 0 ? " " : "") + Escape(word);
        length = breaks ? word.size() : length + 1 + word.size();
        begin = end + 1;
    }
    return result;
}

std::string Small(const std::string& html)
{
    return "<FONT POINT-SIZE=\"10\">" + html + "</FONT>";
}

class GraphWriter
{
public:
    explicit GraphWriter(const ExplainedFrame& frame)
        : m_Frame(frame), m_Latest(frame.textures.size())
    {
    }

    std::string Write()
    {
        m_Text = "digraph frame\n{\n"
                 "    graph [rankdir=TB, nodesep=0.35, ranksep=0.32, bgcolor=\"white\", "
                 "fontname=\"Helvetica\"];\n"
                 "    node [fontname=\"Helvetica\", fontsize=12, margin=\"0.14,0.07\"];\n"
                 "    edge [fontname=\"Helvetica\", fontsize=10, color=\"#5b6470\", "
                 "fontcolor=\"#3d4550\", arrowsize=0.7];\n";
        std::size_t leftOut = 0;
        for (std::size_t i = 0; i <= m_Frame.passes.size(); ++i)
        {
            const bool isEnd = i == m_Frame.passes.size();
            for (; leftOut < m_Frame.leftOut.size() &&
                   (isEnd || m_Frame.leftOut[leftOut].place < m_Frame.passes[i].place);
                 ++leftOut)
            {
                AddLeftOut(leftOut);
            }
            if (!isEnd)
            {
                AddPass(i);
            }
        }
        return m_Text + "}\n";
    }

private:
    void AddPass(std::size_t index)
    {
        const ExplainedPass& pass = m_Frame.passes[index];
        const std::string node = "pass" + std::to_string(index + 1);
        const bool isClear = pass.draws == 0 && pass.dispatches == 0;
        const std::string counts = isClear ? "only clears" : DrawsText(pass);
        const std::string size =
            std::to_string(pass.width) + "×" + std::to_string(pass.height) + ", ";
        AddNode(node,
                "shape=box, style=\"filled\", fillcolor=\"#2f6f9f\", color=\"#1f4f74\", "
                "fontcolor=\"white\", group=passes",
                "<B>" + std::to_string(index + 1) + "&nbsp;&nbsp;" + Wrap(pass.name) + "</B><BR/>" +
                    Small((pass.dispatches > 0 ? "" : size) + counts + FilesText(pass)));
        Follow(node);
        for (const std::size_t texture : pass.reads)
        {
            if (m_Frame.textures[texture].isDrawn)
            {
                AddEdge(Latest(texture), node, "sample", "style=dashed");
            }
        }
        for (const ExplainedAttachment& target : pass.targets)
        {
            if (target.load == "load")
            {
                AddEdge(Latest(target.texture), node, "load", "");
            }
        }
        for (const ExplainedAttachment& target : pass.targets)
        {
            AddVersion(target, node, index);
        }
    }

    /// Adds the contents that a pass leaves in a texture.
    void AddVersion(const ExplainedAttachment& target, const std::string& pass, std::size_t index)
    {
        const bool isStored = target.store != "-";
        const std::string node =
            "texture" + std::to_string(target.texture) + "_" + std::to_string(index + 1);
        AddTexture(target.texture, node, isStored, isStored && IsResult(target.texture, index));
        AddEdge(pass, node,
                (target.load == "-" ? "" : target.load + ", ") +
                    (isStored ? target.store : "not stored"),
                isStored ? "" : "color=\"#b4bac2\", fontcolor=\"#8a929c\"");
        if (isStored)
        {
            m_Latest[target.texture] = node;
        }
    }

    bool IsResult(std::size_t texture, std::size_t pass) const
    {
        const bool isLast = std::none_of(
            m_Frame.passes.begin() + static_cast<std::ptrdiff_t>(pass) + 1, m_Frame.passes.end(),
            [&](const ExplainedPass& p) {
                return std::ranges::any_of(p.targets,
                                           [&](const auto& t) { return t.texture == texture; });
            });
        return m_Frame.textures[texture].isOutput && isLast;
    }

    void AddTexture(std::size_t index, const std::string& node, bool isKept, bool isResult)
    {
        const ExplainedTexture& texture = m_Frame.textures[index];
        const bool isDepth = texture.format.starts_with("D");
        const std::string fill = !isKept    ? "#f7f8f9"
                                 : isResult ? "#d8efd6"
                                 : isDepth  ? "#ece4f4"
                                            : "#fdf0d5";
        const std::string samples =
            texture.samples > 1 ? ", " + std::to_string(texture.samples) + " samples" : "";
        AddNode(node,
                "shape=box, style=\"filled,rounded" + std::string(isKept ? "" : ",dashed") +
                    "\", fillcolor=\"" + fill + "\", color=\"" + (isKept ? "#8b8f99" : "#b4bac2") +
                    "\", fontcolor=\"" + (isKept ? "#20242a" : "#8a929c") + "\", fontsize=11",
                Escape(texture.name) + "<BR/>" +
                    Small(texture.size + " " + texture.format + samples + "<BR/>" +
                          BytesText(texture.bytes) + (isResult ? ", the result" : "")));
    }

    /// The node that holds what was last left in the texture; of a frame before, one of its own.
    const std::string& Latest(std::size_t texture)
    {
        if (m_Latest[texture].empty())
        {
            m_Latest[texture] = "texture" + std::to_string(texture) + "_0";
            AddTexture(texture, m_Latest[texture], true, false);
        }
        return m_Latest[texture];
    }

    std::string FilesText(const ExplainedPass& pass) const
    {
        const auto count = static_cast<std::size_t>(std::ranges::count_if(
            pass.reads, [this](std::size_t t) { return !m_Frame.textures[t].isDrawn; }));
        return count == 0 ? "" : ", " + CountText(count, "texture") + " given";
    }

    void AddLeftOut(std::size_t index)
    {
        const LeftOut& item = m_Frame.leftOut[index];
        const std::string node = "leftout" + std::to_string(index + 1);
        const std::string targets =
            (item.targets.empty() ? "" : " → ") + Joined(item.targets, ", ");
        AddNode(node,
                "shape=box, style=\"filled,dashed\", fillcolor=\"#f0f1f3\", color=\"#a9afb8\", "
                "fontcolor=\"#767e89\", group=passes",
                Wrap((item.pass.empty() ? "a pass" : item.pass) + targets) + "<BR/>" +
                    Small("<I>left out: " + Wrap(item.reason) + "</I>"));
        Follow(node);
    }

    void AddNode(const std::string& node, const std::string& look, const std::string& html)
    {
        m_Text += "    " + node + " [" + look + ", label=<" + html + ">];\n";
    }

    void AddEdge(const std::string& from, const std::string& to, const std::string& label,
                 const std::string& look)
    {
        m_Text += "    " + from + " -> " + to + " [label=\" " + label + "\"" +
                  (look.empty() ? "" : ", " + look) + "];\n";
    }

    /// Keeps the column of passes in its order.
    void Follow(const std::string& node)
    {
        if (!m_LastPass.empty())
        {
            m_Text += "    " + m_LastPass + " -> " + node + " [style=invis, weight=20];\n";
        }
        m_LastPass = node;
    }

    const ExplainedFrame& m_Frame;
    std::vector<std::string> m_Latest; ///< nodes, by texture; "" = nothing in it is known
    std::string m_LastPass;
    std::string m_Text;
};

/// Runs `dot -T<format>`. @return what it prints
std::string RunDot(const std::string& format, const std::string& graph,
                   const std::filesystem::path& path)
{
    try
    {
        return RunProgram({"dot", "-T" + format}, graph,
                          "the program 'dot' draws graphs, and cannot be started (Debian: "
                          "apt install graphviz; a file that ends in .dot needs none)");
    }
    catch (const std::system_error&)
    {
        throw;
    }
    catch (const std::runtime_error& error)
    {
        throw AssetError(path.string(), {}, error.what());
    }
}

} // namespace

std::string FrameGraph(const ExplainedFrame& frame)
{
    return GraphWriter(frame).Write();
}

bool IsGraphFile(const std::filesystem::path& path)
{
    return IsIn(path.extension().string(), {".dot", ".svg", ".png", ".pdf"});
}

void WriteGraph(const std::filesystem::path& path, const std::string& graph)
{
    const std::string format = path.extension().string().substr(1);
    WriteFile(path, format == "dot" ? graph : RunDot(format, graph, path));
}

} // namespace limn
