// SPDX-License-Identifier: MIT
#include "app/pictures/PngStream.h"

#include <bit>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <png.h>

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

} // namespace

struct PngStream::Private
{
    Private(const PngLayout& of, ByteSink to) : layout(of), sink(std::move(to)) {}
    ~Private() { png_destroy_write_struct(&png, &info); }
    Private(const Private&) = delete;
    Private& operator=(const Private&) = delete;

    template<class Work>
    model::Result<void> guarded(const Work& work)
    {
        try {
            if (png == nullptr) {
                begin();
            }
            work();
        } catch (const PngProblem& problem) {
            return sinkError.value_or(model::Error{std::string(problem.what())});
        }
        return {};
    }
    void begin();
    [[nodiscard]] int colorType() const
    {
        return layout.channels == 1   ? PNG_COLOR_TYPE_GRAY
               : layout.channels == 3 ? PNG_COLOR_TYPE_RGB
                                      : PNG_COLOR_TYPE_RGB_ALPHA;
    }
    static void take(png_structp png, png_bytep data, std::size_t size);

    PngLayout layout;
    ByteSink sink;
    std::optional<model::Error> sinkError;
    png_structp png = nullptr;
    png_infop info = nullptr;
};

void PngStream::Private::begin()
{
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, &refuse, &ignore);
    if (png != nullptr) {
        info = png_create_info_struct(png);
    }
    if (info == nullptr) {
        throw PngProblem("out of memory");
    }
    png_set_write_fn(png, this, &Private::take, nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(layout.size.x),
                 static_cast<png_uint_32>(layout.size.y), layout.bits, colorType(),
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    if (layout.skipsFourth) {
        png_set_filler(png, 0, PNG_FILLER_AFTER);
    }
    if (layout.bits == 16 && std::endian::native == std::endian::little) {
        png_set_swap(png);
    }
}

void PngStream::Private::take(png_structp png, png_bytep data, std::size_t size)
{
    auto& self = *static_cast<Private*>(png_get_io_ptr(png));
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    if (auto taken = self.sink(bytes); !taken) {
        self.sinkError = taken.error();
        throw PngProblem("the file");
    }
}

PngStream::PngStream(const PngLayout& layout, ByteSink sink)
    : m_private(std::make_unique<Private>(layout, std::move(sink)))
{
}

PngStream::~PngStream() = default;

model::Result<void> PngStream::add(std::span<const std::uint8_t> row)
{
    return m_private->guarded([&] { png_write_row(m_private->png, row.data()); });
}

model::Result<void> PngStream::add(std::span<const std::uint16_t> row)
{
    return m_private->guarded(
        [&] { png_write_row(m_private->png, reinterpret_cast<png_const_bytep>(row.data())); });
}

model::Result<void> PngStream::finish()
{
    return m_private->guarded([&] { png_write_end(m_private->png, m_private->info); });
}

} // namespace crowd::app
