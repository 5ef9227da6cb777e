// SPDX-License-Identifier: MIT
#include "model/gltf/GltfContainer.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <string_view>

#include <QtCore/QByteArray>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QString>

#include "model/gltf/GltfLimits.h"
#include "model/gltf/GltfText.h"

namespace crowd::model::gltf {

namespace {

constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;

std::uint32_t readU32(const Bytes& bytes, std::size_t at)
{
    return static_cast<std::uint32_t>(bytes[at]) | static_cast<std::uint32_t>(bytes[at + 1]) << 8U |
           static_cast<std::uint32_t>(bytes[at + 2]) << 16U |
           static_cast<std::uint32_t>(bytes[at + 3]) << 24U;
}

/// How many bytes of a file its GLB header says are the GLB's.
Result<std::size_t> lengthOfGlb(const Bytes& bytes)
{
    if (bytes.size() < kHeaderBytes + kChunkHeaderBytes) {
        return Error{
            QT_TRANSLATE_NOOP("Messages", "the file ends within the GLB header (%1 bytes)"),
            bytes.size()};
    }
    if (const std::uint32_t version = readU32(bytes, 4); version != 2) {
        return Error{QT_TRANSLATE_NOOP("Messages",
                                       "the GLB header says version %1; only glTF 2.0 can be read"),
                     version};
    }
    const std::size_t length = readU32(bytes, 8);
    if (length > bytes.size()) {
        return Error{
            QT_TRANSLATE_NOOP("Messages", "the GLB header promises %1 bytes, the file has only %2"),
            length, bytes.size()};
    }
    return length;
}

/// Takes in the chunk of the given number at a byte, `left` of them from there on. Returns its size
/// with its header.
Result<std::size_t> takeChunk(Container& container, const Bytes& bytes, std::size_t chunk,
                              std::size_t at, std::size_t left)
{
    const std::size_t size = readU32(bytes, at);
    const std::uint32_t type = readU32(bytes, at + 4);
    if (size > left - kChunkHeaderBytes) {
        return Error{
            QT_TRANSLATE_NOOP("Messages",
                              "GLB chunk %1 at byte %2 is %3 bytes long, but only %4 are left"),
            chunk, at, size, left - kChunkHeaderBytes};
    }
    if ((chunk == 0) != (type == kJsonChunk)) {
        return Error{
            chunk == 0
                ? QT_TRANSLATE_NOOP("Messages", "GLB chunk %1 at byte %2 is not the JSON chunk")
                : QT_TRANSLATE_NOOP("Messages", "GLB chunk %1 at byte %2 is a second JSON chunk"),
            chunk, at};
    }
    const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(at + kChunkHeaderBytes);
    const auto last = first + static_cast<std::ptrdiff_t>(size);
    if (type == kJsonChunk) {
        container.json.assign(first, last);
    } else if (type == kBinaryChunk && !container.hasBinary) {
        container.binary.assign(first, last);
        container.hasBinary = true;
    }
    return kChunkHeaderBytes + size;
}

Result<Container> readGlb(const Bytes& bytes)
{
    const Result<std::size_t> whole = lengthOfGlb(bytes);
    if (!whole) {
        return whole.error();
    }
    const std::size_t length = whole.value();
    Container container;
    if (length < bytes.size()) {
        container.warnings.emplace_back(
            QT_TRANSLATE_NOOP("Messages", "%1 bytes after the end of the GLB are ignored."),
            bytes.size() - length);
    }
    std::size_t at = kHeaderBytes;
    for (std::size_t chunk = 0; at + kChunkHeaderBytes <= length; ++chunk) {
        const Result<std::size_t> size = takeChunk(container, bytes, chunk, at, length - at);
        if (!size) {
            return size.error();
        }
        at += size.value();
    }
    return container;
}

bool startsWith(const Bytes& bytes, std::string_view text)
{
    return bytes.size() >= text.size() && std::memcmp(bytes.data(), text.data(), text.size()) == 0;
}

struct ForeignFormat
{
    std::string_view suffix;
    std::string_view magic; ///< empty: only the suffix tells
    const char* name;       ///< a message
    std::string_view menu;  ///< Blender's menu entry that reads it
};

constexpr ForeignFormat kForeign[] = {
    {".fbx", "Kaydara FBX", QT_TRANSLATE_NOOP("Messages", "an FBX file"), "File > Import > FBX"},
    {".fbx", "; FBX", QT_TRANSLATE_NOOP("Messages", "an FBX file"), "File > Import > FBX"},
    {".obj", "", QT_TRANSLATE_NOOP("Messages", "a Wavefront OBJ file"),
     "File > Import > Wavefront"},
    {".dae", "", QT_TRANSLATE_NOOP("Messages", "a Collada file"), "File > Import > Collada"},
    {".blend", "BLENDER", QT_TRANSLATE_NOOP("Messages", "a Blender file"), "File > Open"},
    {".usdc", "PXR-USDC", QT_TRANSLATE_NOOP("Messages", "a USD file"),
     "File > Import > Universal Scene Description"},
    {".usda", "#usda", QT_TRANSLATE_NOOP("Messages", "a USD file"),
     "File > Import > Universal Scene Description"},
    {".usd", "", QT_TRANSLATE_NOOP("Messages", "a USD file"),
     "File > Import > Universal Scene Description"},
    {".usdz", "", QT_TRANSLATE_NOOP("Messages", "a USD file"),
     "File > Import > Universal Scene Description"},
    {".abc", "Ogawa", QT_TRANSLATE_NOOP("Messages", "an Alembic file"), "File > Import > Alembic"},
    {".stl", "", QT_TRANSLATE_NOOP("Messages", "an STL file"), "File > Import > STL"},
    {".ply", "ply\n", QT_TRANSLATE_NOOP("Messages", "a PLY file"), "File > Import > Stanford"},
    {".bvh", "HIERARCHY", QT_TRANSLATE_NOOP("Messages", "a BVH motion file"),
     "File > Import > Motion Capture"},
    {".x3d", "", QT_TRANSLATE_NOOP("Messages", "an X3D file"), "File > Import > X3D"},
    {".wrl", "#VRML", QT_TRANSLATE_NOOP("Messages", "a VRML file"), "File > Import > X3D"},
    {".3ds", "", QT_TRANSLATE_NOOP("Messages", "a 3DS file"), "File > Import"},
    {".vrm", "", QT_TRANSLATE_NOOP("Messages", "a VRM file of an unknown kind"),
     "File > Import > glTF 2.0"},
};

const ForeignFormat* foreignFormat(const std::string& path, const Bytes& bytes)
{
    std::string lower = path;
    std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    for (const ForeignFormat& format : kForeign) {
        if (lower.ends_with(format.suffix) ||
            (!format.magic.empty() && startsWith(bytes, format.magic))) {
            return &format;
        }
    }
    return nullptr;
}

bool looksLikeJson(const Bytes& bytes)
{
    const std::size_t start = startsWith(bytes, "\xEF\xBB\xBF") ? 3 : 0;
    const auto first = std::find_if(
        bytes.begin() + static_cast<std::ptrdiff_t>(start), bytes.end(), [](std::uint8_t c) {
            return std::string_view(" \t\r\n").find(static_cast<char>(c)) == std::string_view::npos;
        });
    return first != bytes.end() && *first == '{';
}

bool endsWithBase64(std::string_view head)
{
    constexpr std::string_view kMark = ";base64";
    return head.size() >= kMark.size() &&
           std::equal(kMark.begin(), kMark.end(), head.end() - kMark.size(),
                      [](char mark, char c) { return mark == c || mark == (c | 0x20); });
}

/// RFC 2397. In base64 line breaks, the alphabet for URLs and missing padding are fine.
Result<Bytes> decodeDataUri(const std::string& uri)
{
    const std::size_t comma = uri.find(',');
    if (comma == std::string::npos) {
        return Error{QT_TRANSLATE_NOOP("Messages", "the data: URI has no comma")};
    }
    const QByteArray body = QByteArray::fromRawData(uri.data() + comma + 1,
                                                    static_cast<qsizetype>(uri.size() - comma - 1));
    if (!endsWithBase64(std::string_view(uri).substr(0, comma))) {
        const QByteArray plain = QByteArray::fromPercentEncoding(body);
        return Bytes(plain.begin(), plain.end());
    }
    QByteArray encoded = body.contains('%') ? QByteArray::fromPercentEncoding(body) : body;
    encoded.removeIf([](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; });
    const bool isForUrls = encoded.contains('-') || encoded.contains('_');
    const auto decoded = QByteArray::fromBase64Encoding(
        encoded, QByteArray::AbortOnBase64DecodingErrors |
                     (isForUrls ? QByteArray::Base64UrlEncoding : QByteArray::Base64Encoding));
    if (!decoded) {
        return Error{QT_TRANSLATE_NOOP("Messages", "the data: URI is not valid base64")};
    }
    return Bytes(decoded.decoded.begin(), decoded.decoded.end());
}

bool isDataUri(const std::string& uri)
{
    constexpr std::string_view kScheme = "data:";
    return uri.size() >= kScheme.size() &&
           std::equal(kScheme.begin(), kScheme.end(), uri.begin(),
                      [](char mark, char c) { return mark == c || mark == (c | 0x20); });
}

/// A scheme as in RFC 3986: letters before a colon. One letter is a Windows drive.
bool hasScheme(const QString& uri)
{
    const qsizetype colon = uri.indexOf(u':');
    return colon > 0 && std::all_of(uri.begin(), uri.begin() + colon, [](QChar c) {
               return c.isLetterOrNumber() || c == u'+' || c == u'-' || c == u'.';
           });
}

/// Also a path from the root of another system's file tree, and one that would be cut off.
bool isNoRelativePath(const QString& path)
{
    return path.isEmpty() || path.startsWith(u'/') || path.startsWith(u'\\') ||
           path.contains(QChar(u'\0'));
}

} // namespace

Result<Bytes> readFile(const std::string& path)
{
    QFile file(QString::fromStdString(path));
    if (!QFileInfo(file).isFile()) {
        return Error{QFileInfo::exists(file.fileName())
                         ? QT_TRANSLATE_NOOP("Messages", "it is not a plain file")
                         : QT_TRANSLATE_NOOP("Messages", "there is no such file")};
    }
    if (static_cast<std::uint64_t>(file.size()) > kMaxFileBytes) {
        return Error{QT_TRANSLATE_NOOP("Messages", "it is larger than 1 GiB")};
    }
    if (!file.open(QIODevice::ReadOnly)) {
        return Error{QT_TRANSLATE_NOOP("Messages", "it cannot be opened: %1"),
                     file.errorString().toStdString()};
    }
    Bytes bytes(static_cast<std::size_t>(file.size()));
    const qint64 got = file.read(reinterpret_cast<char*>(bytes.data()), file.size());
    if (got != file.size()) {
        return Error{QT_TRANSLATE_NOOP("Messages", "it cannot be read to its end: %1"),
                     file.errorString().toStdString()};
    }
    return bytes;
}

Result<Container> readContainer(const std::string& path)
{
    Result<Bytes> file = readFile(path);
    if (!file) {
        return file.error();
    }
    const Bytes& bytes = file.value();
    if (bytes.empty()) {
        return Error{QT_TRANSLATE_NOOP("Messages", "the file is empty")};
    }
    if (startsWith(bytes, "glTF")) {
        return readGlb(bytes);
    }
    if (const ForeignFormat* format = foreignFormat(path, bytes)) {
        return Error{QT_TRANSLATE_NOOP("Messages",
                                       "this is %1, which Crowdbrush does not read. Convert it "
                                       "in Blender: %2, then File > Export > glTF 2.0 (.glb)"),
                     Message(format->name), format->menu};
    }
    if (!looksLikeJson(bytes)) {
        return Error{QT_TRANSLATE_NOOP(
            "Messages", "this is neither a .glb (it does not begin with \"glTF\") nor a .gltf "
                        "(it does not begin with \"{\")")};
    }
    Container container;
    container.json.assign(bytes.begin(), bytes.end());
    return container;
}

Result<Bytes> readUri(const std::string& uri, const std::string& folder)
{
    if (isDataUri(uri)) {
        return decodeDataUri(uri);
    }
    const QString raw = QString::fromStdString(uri);
    const QString decoded =
        QString::fromUtf8(QByteArray::fromPercentEncoding(QByteArray::fromStdString(uri)));
    if (hasScheme(raw) || isNoRelativePath(decoded) || isNoRelativePath(raw)) {
        return Error{QT_TRANSLATE_NOOP("Messages", "\"%1\" is not a path that begins at the file"),
                     shortened(uri, 200)};
    }
    const QString base = QString::fromStdString(folder) + u'/';
    // Some exporters write file names with a literal per cent sign, unescaped.
    const QString path = !QFileInfo(base + decoded).isFile() && QFileInfo(base + raw).isFile()
                             ? base + raw
                             : base + decoded;
    Result<Bytes> bytes = readFile(path.toStdString());
    if (!bytes) {
        return Error{QT_TRANSLATE_NOOP("Messages", "\"%1\": %2"), shortened(uri, 200),
                     bytes.error().said};
    }
    return bytes;
}

} // namespace crowd::model::gltf
