// SPDX-License-Identifier: MIT
#include "app/pictures/PictureFile.h"

#include <algorithm>
#include <string>

#include <QtCore/QByteArray>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtGui/QImageReader>

namespace crowd::app {

namespace {

bool hasEnd(const QString& path, std::string_view end)
{
    const auto size = static_cast<qsizetype>(end.size());
    QFile file(path);
    return file.open(QIODevice::ReadOnly) && file.size() > size && file.seek(file.size() - size) &&
           file.readAll() == QByteArray(end.data(), size);
}

} // namespace

model::Error pictureNotMade(const QString& path, const model::Error& error)
{
    return {QT_TRANSLATE_NOOP(
                "Messages",
                "%1: the picture could not be made: %2. Try a smaller size, or another ending."),
            path.toStdString(), error.said};
}

model::Error pictureNotWritten(const QString& path, const model::Error& error)
{
    return {QT_TRANSLATE_NOOP("Messages", "%1 cannot be written: %2. Check the folder, its rights "
                                          "and the space on the disk."),
            path.toStdString(), error.said};
}

model::Result<void> roomForPicture(const QString& path, const PictureShape& shape)
{
    const PictureFormat* format = pictureFormatOf(path);
    if (format == nullptr) {
        return model::Error{
            QT_TRANSLATE_NOOP(
                "Messages",
                "%1: let the name end in one of %2; it says what the picture is written as."),
            path.toStdString(), pictureEndings()};
    }
    const std::string name(format->name);
    if (shape.isTransparent && !format->hasTransparency) {
        return model::Error{QT_TRANSLATE_NOOP("Messages",
                                              "%1: a %2 file cannot be transparent. Let the name "
                                              "end in .png, or switch the transparency off."),
                            path.toStdString(), name};
    }
    const int longest = std::max(shape.size.x, shape.size.y);
    if (longest > kMostPixelsASide) {
        return model::Error{QT_TRANSLATE_NOOP("Messages",
                                              "%1: a picture has at most %2 pixels a side, not %3. "
                                              "Choose a smaller size."),
                            path.toStdString(), kMostPixelsASide, longest};
    }
    if (longest > format->mostPixelsASide) {
        return model::Error{
            QT_TRANSLATE_NOOP("Messages", "%1: a %2 file has at most %3 pixels a side, not %4. Let "
                                          "the name end in .png, or choose a smaller size."),
            path.toStdString(), name, format->mostPixelsASide, longest};
    }
    return {};
}

model::Result<std::unique_ptr<PictureFile>> PictureFile::begin(const QString& path,
                                                               const PictureShape& shape)
{
    if (auto room = roomForPicture(path, shape); !room) {
        return room.error();
    }
    std::unique_ptr<PictureFile> picture(new PictureFile(path));
    auto file = model::WholeFile::begin(path);
    if (!file) {
        return pictureNotWritten(path, file.error());
    }
    picture->m_file.emplace(std::move(file).value());
    picture->m_encoder = pictureFormatOf(path)->encoder(
        shape, [file = picture.get()](std::string_view bytes) { return file->take(bytes); });
    return picture;
}

model::Result<void> PictureFile::add(std::span<const std::uint8_t> rows)
{
    return said(m_encoder->add(rows));
}

model::Result<void> PictureFile::finish()
{
    if (auto encoded = said(m_encoder->finish()); !encoded) {
        return encoded;
    }
    const auto kept = m_file->commit();
    return kept ? kept : pictureNotWritten(m_path, kept.error());
}

model::Result<void> PictureFile::take(std::string_view bytes)
{
    auto written = m_file->write(bytes);
    if (!written) {
        m_diskError = written.error();
    }
    return written;
}

model::Result<void> PictureFile::said(const model::Result<void>& done) const
{
    if (done) {
        return done;
    }
    return m_diskError ? pictureNotWritten(m_path, *m_diskError)
                       : pictureNotMade(m_path, done.error());
}

model::Result<void> writePicture(const QString& path, std::span<const std::uint8_t> rgba,
                                 glm::ivec2 size, bool isTransparent)
{
    const auto file = PictureFile::begin(path, {size, isTransparent});
    if (!file) {
        return file.error();
    }
    auto added = file.value()->add(rgba);
    return added ? file.value()->finish() : added;
}

bool isPictureThere(const QString& path, glm::ivec2 size)
{
    const PictureFormat* format = pictureFormatOf(path);
    if (format == nullptr || !QFileInfo::exists(path)) {
        return false;
    }
    if (format->passes == PassRoom::Layers) {
        return isWholeExr(path, size);
    }
    QImageReader reader(path);
    if (reader.size() != QSize(size.x, size.y)) {
        return false;
    }
    if (!format->end.empty()) {
        return hasEnd(path, format->end);
    }
    constexpr std::int64_t kMostRead = 1 << 24; // reading a large one takes longer than drawing it
    return static_cast<std::int64_t>(size.x) * size.y > kMostRead || !reader.read().isNull();
}

model::Result<void> writeLayers(const QString& path, const ExrHeader& header,
                                std::span<const ExrLayer> layers)
{
    const auto encoded = encodeExr(header, layers);
    if (!encoded) {
        return pictureNotMade(path, encoded.error());
    }
    const QByteArray& bytes = encoded.value();
    const auto written =
        model::writeWholeFile(path, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
    return written ? written : pictureNotWritten(path, written.error());
}

} // namespace crowd::app
