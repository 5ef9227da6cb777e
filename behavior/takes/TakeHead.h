// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <QtCore/QByteArray>

#include "behavior/session/SessionPose.h"

namespace crowd::behavior {

/// What a take's file says of its steps beside their columns. As bytes, what many steps share is
/// there once.
struct TakeHead
{
    struct Frame
    {
        SessionPosePtr rest;     ///< all of it but the columns
        std::uint64_t begin = 0; ///< in the piece
        std::uint64_t size = 0;  ///< bytes
        bool isDifference = false;
    };
    struct Piece
    {
        std::uint64_t offset = 0; ///< in the file
        std::uint64_t size = 0;
        std::uint64_t checksum = 0;
        std::vector<Frame> frames;
    };
    std::vector<Piece> pieces;
};

[[nodiscard]] QByteArray takeHeadBytes(const TakeHead& head);
/// Nothing: damaged, or of no sense. Frames lie within their pieces and come in order.
[[nodiscard]] std::optional<TakeHead> takeHeadOf(const QByteArray& bytes);

} // namespace crowd::behavior
