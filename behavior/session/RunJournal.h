// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "behavior/session/RunBeginning.h"
#include "behavior/session/Session.h"

namespace crowd::behavior {

/// What a session was told since it began, and at which of its steps: told the same once more, a
/// session of the same beginning is at each step what that one was, bit for bit. The scenes that it
/// was told are kept, with the columns that they share. One thread.
class RunJournal
{
public:
    using Act = std::function<void(Session& session)>;

    /// `beginning`: of an earlier run; nothing: people begin as the scene has them.
    RunJournal(const model::Scene& scene, double startSeconds,
               std::shared_ptr<const WalkSurface> surface,
               std::optional<RunBeginning> beginning = std::nullopt);

    /// Told before the step after `step` was made; steps come in ascending order.
    void add(std::uint64_t step, Act act);
    /// The same, of an act that holds this scene.
    void add(std::uint64_t step, Act act, const model::Scene& scene);
    /// What was told at this step or later was not.
    void forgetFrom(std::uint64_t step);
    /// Where it has become too much, nothing is kept from now on.
    void limit();
    /// All is there since the beginning; once it is not, it never is again.
    [[nodiscard]] bool isWhole() const { return m_isWhole; }

    /// As the session was when it began.
    [[nodiscard]] std::unique_ptr<Session> begin() const;
    /// Tells a session of that beginning what was told at the step at which it is.
    void tell(Session& session) const;

private:
    struct Entry
    {
        std::uint64_t step = 0;
        Act act;
        std::size_t bytes = 0;
    };

    void keep(Entry entry);

    const std::shared_ptr<const model::Scene> m_scene;
    const double m_startSeconds;
    const std::shared_ptr<const WalkSurface> m_surface;
    const std::optional<RunBeginning> m_beginning;
    std::vector<Entry> m_entries;
    model::Population m_lastPeople; ///< of the scene that was told last
    std::size_t m_bytes = 0;
    bool m_isWhole = true;
};

} // namespace crowd::behavior
