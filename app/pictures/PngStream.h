// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include <glm/vec2.hpp>

#include "app/pictures/PictureFormats.h"
#include "model/base/Result.h"

namespace crowd::app {

/// What the samples of a PNG are.
struct PngLayout
{
    glm::ivec2 size{0};
    int channels = 3;         ///< 1: gray, 3: red, green and blue, 4: and alpha
    int bits = 8;             ///< of a sample: 8 or 16
    bool skipsFourth = false; ///< rows of three channels come with a fourth that says nothing
};

/// Makes a PNG's bytes row by row, so that pictures of any size take no memory; by the PNG library,
/// since Qt's encoder wants them whole. Messages as of PictureEncoder.
class PngStream
{
public:
    PngStream(const PngLayout& layout, ByteSink sink);
    ~PngStream();
    PngStream(const PngStream&) = delete;
    PngStream& operator=(const PngStream&) = delete;

    /// Samples of one row; those of 16 bits as this machine has them.
    [[nodiscard]] model::Result<void> add(std::span<const std::uint8_t> row);
    [[nodiscard]] model::Result<void> add(std::span<const std::uint16_t> row);
    /// After the last row.
    [[nodiscard]] model::Result<void> finish();

private:
    struct Private;
    std::unique_ptr<Private> m_private;
};

} // namespace crowd::app
