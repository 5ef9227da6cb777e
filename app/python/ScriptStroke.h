// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "model/brush/PropertyChange.h"

namespace crowd::app {

/// One dab of a script brush, on its way from the stroke to Python.
struct ScriptDab
{
    std::vector<model::IndividualId> ids; ///< ascending, all present when it was made
    std::uint64_t seed = 0;
    model::StrokeLine line;
    std::optional<float> heading;
};

/// A stroke of a script brush between the document's thread, which selects, and the one that runs
/// Python. Dabs wait here for Python; Python reaches the stroke's edit through here, on the
/// document's thread alone. Outlives the stroke where Python still holds it.
class ScriptStrokeLink : public model::ScriptChange,
                         public std::enable_shared_from_this<ScriptStrokeLink>
{
public:
    // The document's thread.
    [[nodiscard]] model::ChangeResult change(const model::ChangeRequest& request) override;
    void close();   ///< there are no more dabs
    void abandon(); ///< the stroke is taken back: its edit is gone
    [[nodiscard]] model::SceneEdit* edit() const { return m_edit; } ///< null: gone, or no dab yet

    // Python's thread.
    enum class Wait { Dab, End, Nothing };
    /// The next dab, waiting a moment for it.
    [[nodiscard]] Wait next(ScriptDab& dab);
    void report(double share); ///< of the dab that was taken last

    /// Any thread: how far it is.
    struct Progress
    {
        int taken = 0;
        int waiting = 0;
        double share = 0.0; ///< of the one that was taken last
    };
    [[nodiscard]] Progress progress() const;

private:
    model::SceneEdit* m_edit = nullptr;
    mutable std::mutex m_mutex;
    std::condition_variable m_wake;
    std::deque<ScriptDab> m_dabs;
    bool m_isClosed = false;
    int m_taken = 0;
    double m_share = 0.0;
};

using ScriptStrokeLinkPtr = std::shared_ptr<ScriptStrokeLink>;

} // namespace crowd::app
