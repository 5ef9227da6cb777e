// SPDX-License-Identifier: MIT
#include "app/pictures/PngEncoder.h"

#include <cstddef>
#include <utility>
#include <vector>

#include "app/pictures/PngStream.h"
#include "app/pictures/StraightAlpha.h"

namespace crowd::app {

namespace {

class PngEncoder : public PictureEncoder
{
public:
    PngEncoder(const PictureShape& shape, ByteSink sink)
        : m_shape(shape),
          m_stream({shape.size, shape.isTransparent ? 4 : 3, 8, !shape.isTransparent},
                   std::move(sink))
    {
    }

    model::Result<void> add(std::span<const std::uint8_t> rows) override
    {
        const auto bytes = static_cast<std::size_t>(m_shape.size.x) * 4;
        model::Result<void> added;
        for (std::size_t at = 0; at + bytes <= rows.size() && added; at += bytes) {
            added = addRow(rows.subspan(at, bytes));
        }
        return added;
    }
    model::Result<void> finish() override { return m_stream.finish(); }

private:
    model::Result<void> addRow(std::span<const std::uint8_t> row)
    {
        if (!m_shape.isTransparent) {
            return m_stream.add(row);
        }
        m_row.assign(row.begin(), row.end());
        straightenAlpha(m_row);
        return m_stream.add(std::span<const std::uint8_t>(m_row));
    }

    PictureShape m_shape;
    PngStream m_stream;
    std::vector<std::uint8_t> m_row;
};

} // namespace

std::unique_ptr<PictureEncoder> makePngEncoder(const PictureShape& shape, ByteSink sink)
{
    return std::make_unique<PngEncoder>(shape, std::move(sink));
}

} // namespace crowd::app
