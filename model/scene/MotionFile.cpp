// SPDX-License-Identifier: MIT
#include "model/scene/MotionFile.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

#include <QtCore/QFile>
#include <QtCore/QFileInfo>

namespace crowd::model {

namespace {

Error cutOff(const QString& path)
{
    return Error{QT_TRANSLATE_NOOP("Messages", "%1: is cut off. Keep the take once more, or fetch "
                                               "the file from a copy."),
                 path.toStdString()};
}

} // namespace

MotionFile::MotionFile(QString path, int file, std::uint64_t size)
    : m_path(std::move(path)), m_file(file), m_size(size)
{
}

MotionFile::~MotionFile()
{
    ::close(m_file);
}

Result<MotionFilePtr> MotionFile::open(const QString& path)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    const int file = ::open(QFile::encodeName(absolute).constData(),
                            O_RDONLY | O_CLOEXEC | O_NONBLOCK); // a pipe must not hold us up
    struct stat state
    {
    };
    if (file < 0 || ::fstat(file, &state) != 0) {
        const Error error{
            QT_TRANSLATE_NOOP("Messages",
                              "%1: could not be opened (%2). Check its name and that you may read "
                              "it."),
            path.toStdString(), std::strerror(errno)};
        if (file >= 0) {
            ::close(file);
        }
        return error;
    }
    if (!S_ISREG(state.st_mode)) {
        ::close(file);
        return Error{QT_TRANSLATE_NOOP("Messages", "%1: is not a file; choose a .take file."),
                     path.toStdString()};
    }
    return MotionFilePtr(new MotionFile(absolute, file, static_cast<std::uint64_t>(state.st_size)));
}

Result<std::vector<std::byte>> MotionFile::read(std::uint64_t offset, std::uint64_t size) const
{
    // No memory is taken for more than there is.
    if (offset > m_size || size > m_size - offset) {
        return cutOff(m_path);
    }
    std::vector<std::byte> bytes(static_cast<std::size_t>(size));
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t read =
            ::pread(m_file, &bytes[done], bytes.size() - done, static_cast<off_t>(offset + done));
        if (read < 0 && errno == EINTR) {
            continue;
        }
        if (read == 0) { // it has become shorter since
            return cutOff(m_path);
        }
        if (read < 0) {
            return Error{QT_TRANSLATE_NOOP("Messages", "%1: could not be read to its end (%2)."),
                         m_path.toStdString(), std::strerror(errno)};
        }
        done += static_cast<std::size_t>(read);
    }
    return bytes;
}

} // namespace crowd::model
