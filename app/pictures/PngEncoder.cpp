// SPDX-License-Identifier: MIT
#include "app/pictures/PngEncoder.h"

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <png.h>

#include "app/pictures/StraightAlpha.h"

namespace crowd::app {

namespace {

/// How the library leaves its functions when something is wrong.
class PngProblem : public std::runtime_error
{
    using std::runtime_error::runtime_error;
};

[[noreturn]] void refuse(png_structp /*png*/, png_const_charp why)
{
    throw PngProblem(why);
}

void ignore(png_structp /*png*/, png_const_charp /*warning*/) {}

class PngEncoder : public PictureEncoder
{
public:
    PngEncoder(const PictureShape& shape, ByteSink sink) : m_shape(shape), m_sink(std::move(sink))
    {
    }
    ~PngEncoder() override { png_destroy_write_struct(&m_png, &m_info); }
    PngEncoder(const PngEncoder&) = delete;
    PngEncoder& operator=(const PngEncoder&) = delete;

    model::Result<void> add(std::span<const std::uint8_t> rows) override
    {
        return guarded([&] {
            if (m_png == nullptr) {
                begin();
            }
            const auto bytes = static_cast<std::size_t>(m_shape.size.x) * 4;
            for (std::size_t at = 0; at + bytes <= rows.size(); at += bytes) {
                writeRow(rows.subspan(at, bytes));
            }
        });
    }

    model::Result<void> finish() override
    {
        return guarded([&] { png_write_end(m_png, m_info); });
    }

private:
    template<class Work>
    model::Result<void> guarded(const Work& work)
    {
        try {
            work();
        } catch (const PngProblem& problem) {
            return m_sinkError.value_or(model::Error{std::string(problem.what())});
        }
        return {};
    }

    void begin()
    {
        m_png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, &refuse, &ignore);
        if (m_png != nullptr) {
            m_info = png_create_info_struct(m_png);
        }
        if (m_info == nullptr) {
            throw PngProblem("out of memory");
        }
        png_set_write_fn(m_png, this, &PngEncoder::take, nullptr);
        const int kind = m_shape.isTransparent ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB;
        png_set_IHDR(m_png, m_info, static_cast<png_uint_32>(m_shape.size.x),
                     static_cast<png_uint_32>(m_shape.size.y), 8, kind, PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_write_info(m_png, m_info);
        if (!m_shape.isTransparent) {
            png_set_filler(m_png, 0, PNG_FILLER_AFTER); // alpha that says nothing
        }
    }

    void writeRow(std::span<const std::uint8_t> row)
    {
        if (!m_shape.isTransparent) {
            png_write_row(m_png, row.data());
            return;
        }
        m_row.assign(row.begin(), row.end());
        straightenAlpha(m_row);
        png_write_row(m_png, m_row.data());
    }

    static void take(png_structp png, png_bytep data, std::size_t size)
    {
        auto& self = *static_cast<PngEncoder*>(png_get_io_ptr(png));
        const std::string_view bytes(reinterpret_cast<const char*>(data), size);
        if (auto taken = self.m_sink(bytes); !taken) {
            self.m_sinkError = taken.error();
            throw PngProblem("the file");
        }
    }

    PictureShape m_shape;
    ByteSink m_sink;
    std::optional<model::Error> m_sinkError;
    std::vector<std::uint8_t> m_row;
    png_structp m_png = nullptr;
    png_infop m_info = nullptr;
};

} // namespace

std::unique_ptr<PictureEncoder> makePngEncoder(const PictureShape& shape, ByteSink sink)
{
    return std::make_unique<PngEncoder>(shape, std::move(sink));
}

} // namespace crowd::app
