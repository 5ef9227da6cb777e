// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <mutex>
#include <vector>

#include <QtCore/QString>

namespace crowd::app {

enum class OutputKind : std::uint8_t { Text, Error };

struct OutputPiece
{
    QString text;
    OutputKind kind = OutputKind::Text;
};

/// What a script prints, on its way to the screen. Bounded: of a flood only the last part is kept,
/// with a line that says how much is missing, so that printing a gigabyte costs neither memory nor
/// the window its life. Thread-safe.
class OutputBuffer
{
public:
    /// Characters that wait at most.
    static constexpr qsizetype kMost = 200'000;

    void write(const QString& text, OutputKind kind);
    /// Everything that came since the last call, oldest first.
    [[nodiscard]] std::vector<OutputPiece> take();

private:
    std::mutex m_mutex;
    std::vector<OutputPiece> m_pieces;
    qsizetype m_waiting = 0;
    qint64 m_lost = 0;
};

} // namespace crowd::app
