// SPDX-License-Identifier: MIT
#include "app/console/OutputBuffer.h"

#include <utility>

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>

namespace crowd::app {

void OutputBuffer::write(const QString& text, OutputKind kind)
{
    const std::lock_guard lock(m_mutex);
    QString kept = text;
    if (kept.size() > kMost) {
        m_lost += kept.size() - kMost;
        kept = kept.right(kMost);
    }
    if (m_waiting + kept.size() > kMost) {
        m_lost += m_waiting;
        m_waiting = 0;
        m_pieces.clear();
    }
    m_waiting += kept.size();
    if (!m_pieces.empty() && m_pieces.back().kind == kind) {
        m_pieces.back().text += kept;
    } else {
        m_pieces.push_back({kept, kind});
    }
}

std::vector<OutputPiece> OutputBuffer::take()
{
    const std::lock_guard lock(m_mutex);
    std::vector<OutputPiece> pieces = std::exchange(m_pieces, {});
    m_waiting = 0;
    if (m_lost > 0) {
        const QString note = QCoreApplication::translate("crowd::app::ConsoleDock",
                                                         "… %1 characters are left out …\n")
                                 .arg(QLocale().toString(m_lost));
        pieces.insert(pieces.begin(), {note, OutputKind::Error});
        m_lost = 0;
    }
    return pieces;
}

} // namespace crowd::app
