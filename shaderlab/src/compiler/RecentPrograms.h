#pragma once

#include <limn/shaderlab/ShaderProgram.h>

#include <algorithm>
#include <list>
#include <memory>
#include <mutex>
#include <string>

namespace limn
{

/// The programs compiled last. A shader that is made anew, such as a feature's for its next
/// picture, gets the same object, for which the device has its pipelines already.
class RecentPrograms
{
public:
    /// Returns an equal program of the same key, or `program` itself.
    std::shared_ptr<const ShaderProgram> Share(const std::string& key, ShaderProgram program)
    {
        const std::lock_guard lock(m_Mutex);
        auto found = std::ranges::find(m_Programs, key, &Entry::key);
        if (found == m_Programs.end())
        {
            m_Programs.push_front({key, nullptr});
            found = m_Programs.begin();
        }
        if (found->program == nullptr || *found->program != program)
        {
            found->program = std::make_shared<const ShaderProgram>(std::move(program));
        }
        m_Programs.splice(m_Programs.begin(), m_Programs, found);
        m_Programs.resize(std::min(m_Programs.size(), k_Most));
        return m_Programs.front().program;
    }

private:
    static constexpr std::size_t k_Most = 128;
    struct Entry
    {
        std::string key;
        std::shared_ptr<const ShaderProgram> program;
    };

    std::mutex m_Mutex;
    std::list<Entry> m_Programs; ///< the last used first
};

} // namespace limn
