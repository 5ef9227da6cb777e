// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include <QtCore/QObject>
#include <QtCore/QTimer>

#include "widgets/state/EditorState.h"

namespace crowd::app {

/// Keeps the unsaved state of the document on disk, on a timer, so that a crash loses little. What
/// is kept goes when the document is saved, left for good, or back at its saved state.
class Autosaver : public QObject
{
    Q_OBJECT

public:
    Autosaver(widgets::EditorState& state, QObject* parent);

    void setSeconds(int seconds); ///< 0: off
    /// The document was saved or is left for good.
    void forget();
    /// The document came from this file, left by a crash; it is kept on as the document's own.
    void adopt(const QString& recovery);

private:
    void keep();

    widgets::EditorState& m_state;
    QTimer m_timer;
    std::optional<std::uint64_t> m_keptRevision; ///< of the document, when something is kept
    bool m_hasFailed = false;                    ///< said once, not every time
};

} // namespace crowd::app
